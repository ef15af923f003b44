//! How an octree is to be built.

use super::parameter::Slot;
use super::shared;
use crate::Axes;

/// The parameters of an octree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OctreeRule {
    /// Nodes this deep stay leaves; the root has depth 0.
    pub max_depth: u32,
    /// Nodes with so few primitives stay leaves.
    pub min_objects: u32,
    /// Whether a ray remembers which primitives it tested.
    pub mailbox: bool,
    /// The axes to halve: a flat scene's octree is a quadtree.
    pub axes: Axes,
}

impl Default for OctreeRule {
    fn default() -> OctreeRule {
        OctreeRule { max_depth: 8, min_objects: 4, mailbox: true, axes: Axes::Xyz }
    }
}

impl OctreeRule {
    /// The greatest depth that may be asked for: deeper halvings of an `f32` box gain nothing.
    pub const DEEPEST: u32 = 20;

    pub(super) fn slots(&mut self) -> Vec<Slot<'_>> {
        vec![
            shared::max_depth(&mut self.max_depth, OctreeRule::DEEPEST),
            shared::min_objects(&mut self.min_objects, 1),
            shared::mailbox(&mut self.mailbox),
        ]
    }
}
