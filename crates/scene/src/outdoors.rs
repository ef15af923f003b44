//! Forest and meadow, slides 2-4 and 25-27: a few models stored once, placed many times from a seed.

use std::sync::{Arc, LazyLock};

use glam::{DVec3, Mat3, Vec3};
use rayon::prelude::*;
use raystep_accel::{Aabb, BvhRule, Instances, Mesh, Model, PrimId, Primitives, Prims, Random, Rule, Transform};

use crate::tree::tree;
use crate::{Scene, View};

/// Most trees of a forest: as many as the lecture counts.
pub const MOST_TREES: u32 = 50_000;

/// Room for a tree, in metres.
const TREE_ROOM: f32 = 8.0;

/// Patches along each side of the meadow, and their size in metres.
const PATCHES: u32 = 24;
const PATCH: f32 = 1.0;

/// Blades on a patch.
const BLADES: u32 = 500;

/// The trees of every forest, grown once, side by side.
static GROWN: LazyLock<Vec<Arc<Model>>> =
    LazyLock::new(|| [11, 12, 13].into_par_iter().map(|seed| model(tree(seed))).collect());

/// A forest of so many trees, at least 1: three grown trees, each placed many times, on a floor.
pub(crate) fn forest(trees: u32) -> Scene {
    let grown = GROWN.clone();
    let random = &mut Random::new(2);
    // Rows as a forester plants them, each tree a little beside its place.
    let side = (1..).find(|side| side * side >= trees).unwrap_or(1);
    let half = side as f32 * TREE_ROOM * 0.5;
    let mut placed = Vec::with_capacity(trees as usize + 1);
    for number in 0..trees {
        let row = Vec3::new((number % side) as f32 + 0.5, (number / side) as f32 + 0.5, 0.0) * TREE_ROOM;
        let beside = Vec3::new(random.range(-2.0, 2.0), random.range(-2.0, 2.0), 0.0);
        let shift = if trees == 1 { Vec3::ZERO } else { row + beside - Vec3::new(half, half, 0.0) };
        let matrix = turned(random) * random.range(0.75, 1.25);
        placed.push((random.below(grown.len() as u32), Transform { matrix, shift }));
    }
    let models = grown.into_iter().chain([model(floor(half + TREE_ROOM))]).collect::<Vec<_>>();
    placed.push((models.len() as u32 - 1, Transform::IDENTITY));
    let name = if trees == 1000 { "forest".to_owned() } else { format!("forest:{trees}") };
    outdoors(name, "A forest of instances", models, &placed, |count| {
        format!(
            "{trees} trees, placed from three that are stored once: {count} triangles for a ray to meet. Grown and planted \
             from seeds."
        )
    })
}

/// A meadow: a patch of blades stored twice, placed over and over.
pub(crate) fn grass() -> Scene {
    let random = &mut Random::new(5);
    let grown = [0; 2].map(|_| model(patch(random)));
    let half = PATCHES as f32 * PATCH * 0.5;
    let mut placed = Vec::new();
    for number in 0..PATCHES * PATCHES {
        let at = Vec3::new((number % PATCHES) as f32 + 0.5, (number / PATCHES) as f32 + 0.5, 0.0) * PATCH;
        let shift = at - Vec3::new(half, half, 0.0);
        placed.push((random.below(2), Transform { matrix: turned(random), shift }));
    }
    let models = grown.into_iter().chain([model(floor(half))]).collect::<Vec<_>>();
    placed.push((2, Transform::IDENTITY));
    outdoors("grass".to_owned(), "A meadow of grass", models, &placed, |count| {
        format!("{BLADES} blades on a patch, and {} patches: {count} triangles. Grown from a seed.", PATCHES * PATCHES)
    })
}

fn outdoors(
    name: String,
    title: &str,
    models: Vec<Arc<Model>>,
    placed: &[(u32, Transform)],
    note: impl Fn(u64) -> String,
) -> Scene {
    let instances = Instances::new(models, placed).expect("every model is there, and no transform flattens it");
    let bounds = (0..instances.len() as u32).map(|id| instances.bounds(PrimId(id)));
    let bounds = bounds.fold(Aabb::EMPTY, Aabb::union);
    Scene {
        name,
        title: title.to_owned(),
        flat: false,
        view: View::fitting(&bounds, Vec3::new(0.4, -1.0, 0.35), Vec3::Z),
        note: note(instances.triangles()),
        prims: Prims::Instances(instances),
        origin: DVec3::ZERO,
    }
}

fn model(mesh: Mesh) -> Arc<Model> {
    let rule = Rule::Bvh(BvhRule::default());
    Arc::new(Model::build(mesh, &rule, &mut ()).expect("nobody cancels"))
}

/// Turned about the upright axis by some angle.
fn turned(random: &mut Random) -> Mat3 {
    loop {
        let (x, y) = (random.range(-1.0, 1.0), random.range(-1.0, 1.0));
        let length = (x * x + y * y).sqrt();
        if length > 0.1 && length <= 1.0 {
            let (cos, sin) = (x / length, y / length);
            return Mat3::from_cols(Vec3::new(cos, sin, 0.0), Vec3::new(-sin, cos, 0.0), Vec3::Z);
        }
    }
}

/// Two triangles on the ground.
fn floor(half: f32) -> Mesh {
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    Mesh {
        corners: corners.map(|(x, y)| Vec3::new(x * half, y * half, 0.0)).to_vec(),
        triangles: vec![[0, 1, 2], [0, 2, 3]],
    }
}

/// Blades of grass on a square around the origin: each bends to one side and ends in a point.
fn patch(random: &mut Random) -> Mesh {
    let mut mesh = Mesh::default();
    let half = PATCH * 0.5;
    for _ in 0..BLADES {
        let foot = Vec3::new(random.range(-half, half), random.range(-half, half), 0.0);
        let turn = turned(random);
        let (bend, across) = (turn.x_axis * random.range(0.02, 0.12), turn.y_axis * random.range(0.004, 0.008));
        let height = Vec3::Z * random.range(0.15, 0.4);
        let first = mesh.corners.len() as u32;
        for (up, width) in [(0.0, 1.0), (0.4, 0.8), (0.75, 0.5)] {
            let middle = foot + height * up + bend * (up * up);
            mesh.corners.extend([middle - across * width, middle + across * width]);
        }
        mesh.corners.push(foot + height + bend);
        for [a, b, c] in [[0, 1, 3], [0, 3, 2], [2, 3, 5], [2, 5, 4], [4, 5, 6]] {
            mesh.triangles.push([first + a, first + b, first + c]);
        }
    }
    mesh
}
