//! The BSP tree, slide 45: space cut in two, again and again, by planes that stand as they like.

mod build;
mod cell;
mod choice;
mod fragment;
mod node;

pub use cell::ConvexCell;
pub use node::{BspNode, FreePlane};

use crate::bsp::{Kind, Node, PlaneTree};
use crate::{Aabb, NodeId};

/// A BSP tree: its planes stand across any direction.
pub type Bsp = PlaneTree<BspNode>;

impl Bsp {
    /// The cells of all nodes. No node stores its cell: it follows from the planes above.
    pub fn cells(&self) -> Vec<ConvexCell> {
        self.spread(ConvexCell::of(&self.bounds), ConvexCell::cut)
    }

    /// The cell of one node.
    pub fn cell(&self, node: NodeId) -> ConvexCell {
        // From the node up to the root: parents come before their children.
        let (mut path, mut child) = (Vec::new(), node);
        for i in (0..node.index()).rev() {
            if let Kind::Inner { plane, below, above } = self.nodes[i].kind()
                && (child == below || child == above)
            {
                path.push((plane, child == above));
                child = NodeId(i as u32);
            }
        }
        // And down again.
        path.into_iter().rev().fold(ConvexCell::of(&self.bounds), |cell, (plane, is_above)| {
            let [below, above] = cell.cut(plane);
            if is_above { above } else { below }
        })
    }

    /// The boxes around the cells of all nodes.
    pub fn node_bounds(&self) -> Vec<Aabb> {
        self.cells().iter().map(ConvexCell::bounds).collect()
    }
}
