//! The ordered walk of the hierarchy of boxes, stripped.

use raystep_accel::{Aabb, Bvh, BvhOrder, Hit, Interval, NodeId, PrimId, Primitives, Ray, Verdict, Want};

use super::{Best, slab, test};

/// The tree's own data, laid out as in `raystep-accel`.
pub(crate) struct StrippedBvh {
    nodes: Vec<Node>,
    refs: Vec<PrimId>,
    order: BvhOrder,
}

struct Node {
    volume: Aabb,
    first: u32,
    count: u32,
}

#[derive(Clone, Copy)]
struct Met {
    node: NodeId,
    within: Interval,
}

struct Walk<'a, P> {
    bvh: &'a StrippedBvh,
    prims: &'a P,
    ray: &'a Ray,
    best: Best,
    cuts: bool,
}

impl StrippedBvh {
    pub(crate) fn of(tree: &Bvh, order: BvhOrder) -> StrippedBvh {
        let mut refs: Vec<PrimId> = Vec::new();
        let ids = (0..tree.node_count() as u32).map(NodeId);
        let nodes = ids.zip(tree.node_bounds()).map(|(node, volume)| match tree.children(node) {
            Some([left, _]) => Node { volume, first: left.0, count: 0 },
            None => {
                let prims = tree.leaf_prims(node);
                let first = refs.len() as u32;
                refs.extend(prims);
                Node { volume, first, count: prims.len() as u32 }
            }
        });
        StrippedBvh { nodes: nodes.collect(), refs, order }
    }

    #[inline(never)]
    pub(crate) fn intersect(&self, prims: &impl Primitives, ray: &Ray) -> Option<Hit> {
        self.walk(prims, ray, Want::Nearest)
    }

    #[inline(always)]
    fn walk(&self, prims: &impl Primitives, ray: &Ray, want: Want) -> Option<Hit> {
        let mut walk = Walk { bvh: self, prims, ray, best: Best::new(want), cuts: self.order == BvhOrder::Ordered };
        match self.order {
            _ if self.nodes.is_empty() => {}
            BvhOrder::Printed => walk.printed(NodeId::ROOT, ray.range()),
            BvhOrder::Ordered => walk.ordered(),
        }
        walk.best.hit
    }

    #[inline]
    fn children(&self, node: NodeId) -> Option<[NodeId; 2]> {
        let node = &self.nodes[node.index()];
        (node.count == 0).then_some([NodeId(node.first), NodeId(node.first + 1)])
    }

    #[inline]
    fn leaf_prims(&self, node: NodeId) -> &[PrimId] {
        let node = &self.nodes[node.index()];
        match node.count {
            0 => &[],
            count => &self.refs[node.first as usize..(node.first + count) as usize],
        }
    }
}

impl<P: Primitives> Walk<'_, P> {
    fn printed(&mut self, node: NodeId, within: Interval) {
        let Some(here) = self.volume(node, within) else { return };
        if let Some([left, right]) = self.open(here) {
            self.printed(left, here.within);
            if !self.best.answered() {
                self.printed(right, here.within);
            }
        }
    }

    fn ordered(&mut self) {
        let Some(mut here) = self.root() else { return };
        let mut stack = [here; Bvh::DEEPEST];
        let mut depth = 0;
        loop {
            if let Some([left, right]) = self.open(here) {
                match (self.volume(left, here.within), self.volume(right, here.within)) {
                    (Some(left), Some(right)) => {
                        let (near, far) =
                            if right.within.near < left.within.near { (right, left) } else { (left, right) };
                        stack[depth] = far;
                        depth += 1;
                        here = near;
                        continue;
                    }
                    (Some(only), None) | (None, Some(only)) => {
                        here = only;
                        continue;
                    }
                    (None, None) => {}
                }
            }
            if self.best.answered() {
                return;
            }
            loop {
                if depth == 0 {
                    return;
                }
                depth -= 1;
                if !self.best.rules_out(stack[depth].within.near) {
                    here = stack[depth];
                    break;
                }
            }
        }
    }

    fn root(&mut self) -> Option<Met> {
        if self.bvh.nodes.is_empty() { None } else { self.volume(NodeId::ROOT, self.ray.range()) }
    }

    #[inline(never)]
    fn volume(&mut self, node: NodeId, within: Interval) -> Option<Met> {
        let within = slab(&self.bvh.nodes[node.index()].volume, self.ray, within);
        let verdict = if within.is_empty() {
            Verdict::Miss
        } else if self.cuts && self.best.rules_out(within.near) {
            Verdict::Cut
        } else {
            Verdict::Hit
        };
        (verdict == Verdict::Hit).then_some(Met { node, within })
    }

    #[inline(always)]
    fn open(&mut self, here: Met) -> Option<[NodeId; 2]> {
        let bvh = self.bvh;
        let (children, prims) = (bvh.children(here.node), bvh.leaf_prims(here.node));
        for &prim in prims {
            test(self.prims, prim, self.ray, &mut self.best);
            if self.best.answered() {
                break;
            }
        }
        children
    }
}
