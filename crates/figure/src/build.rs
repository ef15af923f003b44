//! The state of a builder after some of its events.

use std::collections::BTreeMap;

use raystep_accel::{Aabb, CellId, Direction, Grow, LeafReason, NodeId, Place, PrimId};

/// A structure that grows: what its builder has done so far. Nothing in it comes from later events.
#[derive(Clone, Debug, PartialEq)]
pub struct GrowMoment {
    /// How many events have happened.
    pub step: usize,
    /// The last of them: what this step shows.
    pub event: Option<Grow>,
    /// The box around the primitives so far.
    pub bounds: Aabb,
    /// The nodes that came to be.
    pub nodes: BTreeMap<NodeId, GrowNode>,
    /// The node under consideration.
    pub node: Option<NodeId>,
    /// The splits of that node weighed so far.
    pub weighed: Vec<Weighed>,
    /// The grid's resolution, once chosen.
    pub resolution: Option<[u32; 3]>,
    /// What each cell refers to so far.
    pub cells: BTreeMap<CellId, Vec<PrimId>>,
    /// The cells that the current primitive's box was rasterised into, and whether it was pruned there.
    pub rasterised: Vec<(CellId, bool)>,
    /// The primitive under consideration.
    pub prim: Option<PrimId>,
}

/// A node that grows.
#[derive(Clone, Debug, PartialEq)]
pub struct GrowNode {
    /// Its box.
    pub bounds: Aabb,
    /// How many references it holds.
    pub prims: u32,
    /// How it was split in two, if it was.
    pub split: Option<Taken>,
    /// The nodes that it was split or divided into.
    pub children: Vec<NodeId>,
    /// Why it stayed a leaf, if it did.
    pub leaf: Option<LeafReason>,
    /// What it refers to, as a leaf.
    pub settled: Vec<PrimId>,
}

/// A split that was taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Taken {
    /// Across this axis.
    pub axis: Direction,
    /// At this coordinate.
    pub plane: f32,
    /// The lower child.
    pub below: NodeId,
    /// The upper child.
    pub above: NodeId,
    /// What it costs.
    pub cost: f32,
}

/// A split that was weighed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weighed {
    /// Across this axis.
    pub axis: Direction,
    /// At this coordinate.
    pub plane: f32,
    /// References below it.
    pub below: u32,
    /// References above it.
    pub above: u32,
    /// What it would cost.
    pub cost: f32,
}

impl Default for GrowMoment {
    fn default() -> GrowMoment {
        GrowMoment {
            step: 0,
            event: None,
            bounds: Aabb::EMPTY,
            nodes: BTreeMap::new(),
            node: None,
            weighed: Vec::new(),
            resolution: None,
            cells: BTreeMap::new(),
            rasterised: Vec::new(),
            prim: None,
        }
    }
}

impl GrowMoment {
    /// The state after the first `step` events.
    pub fn at(events: &[Grow], step: usize) -> GrowMoment {
        let mut moment = GrowMoment::default();
        for event in &events[..step.min(events.len())] {
            moment.happen(*event);
        }
        moment
    }

    /// Lets one more event happen.
    pub fn happen(&mut self, event: Grow) {
        self.step += 1;
        self.event = Some(event);
        match event {
            Grow::Widen { prim, bounds } => {
                self.bounds = bounds;
                self.prim = Some(prim);
            }
            Grow::Resolve { bounds, nx, ny, nz, .. } => {
                self.bounds = bounds;
                self.resolution = Some([nx, ny, nz]);
                self.prim = None;
            }
            Grow::Rasterise { prim, cell } => {
                self.take_up(prim);
                self.rasterised.push((cell, false));
            }
            Grow::Prune { prim, cell } => {
                self.take_up(prim);
                match self.rasterised.iter_mut().find(|(other, _)| *other == cell) {
                    Some((_, pruned)) => *pruned = true,
                    None => self.rasterised.push((cell, true)),
                }
            }
            Grow::Open { node, bounds, prims, .. } => {
                self.prim = None;
                self.bounds = self.bounds.union(bounds);
                let fresh =
                    GrowNode { bounds, prims, split: None, children: Vec::new(), leaf: None, settled: Vec::new() };
                self.nodes.insert(node, fresh);
                self.consider(node);
            }
            Grow::Weigh { node, axis, plane, below, above, cost } => {
                self.consider(node);
                self.weighed.push(Weighed { axis, plane, below, above, cost });
            }
            Grow::Split { node, axis, plane, below, above, cost } => {
                self.consider(node);
                if let Some(node) = self.nodes.get_mut(&node) {
                    node.split = Some(Taken { axis, plane, below, above, cost });
                    node.children = vec![below, above];
                }
            }
            Grow::Divide { node, first, ways, .. } => {
                self.consider(node);
                if let Some(node) = self.nodes.get_mut(&node) {
                    node.children = (first.0..first.0 + ways).map(NodeId).collect();
                }
            }
            Grow::Touch { node } => self.consider(node),
            Grow::Leaf { node, why, .. } => {
                self.consider(node);
                if let Some(node) = self.nodes.get_mut(&node) {
                    node.leaf = Some(why);
                }
            }
            Grow::Settle { prim, place } => {
                self.take_up(prim);
                match place {
                    Place::Node(node) => {
                        if let Some(node) = self.nodes.get_mut(&node) {
                            node.settled.push(prim);
                        }
                    }
                    Place::Cell(cell) => self.cells.entry(cell).or_default().push(prim),
                    Place::World | Place::Prim(_) => {}
                }
            }
            // Builders that join and move nodes are not among the structures so far.
            Grow::Merge { .. } | Grow::Move { .. } | Grow::Renumber { .. } => {}
        }
    }

    /// The cheapest split weighed so far; the first of equals.
    pub fn cheapest(&self) -> Option<Weighed> {
        self.weighed.iter().copied().reduce(|best, next| if next.cost < best.cost { next } else { best })
    }

    /// The path from the root to the node under consideration.
    pub fn path(&self) -> Vec<NodeId> {
        let parent =
            |child: &NodeId| self.nodes.iter().find(|(_, node)| node.children.contains(child)).map(|(id, _)| *id);
        let mut path: Vec<NodeId> = std::iter::successors(self.node, parent).collect();
        path.reverse();
        path
    }

    fn take_up(&mut self, prim: PrimId) {
        if self.prim != Some(prim) {
            self.prim = Some(prim);
            self.rasterised.clear();
        }
    }

    fn consider(&mut self, node: NodeId) {
        if self.node != Some(node) {
            self.node = Some(node);
            self.weighed.clear();
        }
    }
}
