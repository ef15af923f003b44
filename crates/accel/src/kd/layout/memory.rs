//! A whole tree as bytes: its nodes one after the other, then what its leaves refer to.

use super::{KdLayout, Machine, NodeField};
use crate::bsp::{Kind, Node};
use crate::kd::{Kd, Upright};
use crate::{Axis, NodeId, PrimId};

/// How many bytes a reference takes.
const REFERENCE: usize = size_of::<PrimId>();

/// Where things lie, in bytes from the root on. Nothing points to the root, so 0 stands for a pointer to
/// nothing.
pub(super) struct Addresses {
    node_bytes: u32,
    references: u32,
}

impl Addresses {
    /// Where the parts of a tree lie; none if it takes half of all addresses and more.
    pub(super) fn of(tree: &Kd, layout: KdLayout) -> Option<Addresses> {
        let node_bytes = layout.bytes(Machine::Printed);
        let references = (tree.nodes.len() * node_bytes).next_multiple_of(REFERENCE);
        let all = references + tree.refs.len() * REFERENCE;
        let fits = all <= i32::MAX as usize;
        fits.then_some(Addresses { node_bytes: node_bytes as u32, references: references as u32 })
    }

    pub(super) fn of_node(&self, node: NodeId) -> u32 {
        node.0 * self.node_bytes
    }

    pub(super) fn node(&self, address: u32) -> NodeId {
        NodeId(address / self.node_bytes)
    }

    pub(super) fn of_reference(&self, reference: u32) -> u32 {
        self.references + reference * REFERENCE as u32
    }

    pub(super) fn reference(&self, address: u32) -> u32 {
        (address - self.references) / REFERENCE as u32
    }
}

/// A kd-tree in the memory of a machine with pointers of 32 bits, packed in one of the four layouts, the lowest
/// byte of a number first.
pub struct KdMemory {
    layout: KdLayout,
    addresses: Addresses,
    bytes: Vec<u8>,
}

impl KdMemory {
    /// Writes a tree down; none if it takes half of all addresses and more.
    pub fn of(tree: &Kd, layout: KdLayout) -> Option<KdMemory> {
        let addresses = Addresses::of(tree, layout)?;
        let references = addresses.references as usize;
        let mut bytes = Vec::with_capacity(references + tree.refs.len() * REFERENCE);
        for node in &tree.nodes {
            for (field, word) in layout.fields().iter().zip(layout.words(node.kind(), &addresses)) {
                bytes.extend(&word.to_le_bytes()[..Machine::Printed.bytes(field.word)]);
            }
        }
        // References are read in one access each, and so begin at a multiple of their size.
        bytes.resize(references, 0);
        bytes.extend(tree.refs.iter().flat_map(|prim| prim.0.to_le_bytes()));
        Some(KdMemory { layout, addresses, bytes })
    }

    /// All of it.
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// The bytes of one node.
    pub fn node(&self, node: NodeId) -> &[u8] {
        &self.bytes[self.addresses.of_node(node) as usize..][..self.addresses.node_bytes as usize]
    }

    /// The fields of one node and what stands in them.
    pub fn fields(&self, node: NodeId) -> impl Iterator<Item = (&'static NodeField, u32)> {
        let mut bytes = self.node(node);
        self.layout.fields().iter().map(move |field| {
            let (own, rest) = bytes.split_at(Machine::Printed.bytes(field.word));
            bytes = rest;
            (field, number(own))
        })
    }

    /// The axis that a node's plane stands across, and where; nothing for a leaf.
    pub fn split(&self, node: NodeId) -> Option<(Axis, f32)> {
        match self.kind(node) {
            Kind::Inner { plane: Upright { axis, at }, .. } => Some((axis, at)),
            Kind::Leaf { .. } => None,
        }
    }

    /// A node's children, the one below its plane first, or nothing for a leaf.
    pub fn children(&self, node: NodeId) -> Option<[NodeId; 2]> {
        match self.kind(node) {
            Kind::Inner { below, above, .. } => Some([below, above]),
            Kind::Leaf { .. } => None,
        }
    }

    /// The primitives that a leaf refers to; empty for inner nodes.
    pub fn leaf_prims(&self, node: NodeId) -> Vec<PrimId> {
        let (first, count) = match self.kind(node) {
            Kind::Inner { .. } => (0, 0),
            Kind::Leaf { first, count } => (first, count),
        };
        let run = &self.bytes[self.addresses.of_reference(first) as usize..][..count as usize * REFERENCE];
        run.chunks_exact(REFERENCE).map(|prim| PrimId(number(prim))).collect()
    }

    /// What is written at a node.
    fn kind(&self, node: NodeId) -> Kind<Upright> {
        let mut fields = self.fields(node);
        self.layout.kind(|| fields.next().map_or(0, |(_, word)| word), &self.addresses)
    }
}

/// The number that some bytes say, the lowest byte first.
fn number(bytes: &[u8]) -> u32 {
    bytes.iter().rev().fold(0, |number, byte| number << 8 | u32::from(*byte))
}
