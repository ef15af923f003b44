//! A node in eight bytes, as slides 60-62 pack it.

use std::fmt;

use crate::bsp::{Kind, Meeting, Node, Plane, PlaneTest};
use crate::{Axis, Direction, NodeId, Ray, Visit};

/// A plane across an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Upright {
    /// The axis.
    pub axis: Axis,
    /// Where on it.
    pub at: f32,
}

impl Plane for Upright {
    const TEST: PlaneTest = PlaneTest { numbers: 1, products: 0, sums: 1, quotients: 1 };

    fn stand(self) -> (Direction, f32) {
        (self.axis.into(), self.at)
    }

    #[inline]
    fn across(self, ray: &Ray) -> Meeting {
        Meeting { axis: self.axis.into(), plane: self.at, o: ray.o[self.axis], d: ray.d[self.axis] }
    }

    #[inline]
    fn bars(_: &Ray) -> Option<Visit> {
        None
    }
}

/// A node. Four bytes hold the plane's position or the first reference; of the other four, two bits hold
/// the axis or say that the node is a leaf, and thirty bits the first child or the number of references.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct KdNode {
    pub(super) place: u32,
    pub(super) tag: u32,
}

impl KdNode {
    /// The two bits that an axis leaves over.
    const LEAF: u32 = 3;
}

impl Node for KdNode {
    type Plane = Upright;

    /// The most that thirty bits can count.
    const MOST: u32 = u32::MAX >> 2;

    fn inner(Upright { axis, at }: Upright, below: NodeId) -> KdNode {
        KdNode { place: at.to_bits(), tag: below.0 << 2 | axis.index() as u32 }
    }

    fn leaf(first: u32, count: u32) -> KdNode {
        KdNode { place: first, tag: count << 2 | KdNode::LEAF }
    }

    #[inline]
    fn kind(self) -> Kind<Upright> {
        let number = self.tag >> 2;
        let axis = match self.tag & 3 {
            0 => Axis::X,
            1 => Axis::Y,
            2 => Axis::Z,
            _ => return Kind::Leaf { first: self.place, count: number },
        };
        let plane = Upright { axis, at: f32::from_bits(self.place) };
        Kind::Inner { plane, below: NodeId(number), above: NodeId(number + 1) }
    }
}

impl fmt::Debug for KdNode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.kind().fmt(f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_node_takes_eight_bytes() {
        assert_eq!(size_of::<KdNode>(), 8);
    }

    #[test]
    fn packing_loses_nothing() {
        for axis in Axis::ALL {
            for at in [0.0, -0.0, 1.5, -3e38, 1e-45] {
                let below = NodeId(KdNode::MOST - 1);
                let Kind::Inner { plane, below: b, above } = KdNode::inner(Upright { axis, at }, below).kind() else {
                    panic!("an inner node became a leaf");
                };
                let expected = (axis, f32::to_bits(at), below, NodeId(KdNode::MOST));
                assert_eq!((plane.axis, plane.at.to_bits(), b, above), expected);
            }
        }
        let leaf = KdNode::leaf(u32::MAX, KdNode::MOST);
        assert_eq!(leaf.kind(), Kind::Leaf { first: u32::MAX, count: KdNode::MOST });
    }
}
