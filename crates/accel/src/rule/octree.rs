//! How an octree is to be built.

use super::parameter::{Field, Slot};
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
            Slot {
                key: "max_depth",
                about: "nodes this deep stay leaves",
                field: Field::Count(&mut self.max_depth, 0, OctreeRule::DEEPEST),
            },
            Slot {
                key: "min_objects",
                about: "nodes with so few primitives stay leaves",
                field: Field::Count(&mut self.min_objects, 1, 1000),
            },
            Slot {
                key: "mailbox",
                about: "remember which primitives this ray has tested",
                field: Field::Flag(&mut self.mailbox),
            },
        ]
    }
}
