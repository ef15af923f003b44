//! What an object looks like, as forms in space.

use glam::Vec3;
use raystep_accel::{Aabb, Body, Frustum, Obb, Plane, Shape};

use crate::world::{Form, edges, ring};

/// How far a plane is drawn to each side of its point.
const SPREAD: f32 = 1.8;

/// Up to which t a ray is drawn.
pub(super) const SHOWN: f32 = 3.0;

/// The forms of an object.
pub(super) fn forms(body: &Body<'_>) -> Vec<Form> {
    match body {
        Body::Ray(ray) => vec![Form::Arrow(ray.o, ray.at(SHOWN)), Form::Point(ray.o)],
        Body::Point(p) => vec![Form::Point(*p)],
        Body::Plane(plane) => vec![Form::Polygon(sheet(plane))],
        Body::Frustum(frustum) => vec![Form::Body(frame(frustum))],
        Body::Shape(shape) => match shape {
            Shape::Sphere(sphere) => vec![Form::Sphere(*sphere)],
            Shape::Triangle(own) => vec![Form::Polygon(vec![own.a, own.b, own.c])],
            Shape::Polygon(own) => around(own.corners).map(|[from, to]| Form::Segment(from, to)).collect(),
            Shape::Box(bounds) => vec![Form::Body(edges(bounds))],
            Shape::Obb(solid) => vec![Form::Body(sides(solid))],
            Shape::Cylinder(own) => {
                let foot = ring(own.from, own.to - own.from, own.radius);
                let head: Vec<Vec3> = foot.iter().map(|corner| *corner + (own.to - own.from)).collect();
                let upright = foot.iter().zip(&head).step_by(EVERY).map(|(from, to)| [*from, *to]);
                vec![Form::Body(around(&foot).chain(around(&head)).chain(upright).collect())]
            }
            Shape::Cone(own) => {
                let base = ring(own.base, own.apex - own.base, own.radius);
                let upright = base.iter().step_by(EVERY).map(|corner| [*corner, own.apex]);
                vec![Form::Body(around(&base).chain(upright).collect())]
            }
            Shape::Disc(_) | Shape::Wall(_) | Shape::Prism(_) => Vec::new(),
        },
    }
}

/// Of the corners of a round base so many have one line up.
const EVERY: usize = 12;

/// The box around what is drawn of an object.
pub(super) fn bounds(body: &Body<'_>) -> Aabb {
    match body {
        Body::Ray(ray) => Aabb::around([ray.o, ray.at(SHOWN)]),
        Body::Point(p) => Aabb::around([*p]),
        Body::Plane(plane) => Aabb::around(sheet(plane)),
        Body::Frustum(frustum) => Aabb::around(frustum.corners),
        Body::Shape(shape) => shape.bounds(),
    }
}

/// The sides of a closed line through these corners.
pub(super) fn around(corners: &[Vec3]) -> impl Iterator<Item = [Vec3; 2]> + '_ {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(from, to)| [*from, *to])
}

/// A square part of a plane.
fn sheet(plane: &Plane) -> Vec<Vec3> {
    let aside = plane.normal.any_orthogonal_vector().normalize_or_zero() * SPREAD;
    let across = plane.normal.normalize_or_zero().cross(aside);
    [aside + across, aside - across, -aside - across, across - aside].map(|way| plane.point + way).to_vec()
}

/// The edges of an oriented box.
fn sides(solid: &Obb) -> Vec<[Vec3; 2]> {
    let corners = solid.corners();
    let from = (0..8).flat_map(|index: usize| [1, 2, 4].map(|bit| (index, index | bit)));
    from.filter(|(from, to)| from != to).map(|(from, to)| [corners[from], corners[to]]).collect()
}

/// The edges of a frustum.
fn frame(frustum: &Frustum) -> Vec<[Vec3; 2]> {
    let (near, far) = frustum.corners.split_at(4);
    let along = near.iter().zip(far).map(|(near, far)| [*near, *far]);
    around(near).chain(around(far)).chain(along).collect()
}

/// The corners of a side of a frustum, by its place among the planes: left, right, bottom, top, near, far.
pub(super) fn side(frustum: &Frustum, plane: usize) -> Option<Vec<Vec3>> {
    const SIDES: [[usize; 4]; 6] = [[0, 3, 7, 4], [1, 2, 6, 5], [0, 1, 5, 4], [3, 2, 6, 7], [0, 1, 2, 3], [4, 5, 6, 7]];
    Some(SIDES.get(plane)?.map(|corner| frustum.corners[corner]).to_vec())
}
