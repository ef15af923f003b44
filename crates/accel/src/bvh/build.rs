//! Building a hierarchy from the top, slide 53: sets are divided by their boxes, then each gets its volume.

use super::split::{Part, Splitter};
use super::{Bvh, BvhNode};
use crate::{Aabb, BvhRule, Cancelled, Grow, LeafReason, NodeId, Observer, Place, PrimId, Primitives, Volume};

/// Below this depth nodes are split into halves, whatever the rule: no scene can make the tree so deep
/// that a walk's stack overflows.
pub(super) const SAH_DEPTH: usize = 40;

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
    pub fn over(prims: &impl Primitives, rule: &BvhRule, watch: &mut impl Observer<Grow>) -> Result<Self, Cancelled> {
        // The boxes, and the box around all of them.
        let mut all = Aabb::EMPTY;
        let mut boxes = Vec::with_capacity(prims.len());
        for prim in (0..prims.len() as u32).map(PrimId) {
            boxes.push(prims.bounds(prim));
            let before = all;
            all = before.union(boxes[prim.index()]);
            watch.on(Grow::Widen { prim, bounds: all, grown: all != before });
        }
        let mut bvh = Bvh { bounds: all, nodes: Vec::new(), refs: Vec::with_capacity(prims.len()), order: rule.order };
        if prims.is_empty() {
            return Ok(bvh);
        }
        let mut splitter = Splitter::new(rule, boxes);

        // Split nodes until they are small enough, those below before those above.
        let whole = splitter.whole(all);
        let root = bvh.add(prims, &splitter, &whole);
        let mut waiting = vec![Task { node: root, part: whole, depth: 0 }];
        while let Some(Task { node, part, depth }) = waiting.pop() {
            if watch.cancelled() {
                return Err(Cancelled);
            }
            let count = part.len() as u32;
            watch.on(Grow::Open { node, bounds: bvh.volume(node).bounds(), prims: count, depth: depth as u32 });

            // Few enough: a leaf.
            if count <= rule.leaf_size.max(1) {
                watch.on(Grow::Leaf { node, prims: count, why: LeafReason::Few });
                bvh.settle(node, splitter.prims(&part), watch);
                continue;
            }

            // Divide its primitives; the children take neighbouring places at once.
            let cut = splitter.split(node, &part, depth >= SAH_DEPTH, watch);
            let below = bvh.add(prims, &splitter, &cut.below);
            let above = bvh.add(prims, &splitter, &cut.above);
            bvh.nodes[node.index()].first = below.0;
            watch.on(Grow::Split { node, axis: cut.axis.into(), plane: cut.plane, below, above, cost: cut.cost });
            waiting.push(Task { node: above, part: cut.above, depth: depth + 1 });
            waiting.push(Task { node: below, part: cut.below, depth: depth + 1 });
        }
        watch.on(Grow::End { nodes: bvh.nodes.len() as u32, cells: 0, references: bvh.refs.len() as u32 });
        Ok(bvh)
    }

    /// A new node, with the volume around its primitives.
    fn add(&mut self, prims: &impl Primitives, splitter: &Splitter<'_>, part: &Part) -> NodeId {
        let volume = V::fit(prims, splitter.prims(part), &part.bounds, splitter.rule.axes);
        self.nodes.push(BvhNode { volume, first: 0, count: 0 });
        NodeId(self.nodes.len() as u32 - 1)
    }

    /// Makes a node a leaf with these primitives.
    fn settle(&mut self, node: NodeId, prims: impl Iterator<Item = PrimId>, watch: &mut impl Observer<Grow>) {
        let first = self.refs.len();
        self.refs.extend(prims);
        self.refs[first..].sort_unstable();
        for &prim in &self.refs[first..] {
            watch.on(Grow::Settle { prim, place: Place::Node(node) });
        }
        let leaf = &mut self.nodes[node.index()];
        (leaf.first, leaf.count) = (first as u32, (self.refs.len() - first) as u32);
    }
}
