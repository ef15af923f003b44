//! The kd-tree, slides 28-42: space cut in two, again and again, by planes across an axis.
//!
//! It is the special case of a BSP tree, so what holds for any plane stands in [`bsp`](crate::bsp). In the order of
//! the lecture:
//!
//! | slide | what | where |
//! |---|---|---|
//! | 29 | the box around everything | `common/around.rs` |
//! | 30 | **the builder**: stop, or split and deal out | `bsp/build.rs`, the loop of `PlaneTree::grow` |
//! | 30 | where to cut: middle, median, least cost | `kd/split.rs` |
//! | 30 | what lies on which side of the cut | `kd/build.rs`, `kd/reference.rs` |
//! | 31 | the binary tree: only leaves refer to geometry | `bsp/mod.rs`, `PlaneTree` |
//! | 32 | what a node holds | `kd/node.rs`, `Upright` and `KdNode` |
//! | 33-38 | **the walk**: inner node, split the interval; leaf, intersect | `bsp/walk.rs`, `PlaneTree::find` and `split` |
//! | 34-38 | what waits, and when it is dropped | `common/stack.rs` |
//! | 60-62 | the node in 25, 21, 12 and 8 bytes | `kd/layout` |

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
