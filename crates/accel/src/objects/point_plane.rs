//! A point and a plane: the sign of a dot product (Ericson, "Real-Time Collision Detection", section 5.1.1).

use glam::Vec3;

use super::{Part, Plane, Probe};
use crate::Observer;

impl Plane {
    /// Whether the point lies on the side that the normal points to, the plane included.
    pub fn holds(&self, p: Vec3, watch: &mut impl Observer<Probe>) -> bool {
        self.is_before(p, Part::Plane, watch)
    }

    #[inline]
    pub(super) fn is_before(&self, p: Vec3, of: Part, watch: &mut impl Observer<Probe>) -> bool {
        let distance = self.normal.as_dvec3().dot(p.as_dvec3() - self.point.as_dvec3());
        let inside = distance >= 0.0;
        watch.on(Probe::Compare { of, value: distance as f32, low: 0.0, high: f32::INFINITY, inside });
        inside
    }
}
