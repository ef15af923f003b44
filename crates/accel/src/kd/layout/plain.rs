//! 25 bytes, slide 60: a field for everything, whether the node is one that needs it or not.

use super::{Addresses, Form, NodeField, Word};
use crate::Axis;
use crate::bsp::Kind;
use crate::kd::Upright;

/// A node with two children and an array of objects, of which it has one or the other.
#[repr(C)]
pub(super) struct Plain<Pointer> {
    axis: u32,
    position: f32,
    left: Pointer,
    right: Pointer,
    leaf: bool,
    objects: Pointer,
    count: u32,
}

impl Form for Plain<u32> {
    const FIELDS: &'static [NodeField] = &[
        NodeField::new("axis", Word::Int),
        NodeField::new("position", Word::Float),
        NodeField::new("left child", Word::Pointer),
        NodeField::new("right child", Word::Pointer),
        NodeField::new("is leaf", Word::Flag),
        NodeField::new("objects", Word::Pointer),
        NodeField::new("count", Word::Int),
    ];

    fn pack(kind: Kind<Upright>, addresses: &Addresses) -> Plain<u32> {
        let none = Plain { axis: 0, position: 0.0, left: 0, right: 0, leaf: false, objects: 0, count: 0 };
        match kind {
            Kind::Inner { plane: Upright { axis, at }, below, above } => Plain {
                axis: axis.index() as u32,
                position: at,
                left: addresses.of_node(below),
                right: addresses.of_node(above),
                ..none
            },
            Kind::Leaf { first, count } => Plain { leaf: true, objects: addresses.of_reference(first), count, ..none },
        }
    }

    fn unpack(self, addresses: &Addresses) -> Kind<Upright> {
        if self.leaf {
            return Kind::Leaf { first: addresses.reference(self.objects), count: self.count };
        }
        Kind::Inner {
            plane: Upright { axis: Axis::ALL[self.axis as usize], at: self.position },
            below: addresses.node(self.left),
            above: addresses.node(self.right),
        }
    }

    fn words(self) -> impl Iterator<Item = u32> {
        let Plain { axis, position, left, right, leaf, objects, count } = self;
        [axis, position.to_bits(), left, right, leaf.into(), objects, count].into_iter()
    }

    fn read(mut next: impl FnMut() -> u32) -> Plain<u32> {
        Plain {
            axis: next(),
            position: f32::from_bits(next()),
            left: next(),
            right: next(),
            leaf: next() == 1,
            objects: next(),
            count: next(),
        }
    }
}
