//! 12 bytes, slide 61: no node has both children and objects, so they share a pointer, and the small numbers
//! share a word.

use super::{Addresses, Form, NodeField, Word};
use crate::bsp::Kind;
use crate::kd::Upright;
use crate::{Axis, NodeId};

/// A node that points to its first child or to its first object.
#[repr(C)]
pub(super) struct Shared<Pointer> {
    position: f32,
    pointer: Pointer,
    flags: u32,
}

/// The lowest bit of the flags; the axis lies in the two above, and the count above those.
const LEAF: u32 = 1;

impl Form for Shared<u32> {
    const FIELDS: &'static [NodeField] = &[
        NodeField::new("position", Word::Float),
        NodeField::new("children or objects", Word::Pointer),
        NodeField { name: "flags", word: Word::Int, bits: &[("is leaf", 1), ("axis", 2), ("count", 29)] },
    ];

    fn pack(kind: Kind<Upright>, addresses: &Addresses) -> Shared<u32> {
        match kind {
            Kind::Inner { plane: Upright { axis, at }, below, .. } => {
                Shared { position: at, pointer: addresses.of_node(below), flags: (axis.index() as u32) << 1 }
            }
            Kind::Leaf { first, count } => {
                Shared { position: 0.0, pointer: addresses.of_reference(first), flags: count << 3 | LEAF }
            }
        }
    }

    fn unpack(self, addresses: &Addresses) -> Kind<Upright> {
        if self.flags & LEAF != 0 {
            return Kind::Leaf { first: addresses.reference(self.pointer), count: self.flags >> 3 };
        }
        let axis = Axis::ALL[(self.flags >> 1 & 3) as usize];
        let below = addresses.node(self.pointer);
        Kind::Inner { plane: Upright { axis, at: self.position }, below, above: NodeId(below.0 + 1) }
    }

    fn words(self) -> impl Iterator<Item = u32> {
        [self.position.to_bits(), self.pointer, self.flags].into_iter()
    }

    fn read(mut next: impl FnMut() -> u32) -> Shared<u32> {
        Shared { position: f32::from_bits(next()), pointer: next(), flags: next() }
    }
}
