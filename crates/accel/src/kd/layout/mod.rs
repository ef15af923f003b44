//! A kd-tree's node in four layouts, slides 60-62: what it says stays, what it takes shrinks.
//!
//! The tree itself stores the last of them ([`KdNode`]). The others are written from it, so that a node can be
//! shown with its real bits, and the memory that a ray goes through be counted in cache lines.

mod compact;
mod field;
mod form;
mod lines;
mod memory;
mod paired;
mod plain;
mod shared;

pub use field::{Machine, NodeField, Word};
pub use lines::CacheLines;
pub use memory::KdMemory;

use super::{Kd, KdNode, Upright};
use crate::NodeId;
use crate::bsp::{Kind, Node};
use crate::events::words;
use form::Form;
use memory::Addresses;
use paired::Paired;
use plain::Plain;
use shared::Shared;

words! {
    /// How a node is laid out, from the largest to the smallest.
    pub enum KdLayout {
        /// A field for everything: 25 bytes.
        Plain = "plain",
        /// One pointer for both children: 21 bytes.
        Paired = "paired",
        /// One pointer for children or objects: 12 bytes.
        Shared = "shared",
        /// Numbers instead of pointers, and one for position or first object: 8 bytes.
        Compact = "compact",
    }
}

impl KdLayout {
    /// A node's fields, in order.
    pub fn fields(self) -> &'static [NodeField] {
        match self {
            KdLayout::Plain => Plain::FIELDS,
            KdLayout::Paired => Paired::FIELDS,
            KdLayout::Shared => Shared::FIELDS,
            KdLayout::Compact => KdNode::FIELDS,
        }
    }

    /// How many bytes a node takes, by the rule that compilers lay fields out by.
    pub fn bytes(self, machine: Machine) -> usize {
        machine.places(self.fields()).1
    }

    /// How many bytes the compiler gives a node on this machine, fields kept in order.
    pub const fn bytes_here(self) -> usize {
        match self {
            KdLayout::Plain => size_of::<Plain<usize>>(),
            KdLayout::Paired => size_of::<Paired<usize>>(),
            KdLayout::Shared => size_of::<Shared<usize>>(),
            KdLayout::Compact => size_of::<KdNode>(),
        }
    }

    /// The fields of one node and what stands in them, with addresses in bytes from the root on; none for a tree
    /// that [`KdMemory`] cannot hold.
    pub fn node(self, tree: &Kd, node: NodeId) -> Option<Vec<(&'static NodeField, u32)>> {
        let words = self.words(tree.nodes[node.index()].kind(), &Addresses::of(tree, self)?);
        Some(self.fields().iter().zip(words).collect())
    }

    /// What stands in the fields of a node that says this.
    fn words(self, kind: Kind<Upright>, addresses: &Addresses) -> Vec<u32> {
        match self {
            KdLayout::Plain => Plain::pack(kind, addresses).words().collect(),
            KdLayout::Paired => Paired::pack(kind, addresses).words().collect(),
            KdLayout::Shared => Shared::pack(kind, addresses).words().collect(),
            KdLayout::Compact => KdNode::pack(kind, addresses).words().collect(),
        }
    }

    /// What a node says that has these words in its fields, `next` after `next`.
    fn kind(self, next: impl FnMut() -> u32, addresses: &Addresses) -> Kind<Upright> {
        match self {
            KdLayout::Plain => Plain::read(next).unpack(addresses),
            KdLayout::Paired => Paired::read(next).unpack(addresses),
            KdLayout::Shared => Shared::read(next).unpack(addresses),
            KdLayout::Compact => KdNode::read(next).unpack(addresses),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pointers of either size are as wide, and as aligned, as numbers of that size.
    fn bytes_by_size_of(layout: KdLayout) -> [usize; 2] {
        match layout {
            KdLayout::Plain => [size_of::<Plain<u32>>(), size_of::<Plain<u64>>()],
            KdLayout::Paired => [size_of::<Paired<u32>>(), size_of::<Paired<u64>>()],
            KdLayout::Shared => [size_of::<Shared<u32>>(), size_of::<Shared<u64>>()],
            KdLayout::Compact => [size_of::<KdNode>(); 2],
        }
    }

    #[test]
    fn the_rule_gives_what_the_compiler_gives() {
        for &layout in KdLayout::ALL {
            let by_rule = [Machine::Bits32, Machine::Bits64].map(|machine| layout.bytes(machine));
            assert_eq!(by_rule, bytes_by_size_of(layout), "{layout:?}");
            let here = if size_of::<usize>() == 8 { Machine::Bits64 } else { Machine::Bits32 };
            assert_eq!(layout.bytes(here), layout.bytes_here(), "{layout:?}");
        }
    }
}
