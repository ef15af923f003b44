//! A closed sphere of 20,480 triangles: a ray from inside that leaves it has found a leak.

use std::collections::HashMap;

use glam::Vec3;
use raystep_accel::{Mesh, Prims};

use super::scenes::Case;

/// The sphere at the origin, and the one far from it.
pub const NAMES: [&str; 2] = ["trial:closed-sphere", "trial:closed-sphere-far"];

/// How far the second one lies from the origin on every axis: its corners are rounded to 64ths there.
pub const FAR: f32 = 1.5e5;

/// The icosahedron is divided so many times.
const LEVELS: u32 = 5;

/// One of [`NAMES`].
pub(super) fn named(name: &str) -> Option<Case> {
    let offset = [0.0, FAR][NAMES.iter().position(|own| *own == name)?];
    let mut mesh = icosphere(LEVELS);
    for corner in &mut mesh.corners {
        *corner += offset;
    }
    Some(Case { name: name.to_owned(), prims: Prims::Mesh(mesh), flat: false })
}

/// An icosahedron whose triangles are divided into four, `levels` times, with all corners on the unit
/// sphere: 20·4ˡ triangles. Neighbours share their corners bit for bit.
pub fn icosphere(levels: u32) -> Mesh {
    let mut mesh = icosahedron();
    for _ in 0..levels {
        let mut middles = HashMap::new();
        let corners = &mut mesh.corners;
        let mut middle = |a: u32, b: u32| {
            *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                let p = (corners[a as usize] + corners[b as usize]).normalize();
                corners.push(p);
                corners.len() as u32 - 1
            })
        };
        let divided = mesh.triangles.iter().flat_map(|&[a, b, c]| {
            let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
            [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
        });
        mesh.triangles = divided.collect();
    }
    mesh
}

/// Three golden rectangles across each other hold its twelve corners.
fn icosahedron() -> Mesh {
    const GOLDEN: f32 = 1.618_034;
    let corners = Vec3::AXES.into_iter().enumerate().flat_map(|(i, axis)| {
        let next = Vec3::AXES[(i + 1) % 3];
        [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)].map(|(s, t)| (axis * s + next * (t * GOLDEN)).normalize())
    });
    let corners: Vec<Vec3> = corners.collect();
    // Its triangles are the triples of corners that are all one edge apart.
    let edge = corners[0].distance(corners[1]) * 1.01;
    let near = |a: usize, b: usize| corners[a].distance(corners[b]) < edge;
    let mut triangles = Vec::new();
    for a in 0..12 {
        for b in (a + 1..12).filter(|&b| near(a, b)) {
            triangles.extend((b + 1..12).filter(|&c| near(a, c) && near(b, c)).map(|c| [a as u32, b as u32, c as u32]));
        }
    }
    Mesh { corners, triangles }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_closed() {
        let mesh = icosphere(LEVELS);
        assert_eq!(mesh.triangles.len(), 20_480);
        let mut uses: HashMap<(u32, u32), u32> = HashMap::new();
        for &[a, b, c] in &mesh.triangles {
            for (p, q) in [(a, b), (b, c), (c, a)] {
                *uses.entry((p.min(q), p.max(q))).or_default() += 1;
            }
        }
        assert!(uses.values().all(|&n| n == 2));
    }
}
