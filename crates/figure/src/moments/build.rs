//! The state of a builder after some of its events.

mod changes;
mod instead;
mod joins;
mod node;
mod tally;
mod weighed;

use std::collections::BTreeMap;

use glam::Vec3;
use raystep_accel::{Aabb, Axis, CellId, Direction, FreePlane, Grow, NodeId, Place, PrimId, Prims, Structure};

use super::Changed;
use crate::world::Nodes;
pub use node::{GrowNode, Taken};
pub use tally::Tally;
pub use weighed::Weighed;

/// A build that was recorded, with what it ended in.
#[derive(Clone, Copy)]
pub struct Build<'a> {
    /// The finished structure: it knows where a grid's cells lie.
    pub structure: &'a Structure,
    /// Its nodes, as pictures need them.
    pub nodes: &'a Nodes,
    /// What it was built over.
    pub prims: &'a Prims,
    /// What happened, in order.
    pub events: &'a [Grow],
    /// How many more events there were than the recording holds, by their names.
    pub lost: &'a BTreeMap<&'static str, u64>,
    /// What the builder weighed at the step that is shown, where another cut is tried instead of it.
    pub instead: Option<Grow>,
    /// What is done to the structure once it is built, in order.
    pub changes: &'a [Changed],
    /// Whether the scene is flat.
    pub flat: bool,
}

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
    /// In a BSP tree, the plane that is weighed or taken next.
    pub free: Option<FreePlane>,
    /// The grid's resolution, once chosen.
    pub resolution: Option<[u32; 3]>,
    /// How many cells there are so far, those of the grids within cells included.
    pub cell_count: u32,
    /// What each cell refers to so far.
    pub cells: BTreeMap<CellId, Vec<PrimId>>,
    /// The cells that the current primitive's box was rasterised into, and what became of it there.
    pub rasterised: Vec<(CellId, Fate)>,
    /// The primitives that set the six sides of the box: the lower ones of x, y and z, then the upper ones.
    pub sides: [Option<PrimId>; 6],
    /// The primitives on both sides of the split just taken.
    pub shared: Vec<PrimId>,
    /// Nodes that wait to be split or to become leaves, the next one last.
    pub waiting: Vec<NodeId>,
    /// What was done so far.
    pub tally: Tally,
    /// Planes that an open question offers, with a word for each. The build knows nothing of it: whoever
    /// asks puts them here.
    pub guesses: Vec<(Direction, f32, String)>,
    /// Sets in the order of the Morton curve that they lie on, each with its middle.
    pub curve: Vec<(NodeId, Vec3)>,
    /// Which neighbour on it each set has chosen in this round.
    pub preferred: Vec<(NodeId, NodeId)>,
    parents: BTreeMap<NodeId, NodeId>,
    /// The event before.
    last: Option<Grow>,
    /// The primitive under consideration.
    pub prim: Option<PrimId>,
}

/// What becomes of a primitive in a cell that its box meets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fate {
    /// That is still to be decided.
    Open,
    /// The cell refers to it.
    Stored,
    /// It does not reach into the cell.
    Pruned,
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
            free: None,
            resolution: None,
            cell_count: 0,
            cells: BTreeMap::new(),
            rasterised: Vec::new(),
            sides: [None; 6],
            shared: Vec::new(),
            waiting: Vec::new(),
            tally: Tally::default(),
            guesses: Vec::new(),
            curve: Vec::new(),
            preferred: Vec::new(),
            parents: BTreeMap::new(),
            last: None,
            prim: None,
        }
    }
}

impl GrowMoment {
    /// The state after the first `step` events.
    pub fn at(events: &[Grow], step: usize) -> GrowMoment {
        let mut moment = GrowMoment::default();
        moment.advance(events, step);
        moment
    }

    /// Lets events happen until `step` have. Steps already taken are not taken back.
    pub fn advance(&mut self, events: &[Grow], step: usize) {
        for event in events.get(self.step..step.min(events.len())).unwrap_or_default() {
            self.happen(*event);
        }
    }

    /// Lets one more event happen.
    pub fn happen(&mut self, event: Grow) {
        self.step += 1;
        self.last = self.event.replace(event);
        match event {
            Grow::Widen { prim, bounds, .. } => {
                self.set_sides(prim, &bounds);
                self.bounds = bounds;
                self.prim = Some(prim);
                self.tally.boxed += 1;
            }
            Grow::Resolve { bounds, nx, ny, nz, .. } => {
                self.bounds = bounds;
                self.resolution = Some([nx, ny, nz]);
                self.cell_count = nx * ny * nz;
                self.prim = None;
            }
            Grow::Refine { cell, first, nx, ny, nz, prims } => {
                // What the cell referred to goes into its own grid.
                self.cells.remove(&cell);
                self.tally.stored = self.tally.stored.saturating_sub(u64::from(prims));
                self.cell_count = first.0 + nx * ny * nz;
                self.prim = None;
                self.rasterised.clear();
            }
            Grow::Rasterise { prim, cell } => {
                self.take_up(prim);
                self.rasterised.push((cell, Fate::Open));
                self.tally.rasterised += 1;
            }
            Grow::Prune { prim, cell } => {
                self.take_up(prim);
                self.decide(cell, Fate::Pruned);
                self.tally.pruned += 1;
            }
            Grow::Open { node, bounds, prims, depth } => {
                self.prim = None;
                self.bounds = self.bounds.union(bounds);
                let fresh = GrowNode {
                    bounds,
                    prims,
                    depth,
                    split: None,
                    children: Vec::new(),
                    leaf: None,
                    settled: Vec::new(),
                    placed: false,
                };
                // A leaf that became too full is opened again: its references go to its children.
                let before = self.nodes.insert(node, fresh).map_or(0, |before| before.settled.len());
                self.tally.stored = self.tally.stored.saturating_sub(before as u64);
                self.consider(node);
                self.waiting.retain(|waiting| *waiting != node);
            }
            Grow::Normal { node, normal_x, normal_y, normal_z, plane, .. } => {
                self.consider(node);
                self.free = Some(FreePlane { normal: Vec3::new(normal_x, normal_y, normal_z), at: plane });
            }
            Grow::Weigh { node, axis, plane, below, above, cost, .. } => {
                self.consider(node);
                self.tally.weighed += 1;
                self.weighed.push(Weighed { axis, plane, below, above, cost, free: self.free });
            }
            Grow::Split { node, axis, plane, below, above, cost } => {
                self.consider(node);
                self.tally.taken += 1;
                self.give_birth(node, vec![below, above]);
                if let Some(node) = self.nodes.get_mut(&node) {
                    node.split = Some(Taken { axis, plane, below, above, cost, free: self.free });
                }
            }
            Grow::Share { node, prim } => {
                self.consider(node);
                self.shared.push(prim);
            }
            Grow::Divide { node, first, ways, .. } => {
                self.consider(node);
                self.tally.taken += 1;
                self.give_birth(node, (first.0..first.0 + ways).map(NodeId).collect());
            }
            Grow::Touch { node } => self.consider(node),
            Grow::Leaf { node, prims, why } => {
                self.consider(node);
                let below = self.forget_below(node);
                self.tally.stored = self.tally.stored.saturating_sub(below as u64);
                self.tally.leaves += 1;
                if let Some(node) = self.nodes.get_mut(&node) {
                    node.leaf = Some(why);
                    node.prims = prims;
                }
            }
            Grow::Remove { prim, place } => {
                self.take_up(prim);
                self.tally.stored = self.tally.stored.saturating_sub(1);
                if let Place::Node(node) = place
                    && let Some(node) = self.nodes.get_mut(&node)
                {
                    node.settled.retain(|settled| *settled != prim);
                    node.prims = node.settled.len() as u32;
                }
            }
            Grow::Settle { prim, place } => {
                self.take_up(prim);
                self.tally.stored += 1;
                match place {
                    Place::Node(node) => {
                        if let Some(node) = self.nodes.get_mut(&node) {
                            node.settled.push(prim);
                            node.prims = node.prims.max(node.settled.len() as u32);
                        }
                    }
                    Place::Cell(cell) => {
                        self.cells.entry(cell).or_default().push(prim);
                        self.decide(cell, Fate::Stored);
                    }
                    Place::World | Place::Prim(_) => {}
                }
            }
            Grow::Rank { node, x, y, z, .. } => {
                self.consider(node);
                self.prim = None;
                self.curve.push((node, Vec3::new(x, y, z)));
            }
            Grow::Prefer { node, nearest } => self.prefer(node, nearest),
            Grow::Merge { node, left, right, bounds } => self.join(node, [left, right], bounds),
            Grow::Move { node, parent, .. } => self.hang(node, parent),
            Grow::Refit { node, bounds } => self.refit(node, bounds),
            Grow::Renumber { from, to } => {
                self.curve.clear();
                self.preferred.clear();
                self.renumber(from, to);
            }
            Grow::End { .. } => {
                self.curve.clear();
                self.preferred.clear();
                self.prim = None;
                self.node = None;
                self.weighed.clear();
                self.shared.clear();
                self.rasterised.clear();
            }
        }
    }

    /// The cheapest split weighed so far; the first of equals.
    pub fn cheapest(&self) -> Option<Weighed> {
        Weighed::cheapest(&self.weighed)
    }

    /// The path from the root to the node under consideration.
    pub fn path(&self) -> Vec<NodeId> {
        let parent = |child: &NodeId| self.parents.get(child).copied();
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
            self.shared.clear();
        }
    }

    /// The children of a node, which are to be built one after the other.
    fn give_birth(&mut self, node: NodeId, children: Vec<NodeId>) {
        self.waiting.extend(children.iter().rev());
        self.parents.extend(children.iter().map(|child| (*child, node)));
        if let Some(node) = self.nodes.get_mut(&node) {
            node.children = children;
        }
    }

    /// What becomes of the current primitive in a cell.
    fn decide(&mut self, cell: CellId, fate: Fate) {
        match self.rasterised.iter_mut().find(|(other, _)| *other == cell) {
            Some((_, known)) => *known = fate,
            None => self.rasterised.push((cell, fate)),
        }
    }

    /// The sides of the box that a primitive moves are its own from now on.
    fn set_sides(&mut self, prim: PrimId, bounds: &Aabb) {
        for axis in Axis::ALL {
            if bounds.min[axis] != self.bounds.min[axis] {
                self.sides[axis.index()] = Some(prim);
            }
            if bounds.max[axis] != self.bounds.max[axis] {
                self.sides[3 + axis.index()] = Some(prim);
            }
        }
    }
}
