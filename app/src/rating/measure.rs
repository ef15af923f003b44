//! Building and measuring one structure.

use std::time::Instant;

use glam::Vec2;
use rayon::prelude::*;
use raystep_accel::{Cost, Primitives, Ray, RayError, Rule};
use raystep_figure::Camera;
use raystep_scene::Scene;

use super::candidate::{Built, Candidate};

/// What a structure costs over a scene and some rays.
#[derive(Clone, Debug)]
pub(crate) struct Rated {
    /// What it is.
    pub(crate) what: Candidate,
    /// Rays that were shot: brute force over many primitives is asked by fewer.
    pub(crate) rays: u64,
    /// Tests of primitives, a ray.
    pub(crate) tests: f64,
    /// Nodes or cells entered, a ray.
    pub(crate) visits: f64,
    /// Volumes tested, a ray.
    pub(crate) boxes: f64,
    /// Nodes or cells that there are, where they are counted.
    pub(crate) nodes: Option<u64>,
    /// What it takes in memory.
    pub(crate) bytes: u64,
    /// Milliseconds of its building.
    pub(crate) build_ms: f64,
    /// Microseconds of a ray, on one core and counting nothing.
    pub(crate) ray_us: f64,
}

impl Rated {
    /// Nodes, cells and volumes together, a ray.
    pub(crate) fn steps(&self) -> f64 {
        self.visits + self.boxes
    }

    /// Whether it is no structure at all.
    pub(crate) fn is_list(&self) -> bool {
        is_list(&self.what)
    }
}

fn is_list(what: &Candidate) -> bool {
    matches!(what, Candidate::Textbook(Rule::List))
}

/// The rays through the middles of a picture's pixels.
///
/// # Errors
/// The camera sees nothing.
pub(crate) fn rays(camera: &Camera, [across, down]: [u32; 2]) -> Result<Vec<Ray>, RayError> {
    let size = Vec2::new(across as f32, down as f32);
    let pixels = (0..down).flat_map(|y| (0..across).map(move |x| Vec2::new(x as f32 + 0.5, y as f32 + 0.5)));
    pixels.map(|pixel| camera.ray(pixel, size)).collect()
}

/// No more tests than this are made by brute force.
const MOST_TESTS: f64 = 5e7;
/// Rays are timed for so many seconds, and never more than all of them.
const TIMED: f64 = 0.25;
/// So many are shot between two looks at the clock.
const BETWEEN: usize = 64;

/// Builds a structure and shoots the rays; nothing if `go_on` says so.
pub(crate) fn rate(scene: &Scene, what: Candidate, rays: &[Ray], go_on: &(dyn Fn() -> bool + Sync)) -> Option<Rated> {
    let begun = Instant::now();
    let built = what.build(scene, go_on)?;
    let build_ms = begun.elapsed().as_secs_f64() * 1e3;
    let most = if is_list(&what) { MOST_TESTS / scene.prims.len().max(1) as f64 } else { f64::INFINITY };
    let every = ((rays.len() as f64 / most.max(1.0)).ceil() as usize).max(1);
    let some: Vec<Ray> = rays.iter().copied().step_by(every).collect();
    let one = |ray: &Ray| go_on().then(|| built.cost(scene, ray));
    let both = |mut a: Cost, b: Cost| {
        a += b;
        Some(a)
    };
    let all = some.par_iter().map(one).try_reduce(Cost::default, both)?;
    let each = |count: u64| count as f64 / some.len().max(1) as f64;
    Some(Rated {
        what,
        rays: some.len() as u64,
        tests: each(all.prim_tests),
        visits: each(all.node_visits + all.cell_steps),
        boxes: each(all.box_tests),
        nodes: built.nodes(),
        bytes: built.bytes(),
        build_ms,
        ray_us: timed(&built, scene, &some, go_on)?,
    })
}

/// Microseconds of a ray.
fn timed(built: &Built, scene: &Scene, rays: &[Ray], go_on: &(dyn Fn() -> bool + Sync)) -> Option<f64> {
    let begun = Instant::now();
    let mut shot = 0;
    // Rays from all over the picture, in an order that has no pattern in common with its rows.
    let step = (0..).map(|n| rays.len() / 2 + 7919 + n).find(|step| coprime(*step, rays.len()))?;
    while shot < rays.len() && begun.elapsed().as_secs_f64() < TIMED {
        if !go_on() {
            return None;
        }
        for _ in 0..BETWEEN.min(rays.len() - shot) {
            built.shoot(scene, &rays[shot.wrapping_mul(step) % rays.len()]);
            shot += 1;
        }
    }
    Some(begun.elapsed().as_secs_f64() * 1e6 / shot.max(1) as f64)
}

fn coprime(a: usize, b: usize) -> bool {
    let (mut a, mut b) = (a, b);
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a == 1
}
