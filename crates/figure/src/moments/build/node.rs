//! A node that grows, and the split that was taken there.

use raystep_accel::{Aabb, Direction, FreePlane, LeafReason, NodeId, PrimId};

/// A node that grows.
#[derive(Clone, Debug, PartialEq)]
pub struct GrowNode {
    /// Its box.
    pub bounds: Aabb,
    /// How many references it holds.
    pub prims: u32,
    /// How deep it lies: the root at 0.
    pub depth: u32,
    /// How it was split in two, if it was.
    pub split: Option<Taken>,
    /// The nodes that it was split or divided into.
    pub children: Vec<NodeId>,
    /// Why it stayed a leaf, if it did.
    pub leaf: Option<LeafReason>,
    /// What it refers to, as a leaf.
    pub settled: Vec<PrimId>,
    /// Where sets are joined: whether it lies where it stays.
    pub placed: bool,
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
    /// In a BSP tree, how the plane stands.
    pub free: Option<FreePlane>,
}
