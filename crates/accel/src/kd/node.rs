//! A node in eight bytes, as slides 60-62 pack it.

use std::fmt;

use crate::{Axis, NodeId};

/// A node. Four bytes hold the plane's position or the first reference; of the other four, two bits hold
/// the axis or say that the node is a leaf, and thirty bits the first child or the number of references.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) struct Node {
    place: u32,
    tag: u32,
}

/// What a node says when it is unpacked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Kind {
    /// An inner node: a plane and two children.
    Inner { axis: Axis, plane: f32, below: NodeId, above: NodeId },
    /// A leaf: a run of references.
    Leaf { first: u32, count: u32 },
}

impl Node {
    /// The two bits that an axis leaves over.
    const LEAF: u32 = 3;

    /// The most that thirty bits can count.
    pub(super) const MOST: u32 = u32::MAX >> 2;

    /// An inner node whose children are `below` and the node after it.
    pub(super) fn inner(axis: Axis, plane: f32, below: NodeId) -> Node {
        Node { place: plane.to_bits(), tag: below.0 << 2 | axis.index() as u32 }
    }

    /// A leaf with `count` references from `first` on.
    pub(super) fn leaf(first: u32, count: u32) -> Node {
        Node { place: first, tag: count << 2 | Node::LEAF }
    }

    /// Unpacks it.
    #[inline]
    pub(super) fn kind(self) -> Kind {
        let number = self.tag >> 2;
        match self.tag & 3 {
            Node::LEAF => Kind::Leaf { first: self.place, count: number },
            axis => Kind::Inner {
                axis: Axis::ALL[axis as usize],
                plane: f32::from_bits(self.place),
                below: NodeId(number),
                above: NodeId(number + 1),
            },
        }
    }
}

impl fmt::Debug for Node {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.kind().fmt(f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_node_takes_eight_bytes() {
        assert_eq!(size_of::<Node>(), 8);
    }

    #[test]
    fn packing_loses_nothing() {
        for axis in Axis::ALL {
            for plane in [0.0, -0.0, 1.5, -3e38, 1e-45] {
                let below = NodeId(Node::MOST - 1);
                let Kind::Inner { axis: a, plane: p, below: b, above } = Node::inner(axis, plane, below).kind() else {
                    panic!("an inner node became a leaf");
                };
                assert_eq!((a, p.to_bits(), b, above), (axis, f32::to_bits(plane), below, NodeId(Node::MOST)));
            }
        }
        let leaf = Node::leaf(u32::MAX, Node::MOST);
        assert_eq!(leaf.kind(), Kind::Leaf { first: u32::MAX, count: Node::MOST });
    }
}
