//! Building a kd-tree, slides 29-32.

use super::Kd;
use super::node::Node;
use super::reference::{Reference, deal};
use super::split::Scale;
use crate::{Aabb, Cancelled, Grow, KdRule, KdSplit, LeafReason, Margin, NodeId, Observer, Place, PrimId, Primitives};

/// There is room for so many references for each primitive, and for [`SPARE`] more: primitives that lie
/// on top of each other would be referred to from ever more leaves. Children share their parent's room.
const CROWD: usize = 32;
const SPARE: usize = 1 << 12;

/// A node that waits to be split or to become a leaf.
struct Open {
    node: NodeId,
    bounds: Aabb,
    depth: u32,
    refs: Vec<Reference>,
    /// How many references all leaves below may hold.
    room: usize,
}

impl Kd {
    /// Builds a kd-tree over `prims`.
    ///
    /// # Errors
    /// `watch` asked to give up.
    pub fn build(prims: &impl Primitives, rule: &KdRule, watch: &mut impl Observer<Grow>) -> Result<Kd, Cancelled> {
        // The box around everything.
        let mut bounds = Aabb::EMPTY;
        for prim in ids(prims) {
            let before = bounds;
            bounds = before.union(prims.bounds(prim));
            watch.on(Grow::Widen { prim, bounds, grown: bounds != before });
        }
        let margin = Margin::of(&bounds);
        let refs: Vec<_> = ids(prims).filter_map(|prim| Reference::clipped(prims, prim, &bounds, margin.pad)).collect();

        let room = refs.len() * CROWD + SPARE;
        let mut tree = Kd { bounds, margin, mailbox: rule.mailbox, nodes: vec![Node::leaf(0, 0)], refs: Vec::new() };
        let mut open = vec![Open { node: NodeId::ROOT, bounds, depth: 0, refs, room }];

        // Split one open node after the other, the one below the plane first.
        while let Some(Open { node, bounds, depth, refs, room }) = open.pop() {
            if watch.cancelled() {
                return Err(Cancelled);
            }
            watch.on(Grow::Open { node, bounds, prims: refs.len() as u32, depth });

            // Stop at few objects or at the maximum depth.
            if refs.len() <= rule.min_objects as usize {
                tree.settle(node, &refs, LeafReason::Few, watch);
                continue;
            }
            if depth >= rule.max_depth.min(KdRule::DEEPEST) {
                tree.settle(node, &refs, LeafReason::Deep, watch);
                continue;
            }
            // Choose the plane.
            let whole = bounds.measure(rule.measure);
            let Some(cut) = (Scale { node, bounds: &bounds, refs: &refs, rule, watch, whole }).best() else {
                tree.settle(node, &refs, LeafReason::Inseparable, watch);
                continue;
            };
            // Stop if testing everything here is cheaper.
            if rule.split == KdSplit::Sah && cut.cost >= rule.intersection_cost * refs.len() as f32 {
                tree.settle(node, &refs, LeafReason::Cheap, watch);
                continue;
            }

            // Both sides get what reaches into them.
            let halves = bounds.cut(cut.axis, cut.plane);
            let (lower, upper) = deal(prims, &refs, cut.axis, cut.plane, &halves, margin.pad);
            let dealt = lower.len() + upper.len();
            if dealt > room || tree.nodes.len() + 2 > Node::MOST as usize {
                tree.settle(node, &refs, LeafReason::Crowded, watch);
                continue;
            }

            let below = NodeId(tree.nodes.len() as u32);
            let above = NodeId(below.0 + 1);
            tree.nodes.extend([Node::leaf(0, 0); 2]);
            tree.nodes[node.index()] = Node::inner(cut.axis, cut.plane, below);
            watch.on(Grow::Split { node, axis: cut.axis.into(), plane: cut.plane, below, above, cost: cut.cost });
            for reference in refs.iter().filter(|reference| reference.sides(cut.axis, cut.plane) == (true, true)) {
                watch.on(Grow::Share { node, prim: reference.prim });
            }
            let share = |refs: &[Reference]| (room as u64 * refs.len() as u64 / dealt.max(1) as u64) as usize;
            let depth = depth + 1;
            open.push(Open { node: above, bounds: halves.1, depth, room: share(&upper), refs: upper });
            open.push(Open { node: below, bounds: halves.0, depth, room: share(&lower), refs: lower });
        }
        watch.on(Grow::End { nodes: tree.nodes.len() as u32, cells: 0, references: tree.refs.len() as u32 });
        Ok(tree)
    }

    /// Makes `node` a leaf: only leaves refer to geometry (slide 31).
    fn settle(&mut self, node: NodeId, refs: &[Reference], why: LeafReason, watch: &mut impl Observer<Grow>) {
        self.nodes[node.index()] = Node::leaf(self.refs.len() as u32, refs.len() as u32);
        watch.on(Grow::Leaf { node, prims: refs.len() as u32, why });
        for &Reference { prim, .. } in refs {
            self.refs.push(prim);
            watch.on(Grow::Settle { prim, place: Place::Node(node) });
        }
    }
}

fn ids(prims: &impl Primitives) -> impl Iterator<Item = PrimId> {
    (0..prims.len() as u32).map(PrimId)
}
