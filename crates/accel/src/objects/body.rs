//! Anything that a pair is made of.

use glam::Vec3;

use super::{Cone, Cover, Cylinder, Disc, Frustum, Plane, Probe, Sphere, Triangle, Watch};
use crate::events::words;
use crate::{Aabb, Obb, Observer, Ray, Shape};

words! {
    /// What kind of object it is.
    pub enum Kind {
        /// A ray.
        Ray = "ray",
        /// A point.
        Point = "point",
        /// A plane, and the half space that its normal points to.
        Plane = "plane",
        /// A sphere.
        Sphere = "sphere",
        /// A cylinder.
        Cylinder = "cylinder",
        /// A cone.
        Cone = "cone",
        /// A triangle.
        Triangle = "triangle",
        /// A polygon.
        Polygon = "polygon",
        /// An axis-aligned box.
        Aabb = "box",
        /// An oriented box.
        Obb = "oriented box",
        /// A view frustum.
        Frustum = "frustum",
    }
}

/// An object to test against another one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Body<'a> {
    /// A ray.
    Ray(Ray),
    /// A point.
    Point(Vec3),
    /// A plane.
    Plane(Plane),
    /// A view frustum.
    Frustum(Frustum),
    /// What rays meet in a scene.
    Shape(Shape<'a>),
}

impl<'a> Body<'a> {
    /// The same elsewhere: moved by so much. Of a polygon, whose corners are borrowed, that is nowhere else.
    #[must_use]
    pub fn moved(self, by: Vec3) -> Body<'a> {
        let plane = |plane: Plane| Plane { point: plane.point + by, ..plane };
        match self {
            Body::Ray(ray) => Body::Ray(Ray { o: ray.o + by, ..ray }),
            Body::Point(p) => Body::Point(p + by),
            Body::Plane(own) => Body::Plane(plane(own)),
            Body::Frustum(own) => {
                Body::Frustum(Frustum { planes: own.planes.map(plane), corners: own.corners.map(|corner| corner + by) })
            }
            Body::Shape(shape) => Body::Shape(match shape {
                Shape::Sphere(own) => Shape::Sphere(Sphere { center: own.center + by, ..own }),
                Shape::Disc(own) => Shape::Disc(Disc { center: own.center + by, ..own }),
                Shape::Cylinder(own) => Shape::Cylinder(Cylinder { from: own.from + by, to: own.to + by, ..own }),
                Shape::Cone(own) => Shape::Cone(Cone { apex: own.apex + by, base: own.base + by, ..own }),
                Shape::Triangle(own) => Shape::Triangle(Triangle { a: own.a + by, b: own.b + by, c: own.c + by }),
                Shape::Box(own) => Shape::Box(Aabb { min: own.min + by, max: own.max + by }),
                Shape::Obb(own) => Shape::Obb(Obb { center: own.center + by, ..own }),
                Shape::Wall(_) | Shape::Prism(_) | Shape::Polygon(_) => shape,
            }),
        }
    }

    /// Where it is taken in the hand: a ray at its origin, a plane at its point, any other in its middle.
    pub fn middle(&self) -> Vec3 {
        match self {
            Body::Ray(ray) => ray.o,
            Body::Point(p) => *p,
            Body::Plane(plane) => plane.point,
            Body::Frustum(frustum) => Aabb::around(frustum.corners).center(),
            Body::Shape(Shape::Triangle(own)) => (own.a + own.b + own.c) / 3.0,
            Body::Shape(shape) => shape.bounds().center(),
        }
    }
}

impl Body<'_> {
    /// Which kind it is; nothing for shapes that only flat scenes have.
    pub fn kind(&self) -> Option<Kind> {
        Some(match self {
            Body::Ray(_) => Kind::Ray,
            Body::Point(_) => Kind::Point,
            Body::Plane(_) => Kind::Plane,
            Body::Frustum(_) => Kind::Frustum,
            Body::Shape(Shape::Sphere(_)) => Kind::Sphere,
            Body::Shape(Shape::Cylinder(_)) => Kind::Cylinder,
            Body::Shape(Shape::Cone(_)) => Kind::Cone,
            Body::Shape(Shape::Triangle(_)) => Kind::Triangle,
            Body::Shape(Shape::Polygon(_)) => Kind::Polygon,
            Body::Shape(Shape::Box(_)) => Kind::Aabb,
            Body::Shape(Shape::Obb(_)) => Kind::Obb,
            Body::Shape(Shape::Disc(_) | Shape::Wall(_) | Shape::Prism(_)) => return None,
        })
    }

    /// Whether the two meet, step by step; nothing if no test of [`PAIRS`](super::PAIRS) is about these two,
    /// in this order.
    pub fn meets(&self, other: &Body<'_>, watch: &mut impl Watch) -> Option<bool> {
        if let Body::Ray(ray) = self {
            // A ray answers with its t.
            let t = match other {
                Body::Plane(plane) => plane.meet(ray, watch).filter(|&t| ray.range().contains(t)),
                Body::Shape(shape) => shape.intersect_watched(ray, watch),
                _ => return None,
            };
            watch.on(Probe::Met { t: t.unwrap_or(f32::INFINITY), hit: t.is_some() });
            return Some(t.is_some());
        }
        let touch = match (self, other) {
            (Body::Point(p), _) => other.holds(*p, watch)?,
            (Body::Plane(plane), Body::Shape(Shape::Box(bounds))) => plane.side(bounds, watch) == Cover::Across,
            (Body::Frustum(frustum), Body::Shape(Shape::Box(bounds))) => frustum.sees(bounds, watch) != Cover::Outside,
            (Body::Shape(shape), Body::Shape(other)) => match (shape, other) {
                (Shape::Triangle(triangle), Shape::Box(bounds)) => triangle.overlaps(bounds, watch),
                (Shape::Sphere(sphere), Shape::Box(bounds)) => sphere.overlaps(bounds, watch),
                (Shape::Box(bounds), Shape::Box(other)) => bounds.overlaps(other, watch),
                (Shape::Obb(solid), Shape::Obb(other)) => solid.overlaps(other, watch),
                _ => return None,
            },
            _ => return None,
        };
        watch.on(Probe::Touch { touch });
        Some(touch)
    }

    /// Whether a point lies in it.
    fn holds(&self, p: Vec3, watch: &mut impl Observer<Probe>) -> Option<bool> {
        Some(match self {
            Body::Plane(plane) => plane.holds(p, watch),
            Body::Frustum(frustum) => frustum.holds(p, watch),
            Body::Shape(Shape::Sphere(sphere)) => sphere.holds(p, watch),
            Body::Shape(Shape::Cylinder(cylinder)) => cylinder.holds(p, watch),
            Body::Shape(Shape::Cone(cone)) => cone.holds(p, watch),
            Body::Shape(Shape::Triangle(triangle)) => triangle.holds(p, watch),
            Body::Shape(Shape::Polygon(polygon)) => polygon.holds(p, watch),
            Body::Shape(Shape::Box(bounds)) => bounds.holds(p, watch),
            Body::Shape(Shape::Obb(solid)) => solid.holds(p, watch),
            _ => return None,
        })
    }
}
