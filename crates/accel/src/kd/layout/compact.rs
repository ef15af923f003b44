//! 8 bytes, slide 62: nothing stands in a node that it does not need, and numbers instead of pointers. It is
//! how the tree itself stores its nodes.

use super::{Addresses, Form, NodeField, Word};
use crate::bsp::{Kind, Node};
use crate::kd::{KdNode, Upright};

impl Form for KdNode {
    const FIELDS: &'static [NodeField] = &[
        NodeField::new("position or first object", Word::Int),
        NodeField { name: "tag", word: Word::Int, bits: &[("axis or leaf", 2), ("child or count", 30)] },
    ];

    fn pack(kind: Kind<Upright>, _: &Addresses) -> KdNode {
        match kind {
            Kind::Inner { plane, below, .. } => KdNode::inner(plane, below),
            Kind::Leaf { first, count } => KdNode::leaf(first, count),
        }
    }

    fn unpack(self, _: &Addresses) -> Kind<Upright> {
        self.kind()
    }

    fn words(self) -> impl Iterator<Item = u32> {
        [self.place, self.tag].into_iter()
    }

    fn read(mut next: impl FnMut() -> u32) -> KdNode {
        KdNode { place: next(), tag: next() }
    }
}
