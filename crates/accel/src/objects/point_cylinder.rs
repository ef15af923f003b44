//! A point and a cylinder: its height along the axis, and its distance from it.

use glam::Vec3;

use super::{Part, Probe};
use crate::{Cylinder, Observer};

impl Cylinder {
    /// Whether the point lies in it.
    pub fn holds(&self, p: Vec3, watch: &mut impl Observer<Probe>) -> bool {
        let axis = self.to.as_dvec3() - self.from.as_dvec3();
        let f = p.as_dvec3() - self.from.as_dvec3();
        // Between the ends.
        let height = f.dot(axis) / axis.length_squared();
        let between = (0.0..=1.0).contains(&height);
        watch.on(Probe::Compare { of: Part::Ends, value: height as f32, low: 0.0, high: 1.0, inside: between });
        if !between {
            return false;
        }
        // Near enough to the axis.
        let (out2, r) = ((f - axis * height).length_squared(), f64::from(self.radius));
        let inside = out2 <= r * r;
        let (value, high) = (out2 as f32, (r * r) as f32);
        watch.on(Probe::Compare { of: Part::Radius, value, low: 0.0, high, inside });
        inside
    }
}
