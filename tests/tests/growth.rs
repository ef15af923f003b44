//! What every builder keeps to: its events are the whole story, and no scene makes it run away.

use std::collections::{BTreeMap, BTreeSet};

use glam::Vec3;
use rayon::prelude::*;
use raystep_accel::{
    Aabb, Cancelled, CellId, Direction, FreePlane, Grow, Mesh, NodeId, Observer, Place, PrimId, Primitives, Prims,
    Rule, Structure,
};
use raystep_scene::Scene;
use raystep_tests::rules::{rule, rules};
use raystep_tests::scenes::cases;

/// A structure as its builder's events tell it.
#[derive(Default)]
struct Told {
    bounds: Option<Aabb>,
    resolution: [u32; 3],
    cells: u32,
    boxes: BTreeMap<NodeId, Aabb>,
    children: BTreeMap<NodeId, Vec<NodeId>>,
    planes: BTreeMap<NodeId, (Direction, f32)>,
    /// The last plane told of, as a BSP tree's nodes hold it, and those that were taken.
    normal: Option<FreePlane>,
    free: BTreeMap<NodeId, FreePlane>,
    settled: BTreeMap<Place, Vec<PrimId>>,
    leaves: BTreeMap<NodeId, u32>,
    parents: BTreeMap<NodeId, NodeId>,
}

impl Observer<Grow> for Told {
    fn on(&mut self, event: Grow) {
        match event {
            Grow::Widen { bounds, .. } => self.bounds = Some(bounds),
            Grow::Resolve { nx, ny, nz, .. } => {
                self.resolution = [nx, ny, nz];
                self.cells = nx * ny * nz;
            }
            Grow::Refine { cell, first, nx, ny, nz, prims } => {
                assert_eq!(first, CellId(self.cells), "cells of finer grids are numbered on");
                self.cells += nx * ny * nz;
                let held = self.settled.remove(&Place::Cell(cell)).unwrap_or_default();
                assert_eq!(held.len(), prims as usize);
            }
            Grow::Open { node, bounds, .. } => assert!(self.boxes.insert(node, bounds).is_none()),
            Grow::Normal { normal_x, normal_y, normal_z, plane, .. } => {
                self.normal = Some(FreePlane { normal: Vec3::new(normal_x, normal_y, normal_z), at: plane });
            }
            Grow::Split { node, axis, plane, below, above, .. } => {
                self.free.extend(self.normal.map(|normal| (node, normal)));
                assert!(self.children.insert(node, vec![below, above]).is_none());
                self.planes.insert(node, (axis, plane));
            }
            Grow::Divide { node, first, ways, .. } => {
                let children = (0..ways).map(|i| NodeId(first.0 + i)).collect();
                assert!(self.children.insert(node, children).is_none());
            }
            Grow::Merge { node, left, right, bounds } => {
                self.boxes.insert(node, bounds);
                self.children.insert(node, Vec::new());
                self.hang(left, node);
                self.hang(right, node);
            }
            Grow::Move { node, parent, .. } => self.hang(node, parent),
            Grow::Refit { node, bounds } => assert!(self.boxes.insert(node, bounds).is_some()),
            Grow::Renumber { from, to } => self.renumber(from, to),
            Grow::Leaf { node, prims, .. } => {
                // What lay below it is gone.
                self.children.remove(&node);
                assert!(self.leaves.insert(node, prims).is_none());
            }
            Grow::Settle { prim, place } => self.settled.entry(place).or_default().push(prim),
            _ => {}
        }
    }
}

impl Told {
    /// Takes a node from where it hangs to under another.
    fn hang(&mut self, node: NodeId, parent: NodeId) {
        if let Some(old) = self.parents.insert(node, parent)
            && let Some(children) = self.children.get_mut(&old)
        {
            children.retain(|&child| child != node);
        }
        self.children.entry(parent).or_default().push(node);
    }

    fn renumber(&mut self, from: NodeId, to: NodeId) {
        let bounds = self.boxes.remove(&from).expect("a node that came to be");
        assert!(self.boxes.insert(to, bounds).is_none(), "{to} is taken");
        if let Some(children) = self.children.remove(&from) {
            self.parents.extend(children.iter().map(|&child| (child, to)));
            self.children.insert(to, children);
        }
        if let Some(parent) = self.parents.remove(&from) {
            self.hang(to, parent);
            self.children.entry(parent).or_default().retain(|&child| child != from);
        }
    }

    /// Forgets what hangs nowhere any more, and puts siblings in order.
    fn settle_down(&mut self) {
        let mut reached = BTreeSet::new();
        let mut waiting = vec![NodeId::ROOT];
        while let Some(node) = waiting.pop() {
            reached.insert(node);
            waiting.extend(self.children.get(&node).into_iter().flatten());
        }
        self.boxes.retain(|node, _| reached.contains(node));
        self.children.retain(|node, _| reached.contains(node));
        self.children.values_mut().for_each(|children| children.sort_unstable());
    }

    fn settled(&self, place: Place) -> &[PrimId] {
        self.settled.get(&place).map_or(&[], Vec::as_slice)
    }

    /// Nothing in the structure differs from what was told, and nothing was told that is not in it.
    fn matches(&self, structure: &Structure) {
        assert_eq!(structure.bounds(), self.bounds.unwrap_or(Aabb::EMPTY));
        if let Some(grid) = structure.grid() {
            assert_eq!((grid.lattice().resolution, grid.cell_count()), (self.resolution, self.cells as usize));
            let mut cells = (0..self.cells).map(CellId);
            assert!(cells.all(|cell| grid.cell_prims(cell) == self.settled(Place::Cell(cell))));
            return;
        }
        assert_eq!(structure.node_count(), self.boxes.len());
        assert_eq!(structure.node_count(), self.children.len() + self.leaves.len());
        for (i, bounds) in structure.node_bounds().into_iter().enumerate() {
            let node = NodeId(i as u32);
            assert_eq!(bounds, self.boxes[&node]);
            assert_eq!(structure.children(node), self.children.get(&node).cloned().unwrap_or_default());
            assert_eq!(structure.leaf_prims(node), self.settled(Place::Node(node)));
            if let Structure::Kd(_) | Structure::Bsp(_) = structure {
                assert_eq!(structure.split(node), self.planes.get(&node).copied());
            }
            if let Structure::Bsp(tree) = structure {
                assert_eq!(tree.plane(node), self.free.get(&node).copied());
            }
        }
        assert!(self.leaves.iter().all(|(&node, &prims)| structure.leaf_prims(node).len() == prims as usize));
    }
}

#[test]
fn folding_what_a_builder_tells_gives_its_structure() {
    cases().par_iter().for_each(|case| {
        for (line, rule) in rules() {
            let rule = if case.flat { rule.flat() } else { rule };
            let mut told = Told::default();
            let structure = Structure::build(&case.prims, &rule, &mut told).unwrap();
            let of = Of { scene: &case.name, line };
            told.settle_down();
            told.matches(&structure);
            // Who watches changes nothing.
            assert_eq!(Structure::build(&case.prims, &rule, &mut ()).unwrap(), structure);
            drop(of);
        }
    });
}

/// Says of which build something is not so.
struct Of<'a> {
    scene: &'a str,
    line: &'a str,
}

impl Drop for Of<'_> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            eprintln!("{}, {}: not so", self.scene, self.line);
        }
    }
}

#[test]
fn every_primitive_is_referred_to() {
    cases().par_iter().for_each(|case| {
        for (line, rule) in rules() {
            let structure = Structure::build(&case.prims, &rule, &mut ()).unwrap();
            let mut referred = vec![0; case.prims.len()];
            let nodes = (0..structure.node_count() as u32).map(NodeId);
            nodes.flat_map(|node| structure.leaf_prims(node)).for_each(|prim| referred[prim.index()] += 1);
            if let Some(grid) = structure.grid() {
                let cells = (0..grid.cell_count() as u32).map(CellId);
                cells.flat_map(|cell| grid.cell_prims(cell)).for_each(|prim| referred[prim.index()] += 1);
            }
            assert!(referred.iter().all(|&n| n > 0), "{}, {line}: {referred:?}", case.name);
            if matches!(rule, Rule::Bvh(_)) {
                assert!(referred.iter().all(|&n| n == 1), "{}, {line}: {referred:?}", case.name);
            }
        }
    });
}

/// The same triangle, many times.
fn pile(n: usize) -> Prims {
    let corners = vec![Vec3::ZERO, Vec3::new(1.0, 0.2, 0.3), Vec3::new(0.3, 1.0, 0.8)];
    Prims::Mesh(Mesh { corners, triangles: vec![[0, 1, 2]; n] })
}

/// Thin triangles fanned about a common edge, each a little wider: every plane cuts nearly all of them.
fn fan(n: usize) -> Prims {
    let tip = |i: usize| Vec3::new(1.0 + i as f32 / n as f32, i as f32 / n as f32, 1.0);
    let corners = [Vec3::ZERO, Vec3::ONE].into_iter().chain((0..n).map(tip)).collect();
    Prims::Mesh(Mesh { corners, triangles: (0..n as u32).map(|i| [0, 1, i + 2]).collect() })
}

/// Triangles whose corners are all one point: the box around them has no sides at all.
fn speck(n: usize) -> Prims {
    Prims::Mesh(Mesh { corners: vec![Vec3::ONE], triangles: vec![[0; 3]; n] })
}

#[test]
fn triangles_on_top_of_each_other_give_a_bounded_structure() {
    for (n, prims) in [(100_000, pile(100_000)), (100_000, speck(100_000)), (3000, fan(3000))] {
        let lines = [
            "grid",
            "nested-grid levels=6",
            "hashed-grid",
            "kd",
            "kd split=middle max_depth=64 min_objects=0",
            "kd split=median max_depth=64",
            "octree",
            "octree max_depth=20 min_objects=1",
            "bsp",
            "bsp planes=candidates max_depth=64 min_objects=0",
            "bvh",
            "bvh volume=sphere",
            "bvh volume=obb",
            "bvh volume=kdop26",
            "bvh volume=hull",
            "bvh builder=bottom-up",
            "bvh builder=ploc",
            "bvh builder=insertion",
            "bvh builder=ploc volume=sphere",
        ];
        lines.par_iter().for_each(|line| {
            let structure = Structure::build(&prims, &rule(line), &mut ()).unwrap();
            let bytes = structure.bytes() / n;
            assert!(bytes < 2000, "{line}: {bytes} bytes a triangle");
        });
    }
}

#[test]
fn a_tree_is_never_deeper_than_its_stack() {
    // Each triangle a quarter of the one before, all at one corner.
    let triangles: Vec<[u32; 3]> = (0..60).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    let size = |i: i32| 0.25f32.powi(i);
    let corners = (0..60).flat_map(|i| [Vec3::X * size(i), Vec3::Y * size(i), Vec3::Z * size(i)]).collect();
    let prims = Prims::Mesh(Mesh { corners, triangles });
    for line in [
        "kd max_depth=64 min_objects=0 traversal_cost=0",
        "kd split=middle max_depth=64 min_objects=0",
        "bsp max_depth=64 min_objects=0 traversal_cost=0",
        "bvh",
        "bvh builder=bottom-up",
        "bvh builder=ploc",
        "bvh builder=insertion",
    ] {
        let mut deepest = 0;
        let mut watch = raystep_accel::Each(|event| {
            if let Grow::Open { depth, .. } = event {
                deepest = deepest.max(depth);
            }
        });
        Structure::build(&prims, &rule(line), &mut watch).unwrap();
        assert!(deepest <= 72, "{line}: {deepest}");
    }
}

/// Gives up after so many nodes or cells.
struct Patience(u32);

impl Observer<Grow> for Patience {
    fn on(&mut self, event: Grow) {
        if matches!(event, Grow::Open { .. } | Grow::Settle { .. }) {
            self.0 = self.0.saturating_sub(1);
        }
    }

    fn cancelled(&self) -> bool {
        self.0 == 0
    }
}

#[test]
fn a_builder_gives_up_when_asked() {
    let teapot = Scene::named("teapot-6321").unwrap();
    let joined = ["bvh builder=bottom-up", "bvh builder=ploc", "bvh builder=insertion"];
    for line in ["grid", "nested-grid", "hashed-grid", "kd", "bsp", "bvh"].into_iter().chain(joined) {
        for patience in [0, 1, 10, 300] {
            let built = Structure::build(&teapot.prims, &rule(line), &mut Patience(patience));
            assert_eq!(built, Err(Cancelled), "{line}");
        }
    }
}
