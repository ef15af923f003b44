//! What the tree consists of, for machines that walk it by themselves.

use raystep_accel::{Aabb, PrimId, Triangle};

use super::{Bvh2, node::Child};

/// What is below one side of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Below {
    /// The node of this number.
    Node(usize),
    /// The leaf of this number.
    Leaf(usize),
}

impl Bvh2 {
    /// The largest coordinate of the scene, without its sign.
    pub fn reach(&self) -> f32 {
        self.reach
    }

    /// The nodes, parents before children, the root first: the box of each side and what is below it. A side is empty
    /// only where the whole scene fits in one leaf.
    pub fn nodes(&self) -> impl Iterator<Item = [Option<(Aabb, Below)>; 2]> {
        let below =
            |child: Child| if child.is_leaf() { Below::Leaf(child.index()) } else { Below::Node(child.index()) };
        self.nodes.iter().map(move |node| {
            [0, 1].map(|side| {
                let bounds = node.bounds(side);
                (!bounds.is_empty()).then(|| (bounds, below(node.children[side])))
            })
        })
    }

    /// The leaves: the one to four triangles of each.
    pub fn leaves(&self) -> impl Iterator<Item = impl ExactSizeIterator<Item = (PrimId, Triangle)>> {
        self.leaves
            .iter()
            .map(|four| (0..four.count() as usize).map(move |lane| (PrimId(four.prim(lane)), four.triangle(lane))))
    }
}
