//! A point and a cone: its height below the apex says how far from the axis it may lie.

use glam::Vec3;

use super::{Part, Probe};
use crate::{Cone, Observer};

impl Cone {
    /// Whether the point lies in it.
    pub fn holds(&self, p: Vec3, watch: &mut impl Observer<Probe>) -> bool {
        let axis = self.base.as_dvec3() - self.apex.as_dvec3();
        let f = p.as_dvec3() - self.apex.as_dvec3();
        // Between apex and base.
        let height = f.dot(axis) / axis.length_squared();
        let between = (0.0..=1.0).contains(&height);
        watch.on(Probe::Compare { of: Part::Ends, value: height as f32, low: 0.0, high: 1.0, inside: between });
        if !between {
            return false;
        }
        // The cone is so wide at that height.
        let (out2, r) = ((f - axis * height).length_squared(), f64::from(self.radius) * height);
        let inside = out2 <= r * r;
        let (value, high) = (out2 as f32, (r * r) as f32);
        watch.on(Probe::Compare { of: Part::Radius, value, low: 0.0, high, inside });
        inside
    }
}
