//! The kd-tree, slides 29-41: space cut in two, again and again, by planes across an axis.

mod build;
mod layout;
mod node;
mod reference;
mod split;

pub use layout::{CacheLines, KdLayout, KdMemory, Machine, NodeField, Word};
pub use node::{KdNode, Upright};

use crate::bsp::PlaneTree;
use crate::{Aabb, Axis, NodeId};

/// A kd-tree: every plane stands across an axis.
pub type Kd = PlaneTree<KdNode>;

impl Kd {
    /// The axis that a node's plane stands across, and where; nothing for a leaf.
    pub fn split(&self, node: NodeId) -> Option<(Axis, f32)> {
        self.plane(node).map(|Upright { axis, at }| (axis, at))
    }

    /// The boxes of all nodes. No node stores its box: it follows from the planes above.
    pub fn node_bounds(&self) -> Vec<Aabb> {
        self.spread(self.bounds, |bounds, Upright { axis, at }| bounds.cut(axis, at).into())
    }
}
