//! A node in eight bytes, as slides 60-62 pack it.

use raystep_accel::Axis;

/// Four bytes hold the place of the plane, or the number of the first four triangles; of the other four, two bits hold
/// the axis or say that the node is a leaf, and thirty the first child, or how many fours there are.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    place: u32,
    tag: u32,
}

/// The two bits that an axis leaves over.
const LEAF: u32 = 3;

impl Node {
    pub(super) fn inner(axis: Axis, at: f32, below: u32) -> Node {
        Node { place: at.to_bits(), tag: below << 2 | axis.index() as u32 }
    }

    pub(super) fn leaf(first: usize, fours: usize) -> Node {
        assert!(first < u32::MAX as usize && fours < 1 << 30, "more leaves than can be told apart");
        Node { place: first as u32, tag: (fours as u32) << 2 | LEAF }
    }

    /// The axis of an inner node.
    #[inline(always)]
    pub(super) fn axis(self) -> Option<usize> {
        let axis = self.tag & 3;
        (axis != LEAF).then_some(axis as usize)
    }

    /// Where the plane of an inner node stands.
    #[inline(always)]
    pub(super) fn plane(self) -> f32 {
        f32::from_bits(self.place)
    }

    /// The child below the plane of an inner node; the one above it is the next.
    #[inline(always)]
    pub(super) fn below(self) -> u32 {
        self.tag >> 2
    }

    /// The fours of a leaf.
    #[inline(always)]
    pub(super) fn fours(self) -> std::ops::Range<usize> {
        let first = self.place as usize;
        first..first + (self.tag >> 2) as usize
    }
}

#[test]
fn a_node_takes_eight_bytes() {
    assert_eq!(size_of::<Node>(), 8);
}
