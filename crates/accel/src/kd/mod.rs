//! The kd-tree, slides 29-41: space cut in two, again and again, by planes across an axis.

mod build;
mod node;
mod reference;
mod split;
mod walk;

pub(crate) use walk::{Part, Stack, enter, split};

use node::{Kind, Node};

use crate::{Aabb, Axis, Margin, NodeId, PrimId};

/// A kd-tree. Only leaves refer to primitives; a primitive that lies on both sides of a plane is referred
/// to from both. Siblings are neighbours in the array of nodes.
#[derive(Clone, Debug, PartialEq)]
pub struct Kd {
    bounds: Aabb,
    pub(crate) margin: Margin,
    pub(crate) mailbox: bool,
    nodes: Vec<Node>,
    /// The references of all leaves, one leaf after the other.
    refs: Vec<PrimId>,
}

impl Kd {
    /// The deepest a tree can be; the root has depth 0.
    pub const DEEPEST: usize = crate::KdRule::DEEPEST as usize;

    /// The box around all primitives, which is the root's; empty if there are none.
    pub fn bounds(&self) -> Aabb {
        self.bounds
    }

    /// The number of nodes, leaves included; 1 if there are no primitives.
    pub fn node_count(&self) -> usize {
        self.nodes.len()
    }

    /// The number of references from leaves to primitives.
    pub fn reference_count(&self) -> usize {
        self.refs.len()
    }

    /// A node's children, the one below its plane first, or nothing for a leaf.
    pub fn children(&self, node: NodeId) -> Option<[NodeId; 2]> {
        match self.nodes[node.index()].kind() {
            Kind::Inner { below, above, .. } => Some([below, above]),
            Kind::Leaf { .. } => None,
        }
    }

    /// The plane across a node, or nothing for a leaf.
    pub fn split(&self, node: NodeId) -> Option<(Axis, f32)> {
        match self.nodes[node.index()].kind() {
            Kind::Inner { axis, plane, .. } => Some((axis, plane)),
            Kind::Leaf { .. } => None,
        }
    }

    /// The primitives that a leaf refers to; empty for inner nodes.
    pub fn leaf_prims(&self, node: NodeId) -> &[PrimId] {
        match self.nodes[node.index()].kind() {
            Kind::Inner { .. } => &[],
            Kind::Leaf { first, count } => &self.refs[first as usize..(first + count) as usize],
        }
    }

    /// The boxes of all nodes. No node stores its box: it follows from the planes above.
    pub fn node_bounds(&self) -> Vec<Aabb> {
        let mut bounds = vec![self.bounds; self.nodes.len()];
        // Parents come before their children.
        for (i, node) in self.nodes.iter().enumerate() {
            if let Kind::Inner { axis, plane, below, above } = node.kind() {
                (bounds[below.index()], bounds[above.index()]) = bounds[i].cut(axis, plane);
            }
        }
        bounds
    }

    /// How much memory it takes.
    pub fn bytes(&self) -> usize {
        size_of::<Kd>() + size_of_val(&*self.nodes) + size_of_val(&*self.refs)
    }
}
