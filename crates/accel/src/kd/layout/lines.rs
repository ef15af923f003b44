//! Which cache lines a ray touches on its way through a tree, slide 62.

use std::collections::BTreeSet;
use std::ops::RangeInclusive;

use crate::{NodeId, Observer, Place, Visit};

/// Counts the cache lines that hold the nodes a ray enters, where nodes lie one after the other and the first
/// begins a line. A node that lies across the border of two lines touches both.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CacheLines {
    node_bytes: usize,
    touched: BTreeSet<usize>,
}

impl CacheLines {
    /// How many bytes a line holds.
    pub const BYTES: usize = 64;

    /// No line is touched yet of nodes with so many bytes each, at least one.
    pub fn new(node_bytes: usize) -> CacheLines {
        CacheLines { node_bytes, touched: BTreeSet::new() }
    }

    /// The lines that a node lies in.
    pub fn of(&self, node: NodeId) -> RangeInclusive<usize> {
        let begin = node.index() * self.node_bytes;
        let last = begin + self.node_bytes - 1;
        begin / Self::BYTES..=last / Self::BYTES
    }

    /// The lines touched so far, by their numbers.
    pub fn touched(&self) -> &BTreeSet<usize> {
        &self.touched
    }
}

impl Observer<Visit> for CacheLines {
    fn on(&mut self, event: Visit) {
        if let Visit::Enter { place: Place::Node(node), .. } = event {
            let lines = self.of(node);
            self.touched.extend(lines);
        }
    }
}
