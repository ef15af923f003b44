//! Building a hierarchy. From the top, slide 53: sets are divided by their boxes, then each gets its volume.

use super::sapling::Sapling;
use super::splitter::{Part, Splitter};
use super::{Bvh, BvhNode, SAH_DEPTH, bottom_up, insertion, ploc};
use crate::events::{Unheard, patiently};
use crate::{
    Aabb, BvhBuilder, BvhRule, Cancelled, Grow, LeafReason, NodeId, Observer, PrimId, Primitives, Volume, around,
};

/// A node that is still to be split or to become a leaf.
struct Task {
    node: NodeId,
    part: Part,
    depth: usize,
}

impl<V: Volume> Bvh<V> {
    /// Builds a hierarchy over `prims`.
    ///
    /// # Errors
    /// The observer cancelled it.
    pub fn over<P: Primitives, W: Observer<Grow>>(prims: &P, rule: &BvhRule, watch: &mut W) -> Result<Self, Cancelled> {
        // The box around all, and each one's own.
        let all = around(prims, watch)?;
        let own = patiently((0..prims.len() as u32).map(PrimId), watch).map(|prim| Ok(prims.bounds(prim?)));
        let boxes = own.collect::<Result<Vec<Aabb>, _>>()?;
        let mut bvh = Bvh { bounds: all, nodes: Vec::new(), refs: Vec::with_capacity(prims.len()), order: rule.order };
        if prims.is_empty() {
            return Ok(bvh);
        }
        match rule.builder {
            BvhBuilder::TopDown => bvh.divide(prims, rule, boxes, watch)?,
            BvhBuilder::BottomUp => bvh.put_together(prims, rule, boxes, bottom_up::join_all, watch)?,
            BvhBuilder::Ploc => bvh.put_together(prims, rule, boxes, ploc::join_all, watch)?,
            BvhBuilder::Insertion => bvh.put_together(prims, rule, boxes, insertion::insert_all, watch)?,
        }
        watch.on(Grow::End { nodes: bvh.nodes.len() as u32, cells: 0, references: bvh.refs.len() as u32 });
        Ok(bvh)
    }

    /// By joining sets; then the tree is laid out.
    fn put_together<P: Primitives, W: Observer<Grow>>(
        &mut self,
        prims: &P,
        rule: &BvhRule,
        boxes: Vec<Aabb>,
        join_all: impl FnOnce(&mut Sapling<'_, V::Draft, P>, &mut W) -> Result<u32, Cancelled>,
        watch: &mut W,
    ) -> Result<(), Cancelled> {
        let mut tree = Sapling::new(prims, boxes, rule);
        let root = join_all(&mut tree, watch)?;
        tree.plant(root, self, watch)
    }

    /// From the top.
    fn divide(
        &mut self,
        prims: &impl Primitives,
        rule: &BvhRule,
        boxes: Vec<Aabb>,
        watch: &mut impl Observer<Grow>,
    ) -> Result<(), Cancelled> {
        let mut splitter = Splitter::new(rule, boxes, watch)?;

        // Split nodes until they are small enough, those below before those above.
        let whole = splitter.whole(self.bounds);
        let root = self.add(prims, &splitter, &whole, watch)?;
        let mut waiting = vec![Task { node: root, part: whole, depth: 0 }];
        while let Some(Task { node, part, depth }) = waiting.pop() {
            if watch.cancelled() {
                return Err(Cancelled);
            }
            let count = part.len() as u32;
            watch.on(Grow::Open { node, bounds: self.volume(node).bounds(), prims: count, depth: depth as u32 });

            // Few enough: a leaf.
            if count <= rule.leaf_size.max(1) {
                watch.on(Grow::Leaf { node, prims: count, why: LeafReason::Few });
                self.settle(node, splitter.prims(&part), watch);
                continue;
            }

            // Divide its primitives; the children take neighbouring places at once.
            let cut = splitter.split(node, &part, depth >= SAH_DEPTH, watch)?;
            let below = self.add(prims, &splitter, &cut.below, watch)?;
            let above = self.add(prims, &splitter, &cut.above, watch)?;
            self.nodes[node.index()].first = below.0;
            watch.on(Grow::Split { node, axis: cut.axis.into(), plane: cut.plane, below, above, cost: cut.cost });
            waiting.push(Task { node: above, part: cut.above, depth: depth + 1 });
            waiting.push(Task { node: below, part: cut.below, depth: depth + 1 });
        }
        Ok(())
    }

    /// A new node, with the volume around its primitives.
    fn add(
        &mut self,
        prims: &impl Primitives,
        splitter: &Splitter<'_>,
        part: &Part,
        watch: &impl Observer<Grow>,
    ) -> Result<NodeId, Cancelled> {
        let volume = V::fit(prims, splitter.prims(part), &part.bounds, splitter.rule.axes, &mut Unheard(watch))?;
        self.nodes.push(BvhNode { volume, first: 0, count: 0 });
        Ok(NodeId(self.nodes.len() as u32 - 1))
    }
}
