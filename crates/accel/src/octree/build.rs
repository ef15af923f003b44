//! Building an octree, slide 43: the bounding box, then eight equal cells, until few enough or deep enough.

use super::{Node, Octree};
use crate::events::patiently;
use crate::{
    Aabb, Cancelled, Grow, LeafReason, Margin, NodeId, Observer, OctreeRule, Place, PrimId, Primitives, around,
};

impl Octree {
    /// Builds the tree over all primitives.
    ///
    /// # Errors
    /// `watch` asked to give up.
    pub fn build(
        prims: &impl Primitives,
        rule: &OctreeRule,
        watch: &mut impl Observer<Grow>,
    ) -> Result<Octree, Cancelled> {
        // Compute the bounding box.
        let bounds = around(prims, watch)?;
        let everything = (0..prims.len() as u32).map(PrimId).collect();
        let mut tree = Octree {
            bounds,
            margin: Margin::of(&bounds, prims.len()),
            rule: *rule,
            nodes: vec![Node::Leaf(everything)],
            refs: prims.len(),
            most_refs: 64 * prims.len() + (1 << 16),
            free: Vec::new(),
        };
        tree.grow(prims, NodeId::ROOT, bounds, 0, watch)?;
        watch.on(Grow::End { nodes: tree.nodes.len() as u32, cells: 0, references: tree.refs as u32 });
        Ok(tree)
    }

    /// Divides a leaf and its children until each holds few enough primitives or is deep enough.
    pub(super) fn grow(
        &mut self,
        prims: &impl Primitives,
        from: NodeId,
        cell: Aabb,
        depth: u32,
        watch: &mut impl Observer<Grow>,
    ) -> Result<(), Cancelled> {
        // All leaves below may refer to what is still free.
        let room = self.most_refs.saturating_sub(self.refs - self.leaf_prims(from).len());
        let mut open = vec![(from, cell, depth, room)];
        while let Some((node, cell, depth, room)) = open.pop() {
            if watch.cancelled() {
                return Err(Cancelled);
            }
            let held = self.leaf_prims(node).len() as u32;
            watch.on(Grow::Open { node, bounds: cell, prims: held, depth });

            // Termination criteria: few objects, or deep enough.
            if held <= self.rule.min_objects {
                self.settle(node, LeafReason::Few, watch);
                continue;
            }
            if depth >= self.rule.max_depth {
                self.settle(node, LeafReason::Deep, watch);
                continue;
            }

            // Eight equal cells; a primitive goes to each that it overlaps.
            let dealt = self.deal(prims, node, &cell, watch)?;
            let references: usize = dealt.iter().map(Vec::len).sum();
            if references > room {
                self.settle(node, LeafReason::Crowded, watch);
                continue;
            }
            // Children share their parent's room, so that one crowded corner does not take it from all others.
            let share = |held: &Vec<PrimId>| (room as u64 * held.len() as u64 / references.max(1) as u64) as usize;
            let shares: Vec<usize> = dealt.iter().map(share).collect();
            let first = self.divide(node, dealt);
            watch.on(Grow::Divide {
                node,
                first,
                ways: self.ways(),
                at_x: cell.center().x,
                at_y: cell.center().y,
                at_z: cell.center().z,
            });
            for (number, room) in (0..self.ways()).zip(shares).rev() {
                open.push((NodeId(first.0 + number), self.child_cell(&cell, number), depth + 1, room));
            }
        }
        Ok(())
    }

    /// A node that is to be divided no more.
    pub(super) fn settle(&self, node: NodeId, why: LeafReason, watch: &mut impl Observer<Grow>) {
        let held = self.leaf_prims(node);
        watch.on(Grow::Leaf { node, prims: held.len() as u32, why });
        for &prim in held {
            watch.on(Grow::Settle { prim, place: Place::Node(node) });
        }
    }

    /// What of a leaf's primitives would belong to each of its children.
    fn deal(
        &self,
        prims: &impl Primitives,
        node: NodeId,
        cell: &Aabb,
        watch: &impl Observer<Grow>,
    ) -> Result<Vec<Vec<PrimId>>, Cancelled> {
        let children: Vec<Aabb> = (0..self.ways()).map(|number| self.child_cell(cell, number)).collect();
        let mut dealt = vec![Vec::new(); children.len()];
        for prim in patiently(self.leaf_prims(node), watch) {
            let &prim = prim?;
            for (child, held) in children.iter().zip(&mut dealt) {
                if self.overlaps(prims, prim, child) {
                    held.push(prim);
                }
            }
        }
        Ok(dealt)
    }

    /// Makes a leaf an inner node whose children refer to what was dealt to them.
    fn divide(&mut self, node: NodeId, dealt: Vec<Vec<PrimId>>) -> NodeId {
        let first = self.block();
        self.refs -= self.leaf_prims(node).len();
        self.nodes[node.index()] = Node::Inner(first);
        for (child, held) in self.nodes[first.index()..].iter_mut().zip(dealt) {
            self.refs += held.len();
            *child = Node::Leaf(held);
        }
        first
    }

    /// Whether a primitive belongs to a cell: rounding needs a margin around it.
    pub(super) fn overlaps(&self, prims: &impl Primitives, prim: PrimId, cell: &Aabb) -> bool {
        prims.overlaps(prim, &cell.padded(self.margin.pad))
    }

    /// Room for one node's children: a block that was given back, or a new one.
    fn block(&mut self) -> NodeId {
        self.free.pop().unwrap_or_else(|| {
            let first = NodeId(self.nodes.len() as u32);
            self.nodes.extend((0..self.ways()).map(|_| Node::Leaf(Vec::new())));
            first
        })
    }
}
