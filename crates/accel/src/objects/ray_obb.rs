//! A ray and an oriented box, slide 51: the slab test in the box's own frame (Ericson, "Real-Time Collision
//! Detection", section 5.3.3).

use super::Watch;
use crate::slab::Slab;
use crate::{Axis, Direction, Interval, Obb, Observer, Place, Ray, Visit};

impl Obb {
    /// The part of `within` for which the ray lies in it; empty if it misses.
    #[inline]
    pub fn slab(&self, ray: &Ray, within: Interval, place: Place, watch: &mut impl Observer<Visit>) -> Interval {
        let (f, d) = (ray.o.as_dvec3() - self.center.as_dvec3(), ray.d.as_dvec3());
        let mut live = within;
        for axis in Axis::ALL {
            // Across each pair of faces, seen from the middle of the box.
            let across = self.axes[axis.index()].as_dvec3();
            let (o, d) = (across.dot(f) as f32, across.dot(d) as f32);
            let half = self.half[axis];
            live = Slab { across: Direction::Own(axis), o, d, low: -half, high: half }.narrow(live, place, watch);
        }
        live
    }

    /// The two t at which the ray's line enters and leaves it.
    pub(crate) fn crossing(&self, ray: &Ray, watch: &mut impl Watch) -> Option<[f32; 2]> {
        self.slab(ray, Interval::ALL, Place::World, watch).ends()
    }
}
