//! The scenes and their cameras, the same from run to run.

use glam::Vec3;
use raystep_accel::{Aabb, Mesh, PrimId, Primitives, Prims, Random};
use raystep_scene::{Scene, View, teapot};

/// A mesh and how it is seen.
pub struct Stage {
    pub name: &'static str,
    pub mesh: Mesh,
    pub view: View,
}

pub const NAMES: [&str; 3] = ["teapot", "million", "stadium"];

/// The scene of a name.
pub fn stage(name: &'static str) -> Stage {
    match name {
        "teapot" => {
            let scene = Scene::named("teapot-6321").expect("it is shipped");
            Stage { name, view: scene.close_view(), mesh: triangles(scene.prims) }
        }
        "stadium" => {
            let scene = Scene::named("stadium").expect("it is shipped");
            Stage { name, view: scene.view, mesh: triangles(scene.prims) }
        }
        _ => million(name),
    }
}

fn triangles(prims: Prims) -> Mesh {
    match prims {
        Prims::Mesh(mesh) => mesh,
        _ => panic!("the scene is a mesh"),
    }
}

pub fn bounds(mesh: &Mesh) -> Aabb {
    (0..mesh.len() as u32).fold(Aabb::EMPTY, |all, prim| all.union(mesh.bounds(PrimId(prim))))
}

/// Quads along a side of the terrain, and teapots on it.
const QUADS: u32 = 600;
const TEAPOTS: u32 = 44;

/// Hills of 720,000 triangles, and 44 teapots of 6320 on them: 998,080.
fn million(name: &'static str) -> Stage {
    let mut mesh = Mesh::default();
    let random = &mut Random::new(7);
    // Heights on ever finer lattices, ever lower.
    let octaves: Vec<(u32, f32, Vec<f32>)> = (0..8)
        .map(|octave| {
            let cells = 3 << octave;
            let height = 0.16 * 0.47f32.powi(octave);
            (cells, height, (0..(cells + 2) * (cells + 2)).map(|_| random.unit()).collect())
        })
        .collect();
    let height = |x: f32, y: f32| -> f32 {
        octaves
            .iter()
            .map(|(cells, height, lattice)| {
                let (x, y) = (x * *cells as f32, y * *cells as f32);
                let (i, j) = (x as u32, y as u32);
                let (s, t) = (x - i as f32, y - j as f32);
                let (s, t) = (s * s * (3.0 - 2.0 * s), t * t * (3.0 - 2.0 * t));
                let at = |i: u32, j: u32| lattice[(j * (cells + 2) + i) as usize];
                let along = |j: u32| at(i, j) * (1.0 - s) + at(i + 1, j) * s;
                (along(j) * (1.0 - t) + along(j + 1) * t) * height
            })
            .sum()
    };
    for j in 0..=QUADS {
        for i in 0..=QUADS {
            let (x, y) = (i as f32 / QUADS as f32, j as f32 / QUADS as f32);
            mesh.corners.push(Vec3::new(x, y, height(x, y)) * 10.0);
        }
    }
    for j in 0..QUADS {
        for i in 0..QUADS {
            let a = j * (QUADS + 1) + i;
            let (b, c, d) = (a + 1, a + QUADS + 2, a + QUADS + 1);
            mesh.triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    let pot = teapot(10);
    for _ in 0..TEAPOTS {
        let (x, y, turn, size) =
            (random.range(0.05, 0.95), random.range(0.05, 0.95), random.unit(), random.range(0.04, 0.12));
        let (sin, cos) = (turn * std::f32::consts::TAU).sin_cos();
        let foot = Vec3::new(x, y, height(x, y)) * 10.0;
        let first = mesh.corners.len() as u32;
        mesh.corners.extend(
            pot.corners.iter().map(|p| foot + Vec3::new(p.x * cos - p.y * sin, p.x * sin + p.y * cos, p.z) * size),
        );
        mesh.triangles.extend(pot.triangles.iter().map(|triangle| triangle.map(|corner| corner + first)));
    }
    let view =
        View { eye: Vec3::new(-1.5, -3.0, 5.0), target: Vec3::new(5.0, 5.0, 0.6), up: Vec3::Z, fov_degrees: 45.0 };
    Stage { name, mesh, view }
}
