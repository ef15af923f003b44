//! The octree of slides 43 and 44: every cell is halved along all axes at once. In a flat scene, a quadtree.

mod build;
mod change;
mod walk;

pub use change::{Change, Outside};

use crate::{Aabb, Margin, NodeId, OctreeRule, PrimId};

/// A tree of cells, each cut through its middle into eight (flat: four) equal children.
///
/// Nodes are leaves exactly when they hold at most `min_objects` primitives or lie at `max_depth`. That
/// depends on the primitives alone and not on the order in which they came, so a tree that is changed is
/// the tree that would have been built (unless a hostile scene met the bound on references).
#[derive(Clone, Debug, PartialEq)]
pub struct Octree {
    bounds: Aabb,
    margin: Margin,
    rule: OctreeRule,
    nodes: Vec<Node>,
    /// How many references all leaves hold.
    refs: usize,
    /// How many they may hold at most: what keeps hostile scenes bounded. Children share their parent's room.
    most_refs: usize,
    /// First nodes of blocks of children that a deletion gave back.
    free: Vec<NodeId>,
}

/// A node: where its children begin, or what it refers to.
#[derive(Clone, Debug, PartialEq)]
enum Node {
    /// The children lie side by side from here: bit `i` of a child's number says upper half of axis `i`.
    Inner(NodeId),
    /// The primitives that overlap the cell, by id.
    Leaf(Vec<PrimId>),
}

impl Octree {
    /// The cell of the root.
    pub fn bounds(&self) -> Aabb {
        self.bounds
    }

    /// How many nodes there are, given-back ones included: ids run below this.
    pub fn node_count(&self) -> usize {
        self.nodes.len()
    }

    /// The children of a node: eight, four, or none of a leaf.
    pub fn children(&self, node: NodeId) -> Vec<NodeId> {
        match &self.nodes[node.index()] {
            Node::Inner(first) => (0..self.ways()).map(|child| NodeId(first.0 + child)).collect(),
            Node::Leaf(_) => Vec::new(),
        }
    }

    /// What a leaf refers to, by id; nothing in an inner node.
    pub fn leaf_prims(&self, node: NodeId) -> &[PrimId] {
        match &self.nodes[node.index()] {
            Node::Inner(_) => &[],
            Node::Leaf(prims) => prims,
        }
    }

    /// The cells of all nodes, by id; empty boxes for nodes that were given back.
    pub fn node_bounds(&self) -> Vec<Aabb> {
        let mut cells = vec![Aabb::EMPTY; self.nodes.len()];
        let mut open = vec![(NodeId::ROOT, self.bounds)];
        while let Some((node, cell)) = open.pop() {
            cells[node.index()] = cell;
            let children = self.children(node).into_iter().zip(0..);
            open.extend(children.map(|(child, number)| (child, self.child_cell(&cell, number))));
        }
        cells
    }

    /// How many bytes the structure's arrays take.
    pub fn bytes(&self) -> usize {
        size_of_val(self.nodes.as_slice()) + self.refs * size_of::<PrimId>()
    }

    /// How many children an inner node has.
    fn ways(&self) -> u32 {
        1 << self.rule.axes.list().len()
    }

    /// The cell of child `number` of a node with this cell.
    fn child_cell(&self, cell: &Aabb, number: u32) -> Aabb {
        let middle = cell.center();
        self.rule.axes.list().iter().fold(*cell, |child, &axis| {
            let (lower, upper) = child.cut(axis, middle[axis]);
            if number >> axis.index() & 1 == 0 { lower } else { upper }
        })
    }
}
