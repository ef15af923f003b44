//! Objects to try each test on: around the origin, a few units large.

use glam::{Vec2, Vec3};

use super::{Body, Frustum, Kind, Pair, Plane};
use crate::{Aabb, Cone, Cylinder, Obb, Polygon, Ray, Shape, Sphere, Triangle};

/// A crown: not convex, so that a line can leave it and come back.
const OUTLINE: [Vec3; 5] = [
    Vec3::new(-1.0, -1.0, 0.0),
    Vec3::new(1.0, -1.0, 0.0),
    Vec3::new(1.0, 1.0, 0.0),
    Vec3::new(0.0, -0.25, 0.0),
    Vec3::new(-1.0, 1.0, 0.0),
];

/// Turned about z so that 3, 4 and 5 make its axes.
const TURNED: [Vec3; 3] = [Vec3::new(0.8, 0.6, 0.0), Vec3::new(-0.6, 0.8, 0.0), Vec3::Z];

/// The second object of a pair.
pub(super) fn body(kind: Kind) -> Body<'static> {
    Body::Shape(match kind {
        Kind::Ray => return Body::Ray(ray()),
        Kind::Point => return Body::Point(Vec3::new(0.5, 0.25, 0.0)),
        Kind::Plane => return Body::Plane(Plane { point: Vec3::new(0.0, -0.25, 0.0), normal: Vec3::Y }),
        Kind::Frustum => return Body::Frustum(frustum()),
        Kind::Sphere => Shape::Sphere(Sphere { center: Vec3::ZERO, radius: 1.0 }),
        Kind::Cylinder => Shape::Cylinder(Cylinder { from: -Vec3::Y, to: Vec3::Y, radius: 1.0 }),
        Kind::Cone => Shape::Cone(Cone { apex: Vec3::Y, base: -Vec3::Y, radius: 1.0 }),
        Kind::Triangle => Shape::Triangle(Triangle {
            a: Vec3::new(-1.0, -1.0, 0.0),
            b: Vec3::new(1.0, -1.0, 0.0),
            c: Vec3::new(0.0, 1.0, 0.5),
        }),
        Kind::Polygon => Shape::Polygon(Polygon { corners: &OUTLINE }),
        Kind::Aabb => Shape::Box(Aabb::new(-Vec3::ONE, Vec3::ONE)),
        Kind::Obb => Shape::Obb(Obb { center: Vec3::ZERO, axes: TURNED, half: Vec3::new(1.5, 0.5, 1.0) }),
    })
}

/// The first object of a pair; one that nearly misses where the second is of the same kind.
pub(super) fn first(pair: &Pair) -> Body<'static> {
    match pair.first {
        Kind::Sphere => Body::Shape(Shape::Sphere(Sphere { center: Vec3::new(1.5, 1.5, 0.0), radius: 1.0 })),
        Kind::Triangle => Body::Shape(Shape::Triangle(Triangle {
            a: Vec3::new(2.5, 0.0, 0.0),
            b: Vec3::new(0.0, 2.5, 0.0),
            c: Vec3::new(2.5, 2.5, 0.0),
        })),
        Kind::Aabb => Body::Shape(Shape::Box(Aabb::new(Vec3::new(0.5, -0.5, -0.5), Vec3::new(2.0, 2.0, 1.5)))),
        Kind::Obb => {
            let axes = [Vec3::new(0.6, 0.0, 0.8), Vec3::new(-0.8, 0.0, 0.6), -Vec3::Y];
            Body::Shape(Shape::Obb(Obb { center: Vec3::new(1.5, -1.0, 0.5), axes, half: Vec3::new(1.0, 0.5, 0.5) }))
        }
        kind => body(kind),
    }
}

/// How far the first object of a pair is moved so that the answer is the other one.
pub(super) fn elsewhere(pair: &Pair) -> Vec3 {
    let [x, y, z] = match (pair.first, pair.second) {
        // Rays pass beside, not far.
        (Kind::Ray, Kind::Plane) => [0.0, 1.0, 0.0],
        (Kind::Ray, Kind::Sphere) => [0.0, 1.2, 0.0],
        (Kind::Ray, Kind::Cone) => [0.0, 0.6, 0.5],
        (Kind::Ray, Kind::Polygon) => [0.0, -0.4, 0.0],
        (Kind::Ray, Kind::Triangle) => [0.0, 1.0, 0.0],
        (Kind::Ray, Kind::Cylinder) => [0.0, 0.0, 1.3],
        (Kind::Ray, _) => [0.0, 1.5, 0.0],
        // A corner comes in, or goes out.
        (Kind::Triangle, _) => [-0.5, -0.5, 0.0],
        (Kind::Sphere, _) => [0.4, 0.4, 0.0],
        (Kind::Aabb, _) => [0.2, 0.3, 1.7],
        (Kind::Obb, _) => [0.6, 0.8, -0.4],
        (Kind::Frustum, _) => [4.0, 0.0, 0.0],
        (Kind::Plane, _) => [0.0, 1.5, 0.0],
        (_, Kind::Plane) => [0.0, -1.0, 0.0],
        (_, Kind::Sphere | Kind::Cylinder) => [0.7, 0.0, 0.0],
        (_, Kind::Cone) => [-0.3, 0.0, 0.0],
        (_, Kind::Triangle) => [-0.4, 0.0, 0.0],
        (_, Kind::Polygon) => [-0.5, 0.2, 0.0],
        (_, Kind::Aabb) => [0.0, 0.0, 1.2],
        (_, Kind::Obb) => [0.0, 0.8, 0.0],
        _ => [0.0, 1.0, 0.0],
    };
    Vec3::new(x, y, z)
}

/// It comes from the left and the front, and climbs a little.
fn ray() -> Ray {
    Ray { o: Vec3::new(-3.0, -0.5, 1.5), d: Vec3::new(2.0, 0.25, -1.0), t_min: 0.0, t_max: f32::INFINITY }
}

/// It looks along −z, twice as wide as high.
fn frustum() -> Frustum {
    Frustum::new(Vec3::new(0.0, 0.0, 4.0), -Vec3::Z, Vec3::Y, Vec2::new(0.5, 0.25), [1.0, 8.0])
}
