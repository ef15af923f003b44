//! The vocabulary of builders: what a structure does while it grows. Folding it rebuilds the structure.

use super::{CellId, Grain, NodeId, Place, PrimId, vocabulary, words};
use crate::{Aabb, Direction};

words! {
    /// Why a node was not split further.
    pub enum LeafReason {
        /// It holds few enough primitives.
        Few = "few",
        /// The tree is as deep as it may become.
        Deep = "deep",
        /// No split is cheaper than testing its primitives.
        Cheap = "cheap",
        /// No plane separates its primitives.
        Inseparable = "inseparable",
        /// The tree refers to its primitives as often as it may.
        Crowded = "crowded",
    }
}

vocabulary! {
    /// One thing that a builder did.
    pub enum Grow {
        /// A primitive was put into the box around them all, which is `bounds` now; it had to grow, or not.
        Widen ["widen.grown", "widen.same"] { prim: PrimId, bounds: Aabb, grown: bool }
        /// The grid's resolution was chosen.
        Resolve ["resolve"] { bounds: Aabb, nx: u32, ny: u32, nz: u32, prims: u32 }
        /// A crowded cell got a grid of its own, with cells numbered from `first`: its references go there.
        Refine ["refine"] { cell: CellId, first: CellId, nx: u32, ny: u32, nz: u32, prims: u32 }
        /// A primitive's box was rasterised into this cell.
        Rasterise ["rasterise"] { prim: PrimId, cell: CellId }
        /// The primitive does not overlap the cell: no reference.
        Prune ["prune"] { prim: PrimId, cell: CellId }
        /// A node came to be.
        Open ["open"] { node: NodeId, bounds: Aabb, prims: u32, depth: u32 }
        /// The plane that is weighed or taken next: all points `p` with `normal · p = plane`. A primitive proposed it, or it is one of a given set.
        Normal ["normal"] { node: NodeId, normal_x: f32, normal_y: f32, normal_z: f32, plane: f32, from: Place }
        /// A split was weighed: so many primitives below and above. `size` is the surface area of the node's box, in a
        /// flat scene its perimeter; a ray that meets it meets a side with the chance `p = size of the side / size`.
        /// `step` is what going on to a child counts, `test` what a primitive counts, and `bonus` is 1 unless one side
        /// is empty: `cost = bonus · (step + test · (p_below · below + p_above · above))`.
        Weigh ["weigh"] {
            node: NodeId,
            axis: Direction,
            plane: f32,
            below: u32,
            above: u32,
            size: f32,
            size_below: f32,
            size_above: f32,
            p_below: f32,
            p_above: f32,
            step: f32,
            test: f32,
            bonus: f32,
            cost: f32,
        }
        /// A split was taken; the children are `below` and `above`.
        Split ["split"] { node: NodeId, axis: Direction, plane: f32, below: NodeId, above: NodeId, cost: f32 }
        /// A primitive lies on both sides of the split just taken: both children refer to it.
        Share ["share"] { node: NodeId, prim: PrimId }
        /// A cell was cut through its middle into `ways` equal children, side by side from `first`.
        Divide ["divide"] { node: NodeId, first: NodeId, ways: u32, at_x: f32, at_y: f32, at_z: f32 }
        /// A node was looked at while the structure was changed.
        Touch ["touch"] { node: NodeId }
        /// A node stays a leaf with so many references.
        Leaf ["leaf"] { node: NodeId, prims: u32, why: LeafReason }
        /// A primitive is referred to from a leaf or a cell, after those that settled there before it.
        Settle ["settle"] { prim: PrimId, place: Place }
        /// A leaf refers to a primitive no more.
        Remove ["remove"] { prim: PrimId, place: Place }
        /// A set got its place on the Morton curve, `rank` sets lie before it; its middle lies at `x`, `y`, `z`. The first
        /// three digits of its code say in which eighth of the box that is (in a flat scene: quarter), in which eighth of
        /// that, and in which eighth of this: x adds 1, y adds 2, z adds 4 where the middle lies in the upper half.
        Rank ["rank"] { node: NodeId, rank: u32, first: u32, second: u32, third: u32, x: f32, y: f32, z: f32 }
        /// A set's choice for this round: of its neighbours on the curve the one with the smallest common volume.
        Prefer ["prefer"] { node: NodeId, nearest: NodeId }
        /// Two nodes became the children of a new one.
        Merge ["merge"] { node: NodeId, left: NodeId, right: NodeId, bounds: Aabb }
        /// A node was moved under another.
        Move ["move"] { node: NodeId, parent: NodeId, cost: f32 }
        /// A node's volume was fitted anew to what lies below; `bounds` is the box around it.
        Refit ["refit"] { node: NodeId, bounds: Aabb }
        /// A node got its final id.
        Renumber ["renumber"] { from: NodeId, to: NodeId }
        /// The structure is built: so many nodes or cells, which refer to primitives so many times.
        End ["end"] { nodes: u32, cells: u32, references: u32 }
    }
}

impl Grow {
    /// What slides, listings and questions call this event.
    pub fn name(&self) -> &'static str {
        match self {
            Grow::Widen { grown: true, .. } => "widen.grown",
            Grow::Widen { grown: false, .. } => "widen.same",
            Grow::Resolve { .. } => "resolve",
            Grow::Refine { .. } => "refine",
            Grow::Rasterise { .. } => "rasterise",
            Grow::Prune { .. } => "prune",
            Grow::Open { .. } => "open",
            Grow::Normal { .. } => "normal",
            Grow::Weigh { .. } => "weigh",
            Grow::Split { .. } => "split",
            Grow::Share { .. } => "share",
            Grow::Divide { .. } => "divide",
            Grow::Touch { .. } => "touch",
            Grow::Leaf { .. } => "leaf",
            Grow::Settle { .. } => "settle",
            Grow::Remove { .. } => "remove",
            Grow::Rank { .. } => "rank",
            Grow::Prefer { .. } => "prefer",
            Grow::Merge { .. } => "merge",
            Grow::Move { .. } => "move",
            Grow::Refit { .. } => "refit",
            Grow::Renumber { .. } => "renumber",
            Grow::End { .. } => "end",
        }
    }

    /// How coarse the event is: what is weighed and measured is fine, what comes to be is coarse.
    pub fn grain(&self) -> Grain {
        match self {
            Grow::Normal { .. }
            | Grow::Weigh { .. }
            | Grow::Rasterise { .. }
            | Grow::Widen { grown: false, .. }
            | Grow::Prefer { .. }
            | Grow::Touch { .. } => Grain::Arithmetic,
            Grow::Open { .. } | Grow::Resolve { .. } | Grow::Refine { .. } | Grow::Merge { .. } | Grow::End { .. } => {
                Grain::Visit
            }
            Grow::Settle { place: Place::Cell(_), .. } => Grain::Visit,
            _ => Grain::Decision,
        }
    }

    /// The same event, with its nodes called by other numbers.
    #[must_use]
    pub fn renamed(mut self, name: impl Fn(NodeId) -> NodeId) -> Grow {
        let rename = |node: &mut NodeId| *node = name(*node);
        match &mut self {
            Grow::Split { node, below, above, .. } => [node, below, above].into_iter().for_each(rename),
            Grow::Merge { node, left, right, .. } => [node, left, right].into_iter().for_each(rename),
            Grow::Divide { node, first, .. } => [node, first].into_iter().for_each(rename),
            Grow::Prefer { node, nearest } => [node, nearest].into_iter().for_each(rename),
            Grow::Move { node, parent, .. } => [node, parent].into_iter().for_each(rename),
            Grow::Renumber { from, to } => [from, to].into_iter().for_each(rename),
            Grow::Open { node, .. }
            | Grow::Normal { node, .. }
            | Grow::Weigh { node, .. }
            | Grow::Share { node, .. }
            | Grow::Touch { node }
            | Grow::Leaf { node, .. }
            | Grow::Rank { node, .. }
            | Grow::Refit { node, .. }
            | Grow::Settle { place: Place::Node(node), .. }
            | Grow::Remove { place: Place::Node(node), .. } => rename(node),
            Grow::Settle { .. }
            | Grow::Remove { .. }
            | Grow::Widen { .. }
            | Grow::Resolve { .. }
            | Grow::Refine { .. }
            | Grow::Rasterise { .. }
            | Grow::Prune { .. }
            | Grow::End { .. } => {}
        }
        self
    }

    /// What the event is about.
    pub fn place(&self) -> Place {
        match *self {
            Grow::Widen { prim, .. } => Place::Prim(prim),
            Grow::Resolve { .. } | Grow::End { .. } => Place::World,
            Grow::Refine { cell, .. } | Grow::Rasterise { cell, .. } | Grow::Prune { cell, .. } => Place::Cell(cell),
            Grow::Settle { place, .. } | Grow::Remove { place, .. } => place,
            Grow::Open { node, .. }
            | Grow::Normal { node, .. }
            | Grow::Weigh { node, .. }
            | Grow::Split { node, .. }
            | Grow::Share { node, .. }
            | Grow::Divide { node, .. }
            | Grow::Touch { node }
            | Grow::Leaf { node, .. }
            | Grow::Rank { node, .. }
            | Grow::Prefer { node, .. }
            | Grow::Merge { node, .. }
            | Grow::Move { node, .. }
            | Grow::Refit { node, .. }
            | Grow::Renumber { from: node, .. } => Place::Node(node),
        }
    }
}
