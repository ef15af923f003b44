//! The primitives that structures are built over.

mod mesh;

pub use mesh::Mesh;

use crate::{Aabb, Axis, Best, Hit, Instances, Observer, PrimId, Ray, Shape, Visit};

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

/// The primitives of a scene: triangles in bulk, or a few of any kind.
#[derive(Clone, Debug)]
pub enum Prims {
    /// Triangles only, in plain arrays.
    Mesh(Mesh),
    /// A mixture, for flat scenes and small examples.
    Few(Vec<Shape<'static>>),
    /// Models, each stored once and placed many times.
    Instances(Instances),
}

impl Prims {
    /// The shape that a hit met, world space: for pictures.
    pub fn met(&self, hit: &Hit) -> Shape<'_> {
        match (self, hit.inner) {
            (Prims::Instances(instances), Some(inner)) => Shape::Triangle(instances.triangle(hit.prim, inner)),
            _ => self.shape(hit.prim),
        }
    }
}

impl Primitives for Prims {
    #[inline]
    fn len(&self) -> usize {
        match self {
            Prims::Mesh(mesh) => mesh.len(),
            Prims::Few(shapes) => shapes.len(),
            Prims::Instances(instances) => instances.len(),
        }
    }

    #[inline]
    fn shape(&self, prim: PrimId) -> Shape<'_> {
        match self {
            Prims::Mesh(mesh) => mesh.shape(prim),
            Prims::Few(shapes) => shapes[prim.index()],
            Prims::Instances(instances) => instances.shape(prim),
        }
    }

    #[inline]
    fn intersect(&self, prim: PrimId, ray: &Ray) -> Option<f32> {
        match self {
            Prims::Mesh(mesh) => mesh.intersect(prim, ray),
            Prims::Few(shapes) => shapes.as_slice().intersect(prim, ray),
            Prims::Instances(instances) => instances.intersect(prim, ray),
        }
    }

    #[inline]
    fn test(&self, prim: PrimId, ray: &Ray, best: &mut Best, watch: &mut impl Observer<Visit>) {
        match self {
            Prims::Mesh(mesh) => mesh.test(prim, ray, best, watch),
            Prims::Few(shapes) => shapes.as_slice().test(prim, ray, best, watch),
            Prims::Instances(instances) => instances.test(prim, ray, best, watch),
        }
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
