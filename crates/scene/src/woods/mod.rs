//! A forest of a million triangles to a tree, slide 10: several kinds of tree on hills, each stored once.

mod broad;
mod conifer;
mod growth;
mod land;

use std::sync::Arc;

use glam::{Mat3, Vec3};
use raystep_accel::{Hit, Instances, Model, PrimId, Random, Rule, Transform};

use broad::{Habit, broad};
use conifer::conifer;
use growth::Growth;
pub use land::Land;

/// A forest on hills. Each of its trees has at least a million triangles.
pub struct Woods {
    /// The trees, and last the land.
    pub instances: Instances,
    /// The land they stand on.
    pub land: Land,
    /// For each model where its leaves begin; none are wood and all is ground in the last.
    leaves: Vec<u32>,
}

/// What a hit of the woods met.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stuff {
    /// Wood of a kind of tree.
    Wood(Kind),
    /// A leaf or a needle.
    Leaf(Kind),
    /// The land.
    Ground,
}

/// Kinds of trees.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Broad and dark.
    Oak,
    /// Broad, its leaves turned.
    Maple,
    /// Slender, with a pale trunk.
    Birch,
    /// With needles.
    Spruce,
}

impl Kind {
    const ALL: [Kind; 4] = [Kind::Oak, Kind::Maple, Kind::Birch, Kind::Spruce];

    fn grow(self, triangles: u32) -> Growth {
        match self {
            Kind::Oak => broad(21, &Habit::OAK, triangles),
            Kind::Maple => broad(34, &Habit::MAPLE, triangles),
            Kind::Birch => broad(55, &Habit::BIRCH, triangles),
            Kind::Spruce => conifer(89, triangles),
        }
    }
}

/// Triangles of each tree, at least.
pub const TRIANGLES_OF_A_TREE: u32 = 1_000_000;

/// Room for a tree, in metres.
const ROOM: f32 = 8.5;

impl Woods {
    /// So many trees, each of at least so many triangles; `grown` is called when a model stands.
    pub fn planted(trees: u32, triangles: u32, grown: &mut dyn FnMut()) -> Woods {
        let land = Land::new();
        let (mut models, mut leaves) = (Vec::new(), Vec::new());
        let all = Kind::ALL.map(|kind| kind.grow(triangles)).into_iter().map(Growth::joined);
        for (mesh, first) in all.chain([(land.mesh(), 0)]) {
            // Whoever asks for speed builds a structure of its own.
            models.push(Arc::new(Model::build(mesh, &Rule::List, &mut ()).expect("nobody cancels")));
            leaves.push(first);
            grown();
        }
        let mut placed = plant(trees, &land);
        placed.push((Kind::ALL.len() as u32, Transform::IDENTITY));
        let instances = Instances::new(models, &placed).expect("every model is there, and no transform flattens it");
        Woods { instances, land, leaves }
    }

    /// What was met.
    pub fn stuff(&self, hit: &Hit) -> Stuff {
        let model = self.instances.placed()[hit.prim.index()].model as usize;
        match Kind::ALL.get(model) {
            Some(kind) if hit.inner.is_some_and(|inner| inner.0 >= self.leaves[model]) => Stuff::Leaf(*kind),
            Some(kind) => Stuff::Wood(*kind),
            None => Stuff::Ground,
        }
    }

    /// How many trees there are.
    pub fn trees(&self) -> usize {
        self.instances.placed().len() - 1
    }

    /// How high above the foot of its tree a point lies, as a part of the tree's height; 0 for the land.
    pub fn height_in(&self, tree: PrimId, point: Vec3) -> f32 {
        let bounds = self.instances.placed()[tree.index()].bounds;
        ((point.z - bounds.min.z) / (bounds.max.z - bounds.min.z).max(1e-3)).clamp(0.0, 1.0)
    }
}

/// The places where trees like it best.
fn plant(trees: u32, land: &Land) -> Vec<(u32, Transform)> {
    let random = &mut Random::new(8);
    let side = (2.0 * land.half() / ROOM) as u32;
    let mut places: Vec<(f32, Vec3)> = Vec::new();
    for number in 0..side * side {
        let cell = Vec3::new((number % side) as f32 + 0.5, (number / side) as f32 + 0.5, 0.0);
        let beside = Vec3::new(random.range(-0.42, 0.42), random.range(-0.42, 0.42), 0.0);
        let at = (cell + beside) * ROOM - Vec3::new(land.half(), land.half(), 0.0);
        places.push((land.wooded(at.x, at.y) + random.range(-0.1, 0.1), at));
    }
    places.sort_by(|a, b| b.0.total_cmp(&a.0));
    // Where there is no more room, they stand closer.
    let room = places.len().max(1);
    let tree = |n: usize| {
        let (_, at) = places[n % room];
        let more = (n / room) as f32 * 0.5 * ROOM;
        let (x, y) = (at.x + more, at.y + more * 0.5);
        let kind = match (land.damp(x, y) + random.range(-0.22, 0.22), random.unit()) {
            (damp, _) if damp < 0.5 => Kind::Spruce,
            (damp, _) if damp > 0.84 => Kind::Birch,
            (_, chance) if chance < 0.36 => Kind::Maple,
            _ => Kind::Oak,
        };
        let size = random.range(0.7, 1.25);
        let shape = Vec3::new(size, size, size * random.range(0.85, 1.15));
        let matrix = turned(random) * Mat3::from_diagonal(shape);
        // A little into the ground, so that no foot hangs in the air on a slope.
        (kind as u32, Transform { matrix, shift: Vec3::new(x, y, land.height(x, y) - 0.25) })
    };
    (0..trees as usize).map(tree).collect()
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_tree_has_its_triangles_and_stands_on_the_land() {
        let woods = Woods::planted(300, 4000, &mut || ());
        assert_eq!(woods.trees(), 300);
        assert!(woods.instances.triangles() >= 300 * 4000);
        for (index, model) in woods.instances.models().iter().enumerate().take(Kind::ALL.len()) {
            let (all, leaves) = (model.mesh.triangles.len() as u32, woods.leaves[index]);
            assert!(all >= 4000 && leaves > 0 && leaves < all, "model {index}: {leaves} of {all}");
            let bounds = model.bounds();
            assert!(bounds.min.z > -0.5 && (5.0..25.0).contains(&bounds.max.z), "model {index}: {bounds:?}");
        }
        for placed in &woods.instances.placed()[..300] {
            let foot = placed.world_from_local.shift;
            assert!((foot.z - woods.land.height(foot.x, foot.y)).abs() < 0.5, "{foot}");
        }
    }
}
