//! Primitives as triangles, for looking at.

use std::f32::consts::{PI, TAU};

use glam::{Vec2, Vec3};
use raystep_accel::{Polygon, Shape, Triangle, Wall};
use raystep_figure::faces;

/// Around a circle.
const STEPS: u32 = 48;

/// A primitive's surface.
pub(crate) fn triangles(shape: &Shape<'_>) -> Vec<[Vec3; 3]> {
    match shape {
        Shape::Triangle(triangle) => vec![[triangle.a, triangle.b, triangle.c]],
        Shape::Sphere(sphere) => ball(sphere.center, sphere.radius),
        Shape::Disc(disc) => {
            let (u, v) = disc.normal.any_orthonormal_pair();
            let rim = |i: u32| {
                let p = Vec2::from_angle(TAU * (i % STEPS) as f32 / STEPS as f32) * disc.radius;
                disc.center + u * p.x + v * p.y
            };
            (0..STEPS).map(|i| [disc.center, rim(i), rim(i + 1)]).collect()
        }
        Shape::Wall(wall) => upright(wall).to_vec(),
        Shape::Prism(prism) => prism.walls().flat_map(|wall| upright(&wall)).collect(),
        Shape::Polygon(polygon) => cut_to_triangles(polygon),
        Shape::Cylinder(_) | Shape::Cone(_) | Shape::Box(_) | Shape::Obb(_) => {
            let fan = |face: Vec<Vec3>| (2..face.len()).map(|i| [face[0], face[i - 1], face[i]]).collect::<Vec<_>>();
            faces(shape).into_iter().flat_map(fan).collect()
        }
    }
}

/// The lines that outline a primitive, where it has edges.
pub(crate) fn outline(shape: &Shape<'_>) -> Vec<[Vec3; 2]> {
    match shape {
        Shape::Triangle(triangle) => {
            let [a, b, c] = [triangle.a, triangle.b, triangle.c];
            vec![[a, b], [b, c], [c, a]]
        }
        Shape::Sphere(_) => Vec::new(),
        Shape::Disc(_) => triangles(shape).into_iter().map(|[_, p, q]| [p, q]).collect(),
        Shape::Wall(wall) => edges(wall).to_vec(),
        // Each wall gives its foot, its head and one of its two sides.
        Shape::Prism(prism) => prism.walls().flat_map(|wall| edges(&wall).into_iter().take(3)).collect(),
        Shape::Polygon(polygon) => around(polygon.corners),
        // The strips of a round side have no edges of their own.
        Shape::Cylinder(_) => faces(shape).iter().take(2).flat_map(|rim| around(rim)).collect(),
        Shape::Cone(_) => faces(shape).iter().take(1).flat_map(|rim| around(rim)).collect(),
        Shape::Box(_) | Shape::Obb(_) => faces(shape).iter().flat_map(|side| around(side)).collect(),
    }
}

/// The closed line through some corners.
fn around(corners: &[Vec3]) -> Vec<[Vec3; 2]> {
    corners.iter().copied().zip(corners.iter().copied().cycle().skip(1)).map(|(a, b)| [a, b]).collect()
}

/// A polygon, convex or not, as triangles: one ear is cut off after the other (Meisters 1975).
fn cut_to_triangles(polygon: &Polygon<'_>) -> Vec<[Vec3; 3]> {
    let normal = polygon.normal();
    let mut rest = polygon.corners.to_vec();
    let mut triangles = Vec::new();
    while rest.len() > 2 {
        let n = rest.len();
        let ear = |i: usize| [rest[(i + n - 1) % n], rest[i], rest[(i + 1) % n]];
        // An ear turns the way of the polygon and holds no other corner.
        let is_ear = |&i: &usize| {
            let [a, b, c] = ear(i);
            let turns = (b - a).cross(c - a).as_dvec3().dot(normal) > 0.0;
            let holds = |p: &&Vec3| ![a, b, c].contains(p) && Triangle { a, b, c }.holds(**p, &mut ());
            turns && rest.iter().find(holds).is_none()
        };
        // Rounding may leave no ear where corners lie in a line: any corner will do there.
        let i = (0..n).find(is_ear).unwrap_or(0);
        triangles.push(ear(i));
        rest.remove(i);
    }
    triangles
}

/// Foot, head, and the two upright sides.
fn edges(wall: &Wall) -> [[Vec3; 2]; 4] {
    let [foot, head] = wall.z;
    let (a, b) = (wall.from, wall.to);
    [
        [a.extend(foot), b.extend(foot)],
        [a.extend(head), b.extend(head)],
        [a.extend(foot), a.extend(head)],
        [b.extend(foot), b.extend(head)],
    ]
}

fn upright(wall: &Wall) -> [[Vec3; 3]; 2] {
    let [foot, head] = wall.z;
    let [a, b] = [wall.from.extend(foot), wall.to.extend(foot)];
    let [c, d] = [wall.to.extend(head), wall.from.extend(head)];
    [[a, b, c], [a, c, d]]
}

fn ball(center: Vec3, radius: f32) -> Vec<[Vec3; 3]> {
    let at = |row: u32, column: u32| {
        if row == 0 || row == STEPS / 2 {
            return center + Vec3::Z * if row == 0 { radius } else { -radius };
        }
        let down = Vec2::from_angle(PI * row as f32 / (STEPS / 2) as f32);
        let around = Vec2::from_angle(TAU * (column % STEPS) as f32 / STEPS as f32);
        center + (around * down.y).extend(down.x) * radius
    };
    let quads = (0..STEPS / 2).flat_map(|row| (0..STEPS).map(move |column| (row, column)));
    quads
        .flat_map(|(row, column)| {
            let [a, b, c, d] = [at(row, column), at(row + 1, column), at(row + 1, column + 1), at(row, column + 1)];
            [[a, b, c], [a, c, d]]
        })
        .filter(|[a, b, c]| a != b && b != c && c != a)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_polygon_with_a_notch_is_cut_into_its_own_area() {
        let corners =
            [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [0.0, -0.25], [-1.0, 1.0]].map(|[x, y]| Vec3::new(x, y, 0.5));
        let cut = cut_to_triangles(&Polygon { corners: &corners });
        assert_eq!(cut.len(), 3);
        let area: f32 = cut.iter().map(|[a, b, c]| (*b - *a).cross(*c - *a).z * 0.5).sum();
        // The square less the notch; a triangle over the notch would count against it.
        assert!((area - (4.0 - 1.25)).abs() < 1e-6);
        assert!(cut.iter().all(|[a, b, c]| (*b - *a).cross(*c - *a).z > 0.0));
    }
}
