//! What rays meet.

mod clip;
mod cone;
mod corner;
mod cylinder;
mod disc;
mod mesh;
mod polygon;
mod prism;
mod sphere;
mod triangle;
mod wall;

pub(crate) use clip::clipped;
pub use cone::Cone;
pub use corner::Corner;
pub use cylinder::Cylinder;
pub use disc::Disc;
pub use mesh::Mesh;
pub use polygon::Polygon;
pub use prism::Prism;
pub use sphere::Sphere;
pub use triangle::Triangle;
pub use wall::Wall;

use crate::objects::Watch;
use crate::{Aabb, Axis, Best, Hit, Instances, Interval, Obb, Observer, Place, PrimId, Ray, Visit, slab};

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

/// The part of its t by which a meeting may lie outside its shape's own box.
const SLACK: f32 = 8.0 * f32::EPSILON;

/// One primitive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape<'a> {
    /// A triangle, met from both sides.
    Triangle(Triangle),
    /// A sphere; in a flat scene, a disc of the plane.
    Sphere(Sphere),
    /// A flat round plate in space.
    Disc(Disc),
    /// A segment of the plane, standing upright in a thin z slab.
    Wall(Wall),
    /// A polygon of the plane, standing upright in a thin z slab.
    Prism(Prism<'a>),
    /// A cylinder with flat ends.
    Cylinder(Cylinder),
    /// A cone with a flat base.
    Cone(Cone),
    /// A flat polygon in space.
    Polygon(Polygon<'a>),
    /// An axis-aligned box.
    Box(Aabb),
    /// An oriented box.
    Obb(Obb),
}

impl Shape<'_> {
    /// The smallest box around it.
    pub fn bounds(&self) -> Aabb {
        match self {
            Shape::Triangle(shape) => shape.bounds(),
            Shape::Sphere(shape) => shape.bounds(),
            Shape::Disc(shape) => shape.bounds(),
            Shape::Wall(shape) => shape.bounds(),
            Shape::Prism(shape) => shape.bounds(),
            Shape::Cylinder(shape) => shape.bounds(),
            Shape::Cone(shape) => shape.bounds(),
            Shape::Polygon(shape) => shape.bounds(),
            Shape::Box(bounds) => *bounds,
            Shape::Obb(shape) => shape.bounds(),
        }
    }

    /// A small box around the part of it that lies in `bounds`; empty if there is none.
    pub fn clip(&self, bounds: &Aabb) -> Aabb {
        match self {
            Shape::Triangle(shape) => shape.clip(bounds),
            Shape::Sphere(shape) => shape.clip(bounds),
            Shape::Disc(shape) => shape.clip(bounds),
            Shape::Wall(shape) => shape.clip(bounds),
            Shape::Prism(shape) => shape.clip(bounds),
            Shape::Cylinder(shape) => shape.clip(bounds),
            Shape::Cone(shape) => shape.clip(bounds),
            Shape::Polygon(shape) => shape.clip(bounds),
            Shape::Box(own) => own.intersection(*bounds),
            Shape::Obb(shape) => shape.clip(bounds),
        }
    }

    /// The same for two parts at once: of what lies in `bounds`, that below `high` and that above `low`.
    #[inline]
    pub fn clip_twice(&self, bounds: &Aabb, axis: Axis, [high, low]: [f32; 2]) -> [Aabb; 2] {
        match self {
            Shape::Triangle(shape) => shape.clip_twice(bounds, axis, [high, low]),
            _ => [self.clip(&bounds.cut(axis, high).0), self.clip(&bounds.cut(axis, low).1)],
        }
    }

    /// Whether it and the box share a point. May rarely say yes for a near miss.
    pub fn overlaps(&self, bounds: &Aabb) -> bool {
        match self {
            Shape::Triangle(shape) => shape.overlaps(bounds, &mut ()),
            _ => !self.clip(bounds).is_empty(),
        }
    }

    /// The t of the first meeting within the ray's range.
    ///
    /// A meeting's t is moved into the slab interval of the shape's own box, and a shape whose box is
    /// missed is missed. A box further out has the wider interval ([`slab`] is monotone), so no
    /// structure that culls by boxes can lose the meeting to rounding.
    pub fn intersect(&self, ray: &Ray) -> Option<f32> {
        self.intersect_watched(ray, &mut ())
    }

    /// The same, with what the test computes on the way.
    pub(crate) fn intersect_watched(&self, ray: &Ray, watch: &mut impl Watch) -> Option<f32> {
        let own = slab(&self.bounds(), ray, Interval::ALL, Place::World, &mut ());
        if own.is_empty() {
            return None;
        }
        let accept = |met: f32| {
            // Rounding moves it by no more than this; a meeting further out lies beside the shape.
            let t = own.clamp(met);
            let is_near = (t - met).abs() <= SLACK * met.abs();
            (is_near && met.is_finite() && ray.range().contains(t)).then_some(t)
        };
        match self {
            Shape::Triangle(shape) => shape.meet(ray, watch).and_then(accept),
            Shape::Sphere(shape) => shape.meet(ray, watch).into_iter().flatten().find_map(accept),
            Shape::Disc(shape) => shape.meet(ray, watch).and_then(accept),
            Shape::Wall(shape) => shape.meet(ray).and_then(accept),
            Shape::Prism(shape) => shape.walls().filter_map(|wall| wall.meet(ray).and_then(accept)).reduce(f32::min),
            Shape::Cylinder(shape) => shape.meet(ray, watch).into_iter().flatten().find_map(accept),
            Shape::Cone(shape) => shape.meet(ray, watch).into_iter().flatten().find_map(accept),
            Shape::Polygon(shape) => shape.meet(ray, watch).and_then(accept),
            Shape::Box(bounds) => bounds.crossing(ray, watch).into_iter().flatten().find_map(accept),
            Shape::Obb(shape) => shape.crossing(ray, watch).into_iter().flatten().find_map(accept),
        }
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
