//! Primitives as triangles, for looking at.

use std::f32::consts::{PI, TAU};

use glam::{Vec2, Vec3};
use raystep_accel::{Shape, Wall};

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
    }
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
