//! What volumes are fitted to: the corners of shapes, with a radius where a shape is round.

use glam::{DVec3, Vec3};

use super::Shape;

/// A ball of any radius. Every shape lies in the convex hull of the balls at its corners.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    /// Its centre.
    pub at: Vec3,
    /// Its radius, not negative.
    pub radius: f32,
}

/// The tangent of an eighth of a right angle's double: corners of the octagon around a circle of radius one
/// lie at (±1, ±this) and (±this, ±1).
const OCTAGON: f64 = std::f64::consts::SQRT_2 - 1.0;

/// More than single precision loses of a corner, as a part of its coordinates.
const ROUNDING: f32 = 4.0 * f32::EPSILON;

impl Shape<'_> {
    /// Calls `each` with the shape's corners. A sphere is one corner, a circle the octagon around it.
    pub fn corners(&self, mut each: impl FnMut(Corner)) {
        let mut sharp = |at: Vec3| each(Corner { at, radius: 0.0 });
        match self {
            Shape::Triangle(t) => [t.a, t.b, t.c].into_iter().for_each(sharp),
            Shape::Wall(wall) => {
                for end in [wall.from, wall.to] {
                    wall.z.into_iter().for_each(|z| sharp(end.extend(z)));
                }
            }
            Shape::Prism(prism) => {
                for corner in prism.outline {
                    prism.z.into_iter().for_each(|z| sharp(corner.extend(z)));
                }
            }
            Shape::Sphere(sphere) => each(Corner { at: sphere.center, radius: sphere.radius }),
            Shape::Disc(disc) => ring(disc.center, disc.normal, disc.radius, each),
            Shape::Cylinder(cylinder) => {
                let along = cylinder.to - cylinder.from;
                ring(cylinder.from, along, cylinder.radius, &mut each);
                ring(cylinder.to, along, cylinder.radius, each);
            }
            Shape::Cone(cone) => {
                sharp(cone.apex);
                ring(cone.base, cone.base - cone.apex, cone.radius, each);
            }
            Shape::Polygon(polygon) => {
                // Single precision bends it; what is met is the plane through its first corner.
                let normal = polygon.normal().normalize_or_zero();
                let first = polygon.corners.first().map_or(DVec3::ZERO, |first| first.as_dvec3());
                let off = |corner: &Vec3| normal.dot(corner.as_dvec3() - first).abs();
                let radius = 2.0 * polygon.corners.iter().map(off).fold(0.0, f64::max) as f32;
                polygon.corners.iter().for_each(|&at| each(Corner { at, radius }));
            }
            Shape::Box(bounds) => {
                for x in [bounds.min.x, bounds.max.x] {
                    for y in [bounds.min.y, bounds.max.y] {
                        sharp(Vec3::new(x, y, bounds.min.z));
                        sharp(Vec3::new(x, y, bounds.max.z));
                    }
                }
            }
            Shape::Obb(solid) => {
                let radius = (solid.center.abs().max_element() + solid.half.length()) * ROUNDING;
                solid.corners().into_iter().for_each(|at| each(Corner { at, radius }));
            }
        }
    }
}

/// The octagon around a circle.
fn ring(center: Vec3, normal: Vec3, radius: f32, mut each: impl FnMut(Corner)) {
    let (u, v) = normal.as_dvec3().normalize_or(DVec3::X).any_orthonormal_pair();
    // The corners are rounded to single precision; a little ball holds what that loses.
    let lost = (center.abs().max_element() + 2.0 * radius) * ROUNDING;
    for (x, y) in [(1.0, OCTAGON), (OCTAGON, 1.0)] {
        for (x, y) in [(x, y), (-x, y), (x, -y), (-x, -y)] {
            let at = center.as_dvec3() + (u * x + v * y) * f64::from(radius);
            each(Corner { at: at.as_vec3(), radius: lost });
        }
    }
}
