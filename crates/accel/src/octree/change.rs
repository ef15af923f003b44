//! Inserting and deleting single primitives, slide 44: only the cells that a primitive overlaps are touched.

use super::{Node, Octree};
use crate::{Aabb, Cancelled, Each, Grow, LeafReason, NodeId, Observer, Place, PrimId, Primitives};

/// What is done to a finished tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Change {
    /// A primitive comes to it.
    Insert(PrimId),
    /// A primitive is taken out of it.
    Delete(PrimId),
}

impl Change {
    /// The primitive that comes or goes.
    pub fn prim(self) -> PrimId {
        match self {
            Change::Insert(prim) | Change::Delete(prim) => prim,
        }
    }
}

/// The primitive does not lie in the root's cell: the tree must be built again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Outside;

impl std::fmt::Display for Outside {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("the primitive reaches out of the octree's root cell: build the tree again")
    }
}

impl std::error::Error for Outside {}

impl Octree {
    /// Inserts or deletes.
    ///
    /// # Errors
    /// The primitive to be inserted reaches out of the root's cell; the tree stays as it was.
    pub fn change(
        &mut self,
        prims: &impl Primitives,
        change: Change,
        watch: &mut impl Observer<Grow>,
    ) -> Result<(), Outside> {
        match change {
            Change::Insert(prim) => self.insert(prims, prim, watch)?,
            Change::Delete(prim) => self.remove(prims, prim, watch),
        }
        watch.on(Grow::End { nodes: self.live_count() as u32, cells: 0, references: self.refs as u32 });
        Ok(())
    }

    /// How many nodes hang in the tree; those given back do not.
    fn live_count(&self) -> usize {
        self.nodes.len() - self.free.len() * self.ways() as usize
    }

    /// Adds a reference to `prim` wherever it belongs; leaves that become too full are divided.
    /// Every node that is looked at is told as [`Grow::Touch`].
    ///
    /// # Errors
    /// The primitive reaches out of the root's cell; the tree stays as it was.
    pub fn insert(
        &mut self,
        prims: &impl Primitives,
        prim: PrimId,
        watch: &mut impl Observer<Grow>,
    ) -> Result<(), Outside> {
        if !self.bounds.encloses(&prims.bounds(prim)) {
            return Err(Outside);
        }
        let mut open = vec![(NodeId::ROOT, self.bounds, 0)];
        while let Some((node, cell, depth)) = open.pop() {
            watch.on(Grow::Touch { node });
            match &mut self.nodes[node.index()] {
                Node::Inner(first) => {
                    let first = *first;
                    for (number, child) in self.overlapped(prims, prim, &cell) {
                        open.push((NodeId(first.0 + number), child, depth + 1));
                    }
                }
                Node::Leaf(held) => {
                    let Err(at) = held.binary_search(&prim) else { continue };
                    held.insert(at, prim);
                    self.refs += 1;
                    // Too full, and not too deep: it is divided as when the tree was built.
                    if held.len() as u32 > self.rule.min_objects && depth < self.rule.max_depth {
                        // A change is small: it is never given up half way.
                        let mut whole = Each(|event| watch.on(event));
                        let (Ok(()) | Err(Cancelled)) = self.grow(prims, node, cell, depth, &mut whole);
                    } else {
                        watch.on(Grow::Settle { prim, place: Place::Node(node) });
                    }
                }
            }
        }
        Ok(())
    }

    /// Removes every reference to `prim`; inner nodes that hold few enough primitives become leaves.
    /// Every node that is looked at is told as [`Grow::Touch`], every reference that goes as [`Grow::Remove`].
    pub fn remove(&mut self, prims: &impl Primitives, prim: PrimId, watch: &mut impl Observer<Grow>) {
        // Downwards: drop the references, remember the inner nodes on the way.
        let mut inner = Vec::new();
        let mut open = vec![(NodeId::ROOT, self.bounds)];
        while let Some((node, cell)) = open.pop() {
            watch.on(Grow::Touch { node });
            match &mut self.nodes[node.index()] {
                Node::Inner(first) => {
                    let first = *first;
                    inner.push(node);
                    for (number, child) in self.overlapped(prims, prim, &cell) {
                        open.push((NodeId(first.0 + number), child));
                    }
                }
                Node::Leaf(held) => {
                    if let Ok(at) = held.binary_search(&prim) {
                        held.remove(at);
                        self.refs -= 1;
                        watch.on(Grow::Remove { prim, place: Place::Node(node) });
                    }
                }
            }
        }
        // Upwards: children come after their parents.
        for node in inner.into_iter().rev() {
            self.merge(node, watch);
        }
    }

    /// Makes an inner node a leaf if all its children are leaves that hold few enough primitives together.
    fn merge(&mut self, node: NodeId, watch: &mut impl Observer<Grow>) {
        let Node::Inner(first) = self.nodes[node.index()] else { return };
        let block = first.index()..first.index() + self.ways() as usize;
        let mut held = Vec::new();
        for child in &self.nodes[block.clone()] {
            let Node::Leaf(prims) = child else { return };
            held.extend_from_slice(prims);
        }
        let copies = held.len();
        held.sort_unstable();
        held.dedup();
        if held.len() as u32 <= self.rule.min_objects {
            self.refs -= copies - held.len();
            self.nodes[block].fill(Node::Leaf(Vec::new()));
            self.nodes[node.index()] = Node::Leaf(held);
            self.free.push(first);
            self.settle(node, LeafReason::Few, watch);
        }
    }

    /// The numbers and cells of the children that a primitive overlaps.
    fn overlapped(&self, prims: &impl Primitives, prim: PrimId, cell: &Aabb) -> Vec<(u32, Aabb)> {
        (0..self.ways())
            .map(|number| (number, self.child_cell(cell, number)))
            .filter(|(_, child)| self.overlaps(prims, prim, child))
            .collect()
    }
}
