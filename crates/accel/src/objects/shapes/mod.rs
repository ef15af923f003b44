//! The objects themselves, and what is asked of a shape whatever it is.

mod clip;
mod cone;
mod corner;
mod cylinder;
mod disc;
mod frustum;
mod plane;
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
pub use frustum::Frustum;
pub use plane::Plane;
pub use polygon::Polygon;
pub use prism::Prism;
pub use sphere::Sphere;
pub use triangle::Triangle;
pub use wall::Wall;

use super::Watch;
use crate::{Aabb, Axis, Interval, Obb, Place, Ray, slab};

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
            // Of a box that is the test itself, which may be watched.
            if let Shape::Box(bounds) = self {
                bounds.crossing(ray, watch);
            }
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
