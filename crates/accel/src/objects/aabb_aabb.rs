//! Two axis-aligned boxes: three comparisons (Ericson, "Real-Time Collision Detection", section 4.2.1).

use super::{Part, Probe};
use crate::{Aabb, Axis, Observer};

impl Aabb {
    /// Whether the two share a point; touching counts.
    #[inline]
    pub fn overlaps(&self, other: &Aabb, watch: &mut impl Observer<Probe>) -> bool {
        // Apart as soon as their shadows on one axis are.
        Axis::ALL.iter().all(|&axis| {
            let (a_low, a_high) = (self.min[axis], self.max[axis]);
            let (b_low, b_high) = (other.min[axis], other.max[axis]);
            let overlap = a_low <= b_high && b_low <= a_high;
            let [x, y, z] = glam::Vec3::AXES[axis.index()].to_array();
            watch.on(Probe::Shadow { of: Part::along(axis), x, y, z, a_low, a_high, b_low, b_high, apart: !overlap });
            overlap
        })
    }

    /// Whether the two share a point; touching counts.
    #[inline]
    pub fn touches(&self, other: &Aabb) -> bool {
        self.overlaps(other, &mut ())
    }
}
