//! 21 bytes, slide 61: siblings lie side by side, so one pointer finds both.

use super::{Addresses, Form, NodeField, Word};
use crate::bsp::Kind;
use crate::kd::Upright;
use crate::{Axis, NodeId};

/// A node that knows where its first child lies.
#[repr(C)]
pub(super) struct Paired<Pointer> {
    axis: u32,
    position: f32,
    children: Pointer,
    leaf: bool,
    objects: Pointer,
    count: u32,
}

impl Form for Paired<u32> {
    const FIELDS: &'static [NodeField] = &[
        NodeField::new("axis", Word::Int),
        NodeField::new("position", Word::Float),
        NodeField::new("children", Word::Pointer),
        NodeField::new("is leaf", Word::Flag),
        NodeField::new("objects", Word::Pointer),
        NodeField::new("count", Word::Int),
    ];

    fn pack(kind: Kind<Upright>, addresses: &Addresses) -> Paired<u32> {
        let none = Paired { axis: 0, position: 0.0, children: 0, leaf: false, objects: 0, count: 0 };
        match kind {
            Kind::Inner { plane: Upright { axis, at }, below, .. } => {
                Paired { axis: axis.index() as u32, position: at, children: addresses.of_node(below), ..none }
            }
            Kind::Leaf { first, count } => Paired { leaf: true, objects: addresses.of_reference(first), count, ..none },
        }
    }

    fn unpack(self, addresses: &Addresses) -> Kind<Upright> {
        if self.leaf {
            return Kind::Leaf { first: addresses.reference(self.objects), count: self.count };
        }
        let plane = Upright { axis: Axis::ALL[self.axis as usize], at: self.position };
        let below = addresses.node(self.children);
        Kind::Inner { plane, below, above: NodeId(below.0 + 1) }
    }

    fn words(self) -> impl Iterator<Item = u32> {
        let Paired { axis, position, children, leaf, objects, count } = self;
        [axis, position.to_bits(), children, leaf.into(), objects, count].into_iter()
    }

    fn read(mut next: impl FnMut() -> u32) -> Paired<u32> {
        Paired {
            axis: next(),
            position: f32::from_bits(next()),
            children: next(),
            leaf: next() == 1,
            objects: next(),
            count: next(),
        }
    }
}
