//! Solids as flat faces, for drawing.

use glam::{Vec2, Vec3};
use raystep_accel::{Obb, Shape};

/// Corners of a circle seen from the side.
const ROUND: usize = 48;

/// The faces of a cylinder, a cone or a box, each convex; round sides in narrow strips. Nothing for shapes
/// that are no such solid.
pub fn faces(shape: &Shape<'_>) -> Vec<Vec<Vec3>> {
    match shape {
        Shape::Cylinder(cylinder) => {
            let along = cylinder.to - cylinder.from;
            let foot = ring(cylinder.from, along, cylinder.radius);
            let head: Vec<Vec3> = foot.iter().map(|corner| *corner + along).collect();
            let strip = |i: usize| vec![foot[i], foot[(i + 1) % ROUND], head[(i + 1) % ROUND], head[i]];
            let strips: Vec<_> = (0..ROUND).map(strip).collect();
            [vec![foot.clone(), head.clone()], strips].concat()
        }
        Shape::Cone(cone) => {
            let base = ring(cone.base, cone.apex - cone.base, cone.radius);
            let strips: Vec<_> = (0..ROUND).map(|i| vec![base[i], base[(i + 1) % ROUND], cone.apex]).collect();
            [vec![base], strips].concat()
        }
        Shape::Box(bounds) => sides(&Obb::from_aabb(bounds)),
        Shape::Obb(solid) => sides(solid),
        Shape::Triangle(_) | Shape::Sphere(_) | Shape::Disc(_) => Vec::new(),
        Shape::Wall(_) | Shape::Prism(_) | Shape::Polygon(_) => Vec::new(),
    }
}

/// The six sides of a box.
fn sides(solid: &Obb) -> Vec<Vec<Vec3>> {
    // Bit i of a corner's number says which way it lies along axis i.
    const SIDES: [[usize; 4]; 6] = [[0, 2, 6, 4], [1, 3, 7, 5], [0, 1, 5, 4], [2, 3, 7, 6], [0, 1, 3, 2], [4, 5, 7, 6]];
    let corners = solid.corners();
    SIDES.iter().map(|side| side.map(|corner| corners[corner]).to_vec()).collect()
}

/// Corners of a circle around `center`, across `normal`.
pub(crate) fn ring(center: Vec3, normal: Vec3, radius: f32) -> Vec<Vec3> {
    let aside = normal.any_orthogonal_vector().normalize_or_zero() * radius;
    let across = normal.normalize_or_zero().cross(aside);
    let at = |index: usize| {
        let angle = index as f64 / ROUND as f64 * std::f64::consts::TAU;
        let turn = Vec2::new(libm::cos(angle) as f32, libm::sin(angle) as f32);
        center + aside * turn.x + across * turn.y
    };
    (0..ROUND).map(at).collect()
}
