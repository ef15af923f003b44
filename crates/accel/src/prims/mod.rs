//! The primitives that structures are built over, and the best hit among them.

mod best;
mod mesh;

pub use best::{Best, Hit, Want, test};
pub use mesh::Mesh;

use crate::{Aabb, Axis, Observer, PrimId, Ray, Shape, Visit};

/// The primitives that a structure is built over and a ray is tested against.
///
/// Every structure calls the same routines, so a disagreement can only be a culling error.
pub trait Primitives {
    /// How many there are; ids run from 0.
    fn len(&self) -> usize;

    /// The primitive itself. `prim` must be below [`len`](Primitives::len).
    fn shape(&self, prim: PrimId) -> Shape<'_>;

    /// Whether there are none.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The smallest box around a primitive.
    fn bounds(&self, prim: PrimId) -> Aabb {
        self.shape(prim).bounds()
    }

    /// The t of the first meeting within the ray's range.
    #[inline]
    fn intersect(&self, prim: PrimId, ray: &Ray) -> Option<f32> {
        self.shape(prim).intersect(ray)
    }

    /// Whether the primitive and the box share a point. May rarely say yes for a near miss.
    fn overlaps(&self, prim: PrimId, bounds: &Aabb) -> bool {
        self.shape(prim).overlaps(bounds)
    }

    /// A small box around the part of the primitive that lies in `bounds`; empty if there is none.
    fn clip(&self, prim: PrimId, bounds: &Aabb) -> Aabb {
        self.shape(prim).clip(bounds)
    }

    /// The same for two parts at once: of what lies in `bounds`, that below `high` and that above `low`.
    fn clip_twice(&self, prim: PrimId, bounds: &Aabb, axis: Axis, [high, low]: [f32; 2]) -> [Aabb; 2] {
        self.shape(prim).clip_twice(bounds, axis, [high, low])
    }

    /// Tests a primitive and keeps the hit if it is better.
    #[inline]
    fn test(&self, prim: PrimId, ray: &Ray, best: &mut Best, watch: &mut impl Observer<Visit>) {
        let found = self.intersect(prim, ray);
        watch.on(Visit::Test { prim, t: found.unwrap_or(f32::INFINITY), hit: found.is_some() });
        if let Some(t) = found {
            best.offer(Hit { t, prim, inner: None }, watch);
        }
    }
}

impl<P: Primitives + ?Sized> Primitives for &P {
    #[inline]
    fn len(&self) -> usize {
        (**self).len()
    }

    #[inline]
    fn shape(&self, prim: PrimId) -> Shape<'_> {
        (**self).shape(prim)
    }

    #[inline]
    fn test(&self, prim: PrimId, ray: &Ray, best: &mut Best, watch: &mut impl Observer<Visit>) {
        (**self).test(prim, ray, best, watch);
    }
}

impl Primitives for [Shape<'_>] {
    #[inline]
    fn len(&self) -> usize {
        <[Shape<'_>]>::len(self)
    }

    #[inline]
    fn shape(&self, prim: PrimId) -> Shape<'_> {
        self[prim.index()]
    }
}
