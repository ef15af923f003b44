//! The axis-aligned box, slide 50: the most common volume.

use super::{Outline, Volume};
use crate::{Aabb, Axes, Cancelled, Fit, Interval, Measure, Observer, Place, PrimId, Primitives, Ray, Visit, slab};

impl Volume for Aabb {
    type Draft = Aabb;

    fn fit<P: Primitives>(
        _: &P,
        _: impl Iterator<Item = PrimId>,
        bounds: &Aabb,
        _: Axes,
        _: &mut impl Observer<Fit>,
    ) -> Result<Aabb, Cancelled> {
        Ok(*bounds)
    }

    #[inline(always)]
    fn meet(&self, ray: &Ray, within: Interval, place: Place, watch: &mut impl Observer<Visit>) -> Interval {
        slab(self, ray, within, place, watch)
    }

    #[inline]
    fn bounds(&self) -> Aabb {
        *self
    }

    fn planes(&self) -> u32 {
        6
    }

    fn outline(&self) -> Outline {
        Outline::Box(*self)
    }

    fn measure(&self, measure: Measure) -> f32 {
        Aabb::measure(self, measure)
    }
}
