//! A point and an axis-aligned box: three coordinates between three pairs of limits.

use glam::Vec3;

use super::{Part, Probe};
use crate::{Aabb, Axis, Observer};

impl Aabb {
    /// Whether the point lies in it, faces included.
    #[inline]
    pub fn holds(&self, p: Vec3, watch: &mut impl Observer<Probe>) -> bool {
        Axis::ALL.iter().all(|&axis| {
            let (value, low, high) = (p[axis], self.min[axis], self.max[axis]);
            let inside = low <= value && value <= high;
            watch.on(Probe::Compare { of: Part::along(axis), value, low, high, inside });
            inside
        })
    }

    /// Whether `p` lies in it, faces included.
    #[inline]
    pub fn contains(&self, p: Vec3) -> bool {
        self.holds(p, &mut ())
    }

    /// Whether all of `other` lies in it.
    #[inline]
    pub fn encloses(&self, other: &Aabb) -> bool {
        other.is_empty() || (self.contains(other.min) && self.contains(other.max))
    }
}
