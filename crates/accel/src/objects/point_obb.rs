//! A point and an oriented box: its coordinates in the box's own frame.

use glam::Vec3;

use super::{Part, Probe};
use crate::{Axis, Obb, Observer};

impl Obb {
    /// Whether the point lies in it, faces included.
    pub fn holds(&self, p: Vec3, watch: &mut impl Observer<Probe>) -> bool {
        let f = p.as_dvec3() - self.center.as_dvec3();
        Axis::ALL.iter().all(|&axis| {
            let (value, half) = (self.axes[axis.index()].as_dvec3().dot(f), self.half[axis]);
            let inside = value.abs() <= f64::from(half);
            watch.on(Probe::Compare { of: Part::own(axis), value: value as f32, low: -half, high: half, inside });
            inside
        })
    }
}
