//! The Utah teapot from Newell's patches, at any tessellation.

use std::collections::HashMap;

use glam::{DVec3, Vec3};
use raystep_accel::Mesh;

/// 32 patches of 16 point numbers, then the points; see `assets/meshes/README.md`.
const NEWELL: &str = include_str!("../../../assets/meshes/teapot-newell.txt");

/// The most steps along a patch's side. Up to here the integer weights of its Bernstein polynomials are exact.
pub const MOST_STEPS: u32 = 256;

/// A patch: four rows of four control points.
type Patch = [[Vec3; 4]; 4];

/// The teapot with each patch cut into `steps` × `steps` quads of two triangles, z up. Triangles that
/// collapse at the poles of lid and base are left out: 10 steps give 6320.
///
/// Patches that share an edge share its corners bit for bit, so no ray slips through a seam.
///
/// # Panics
/// When `steps` is 0 or above [`MOST_STEPS`].
pub fn teapot(steps: u32) -> Mesh {
    assert!((1..=MOST_STEPS).contains(&steps), "a patch is cut into 1 to {MOST_STEPS} steps");
    let mut mesh = Mesh::default();
    let mut known = HashMap::new();
    for patch in patches() {
        // The patch's grid of corners; equal points are one corner.
        let mut corner = |i: u32, j: u32| {
            let p = point(&patch, i, j, steps);
            *known.entry(p.to_array().map(f32::to_bits)).or_insert_with(|| {
                mesh.corners.push(p);
                mesh.corners.len() as u32 - 1
            })
        };
        for i in 0..steps {
            for j in 0..steps {
                let [a, b, c, d] = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
                for triangle in [[a, b, c], [a, c, d]] {
                    let [p, q, r] = triangle;
                    if p != q && q != r && r != p {
                        mesh.triangles.push(triangle);
                    }
                }
            }
        }
    }
    mesh
}

/// The patch at row parameter `i / steps` and column parameter `j / steps`.
fn point(patch: &Patch, i: u32, j: u32, steps: u32) -> Vec3 {
    curve(&patch.map(|row| curve(&row, j, steps)), i, steps)
}

/// The cubic Bézier curve at `i / steps`.
///
/// The weights are integers and outer and inner points are paired, so that a curve and its reverse give the
/// same bits; ends give back their control point. Both are what makes the seams tight.
fn curve(points: &[Vec3; 4], i: u32, steps: u32) -> Vec3 {
    let (s, r) = (f64::from(i), f64::from(steps - i));
    let [a, b, c, d] = points.map(Vec3::as_dvec3);
    let ends = a * (r * r * r) + d * (s * s * s);
    let middle = b * (3.0 * s * r * r) + c * (3.0 * s * s * r);
    let whole = f64::from(steps);
    let p: DVec3 = (ends + middle) / (whole * whole * whole);
    // Adding zero turns −0 into 0: one corner, not two.
    p.as_vec3() + 0.0
}

/// The patches of the data file.
fn patches() -> Vec<Patch> {
    let mut numbers = NEWELL.split_ascii_whitespace();
    let mut count = || -> usize { read(numbers.next()) };
    let (patch_count, point_count) = (count(), count());
    let indices: Vec<usize> = (0..patch_count * 16).map(|_| count()).collect();
    let mut coordinate = || -> f32 { read(numbers.next()) };
    let points: Vec<Vec3> = (0..point_count).map(|_| Vec3::new(coordinate(), coordinate(), coordinate())).collect();
    let patch = |at: &[usize]| std::array::from_fn(|row| std::array::from_fn(|column| points[at[4 * row + column]]));
    indices.chunks_exact(16).map(patch).collect()
}

fn read<T: std::str::FromStr<Err: std::fmt::Debug>>(word: Option<&str>) -> T {
    word.expect("the shipped data file is complete").parse().expect("the shipped data file holds numbers")
}

#[cfg(test)]
mod tests {
    use std::collections::HashMap;

    use raystep_accel::Primitives;

    use super::*;
    use crate::Scene;

    #[test]
    fn ten_steps_give_the_lectures_count() {
        assert_eq!(patches().len(), 32);
        assert_eq!(teapot(10).len(), 6320);
        assert_eq!(Scene::named("teapot-6321").expect("shipped").prims.len(), 6321);
        assert_eq!(Scene::named("teapot:4x4").expect("shipped").prims.len(), 32 * 2 * 16 - 2 * 4 * 4);
    }

    /// Every edge inside belongs to two triangles. Open are 16 patch sides: the rims of body and lid (4 each), both ends
    /// of the spout and both of the handle (2 each).
    #[test]
    fn seams_are_tight() {
        for steps in [3, 7, 10, 16] {
            let mut uses: HashMap<[u32; 2], u32> = HashMap::new();
            for &[a, b, c] in &teapot(steps).triangles {
                for (p, q) in [(a, b), (b, c), (c, a)] {
                    *uses.entry([p.min(q), p.max(q)]).or_default() += 1;
                }
            }
            let open = uses.values().filter(|&&n| n == 1).count();
            assert_eq!(open, 16 * steps as usize, "at {steps} steps");
            assert!(uses.values().all(|&n| n <= 2), "at {steps} steps");
        }
    }

    #[test]
    fn a_curve_and_its_reverse_agree() {
        let there = [Vec3::new(1.4, 0.0, 2.4), Vec3::new(1.4, -0.784, 2.4), Vec3::new(0.784, -1.4, 2.4), Vec3::Y];
        let back = [there[3], there[2], there[1], there[0]];
        for steps in [1, 7, 10, 256] {
            for i in 0..=steps {
                assert_eq!(curve(&there, i, steps), curve(&back, steps - i, steps));
            }
            assert_eq!(curve(&there, 0, steps), there[0]);
        }
    }
}
