//! A ray and an oriented box, slide 51: the slab test in the box's own frame (Ericson, "Real-Time Collision
//! Detection", section 5.3.3).

use super::Watch;
use crate::slab::Slab;
use crate::{Axis, Direction, Interval, Obb, Observer, Place, Ray, Visit};

/// A direction shorter than this, 2⁻⁹⁶, is counted in a unit of 2⁻⁶⁴: the smallest numbers of single precision have
/// only a few digits. What is divided by it is counted likewise, so that t stays what it is.
const SHORT: f64 = 1.0 / (1_u128 << 96) as f64;
const UNIT: f64 = 1.0 / (1_u128 << 64) as f64;

impl Obb {
    /// The part of `within` for which the ray lies in it; empty if it misses.
    #[inline]
    pub fn slab(&self, ray: &Ray, within: Interval, place: Place, watch: &mut impl Observer<Visit>) -> Interval {
        let (f, d) = (ray.o.as_dvec3() - self.center.as_dvec3(), ray.d.as_dvec3());
        let mut live = within;
        for axis in Axis::ALL {
            // Across each pair of faces, seen from the middle of the box.
            let across = self.axes[axis.index()].as_dvec3();
            let (o, d, half) = (across.dot(f), across.dot(d), f64::from(self.half[axis]));
            let unit = if d != 0.0 && d.abs() < SHORT { UNIT } else { 1.0 };
            let [o, d, half] = [o, d, half].map(|length| (length / unit) as f32);
            live = Slab { across: Direction::Own(axis), o, d, low: -half, high: half }.narrow(live, place, watch);
        }
        live
    }

    /// The two t at which the ray's line enters and leaves it.
    pub(crate) fn crossing(&self, ray: &Ray, watch: &mut impl Watch) -> Option<[f32; 2]> {
        self.slab(ray, Interval::ALL, Place::World, watch).ends()
    }
}
