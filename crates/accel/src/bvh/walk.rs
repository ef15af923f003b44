//! Walking a hierarchy of volumes, slide 56: as printed, and with an order and a stack.

use super::Bvh;
use crate::{
    Accel, Best, BvhOrder, Ending, Hit, Interval, List, NodeId, Observer, Place, Primitives, Ray, Side, Verdict, Visit,
    Volume, Want, test,
};

impl<V: Volume> Accel for Bvh<V> {
    fn walk(&self, prims: &impl Primitives, ray: &Ray, want: Want, watch: &mut impl Observer<Visit>) -> Option<Hit> {
        if let Some(why) = V::bars(ray) {
            watch.on(why);
            return List.walk(prims, ray, want, watch);
        }
        let mut walk = BvhWalk::new(self, prims, ray, want, watch);
        let why = match self.order {
            _ if self.nodes.is_empty() => Ending::Outside,
            BvhOrder::Printed => walk.printed(NodeId::ROOT, ray.range(), 0),
            BvhOrder::Ordered => walk.ordered(),
        };
        walk.end(why)
    }
}

/// A node that the ray meets, and where.
#[derive(Clone, Copy)]
pub(crate) struct Met {
    pub(crate) node: NodeId,
    pub(crate) within: Interval,
}

/// What a walk has at hand.
pub(crate) struct BvhWalk<'a, V: Volume, P, W> {
    bvh: &'a Bvh<V>,
    prims: &'a P,
    ray: &'a Ray,
    pub(crate) best: Best,
    pub(crate) watch: &'a mut W,
    /// Whether volumes are compared with the best hit.
    pub(crate) cuts: bool,
}

impl<'a, V: Volume, P: Primitives, W: Observer<Visit>> BvhWalk<'a, V, P, W> {
    pub(crate) fn new(bvh: &'a Bvh<V>, prims: &'a P, ray: &'a Ray, want: Want, watch: &'a mut W) -> Self {
        BvhWalk { bvh, prims, ray, best: Best::new(want), watch, cuts: bvh.order == BvhOrder::Ordered }
    }

    /// A walk in order that has found `best` so far: a lane of a packet.
    pub(crate) fn resume(bvh: &'a Bvh<V>, prims: &'a P, ray: &'a Ray, best: Best, watch: &'a mut W) -> Self {
        BvhWalk { bvh, prims, ray, best, watch, cuts: true }
    }

    /// The recursion that slide 56 means: every volume that the ray meets is opened, whatever was found before.
    /// `depth` second children wait on the call stack.
    fn printed(&mut self, node: NodeId, within: Interval, depth: u32) -> Ending {
        // Test the node's volume.
        let Some(here) = self.volume(node, within) else { return Ending::Outside };
        // A leaf: test its primitives. Else: both children, one after the other.
        if let Some([left, right]) = self.open(here) {
            let Interval { near: t_near, far: t_far } = here.within;
            self.watch.on(Visit::Push { node: right, t_near, t_far, depth: depth + 1 });
            if self.printed(left, here.within, depth + 1) == Ending::Found {
                return Ending::Found;
            }
            self.watch.on(Visit::Pop { node: right, t_near, t_far, depth });
            return match self.printed(right, here.within, depth) {
                Ending::Found => Ending::Found,
                _ => Ending::Exhausted,
            };
        }
        if self.best.answered() { Ending::Found } else { Ending::Exhausted }
    }

    /// The nearer child first; a volume that begins behind the best hit stays closed.
    fn ordered(&mut self) -> Ending {
        let Some(mut here) = self.root() else { return Ending::Outside };
        let mut stack = [here; Bvh::DEEPEST];
        let mut depth = 0;
        loop {
            if let Some([left, right]) = self.open(here) {
                // Test the volumes of both children.
                match (self.volume(left, here.within), self.volume(right, here.within)) {
                    (Some(left), Some(right)) => {
                        // The one that the ray enters first is next, the other one waits.
                        let (near, far) =
                            if right.within.near < left.within.near { (right, left) } else { (left, right) };
                        self.split(here, near, far);
                        stack[depth] = far;
                        depth += 1;
                        let Interval { near: t_near, far: t_far } = far.within;
                        self.watch.on(Visit::Push { node: far.node, t_near, t_far, depth: depth as u32 });
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
                return Ending::Found;
            }

            // Take the next node from the stack that may hold something nearer.
            let mut why = Ending::Exhausted;
            loop {
                if depth == 0 {
                    return why;
                }
                depth -= 1;
                let Met { node, within: Interval { near: t_near, far: t_far } } = stack[depth];
                if self.best.rules_out(t_near) {
                    self.watch.on(Visit::Drop { node, t_near, t_far, best_t: self.best.t(), depth: depth as u32 });
                    why = Ending::Settled;
                } else {
                    self.watch.on(Visit::Pop { node, t_near, t_far, depth: depth as u32 });
                    here = stack[depth];
                    break;
                }
            }
        }
    }

    /// Tests the root's volume.
    pub(crate) fn root(&mut self) -> Option<Met> {
        if self.bvh.nodes.is_empty() { None } else { self.volume(NodeId::ROOT, self.ray.range()) }
    }

    /// Tests a node's volume where the ray lies in its parent's; nothing if the ray misses it or has a nearer
    /// hit already.
    #[inline(never)]
    pub(crate) fn volume(&mut self, node: NodeId, within: Interval) -> Option<Met> {
        let place = Place::Node(node);
        let within = self.bvh.volume(node).meet(self.ray, within, place, self.watch);
        let Interval { near: t_near, far: t_far } = within;
        let verdict = if within.is_empty() {
            Verdict::Miss
        } else if self.cuts && self.best.rules_out(t_near) {
            Verdict::Cut
        } else {
            Verdict::Hit
        };
        self.watch.on(Visit::Volume { place, t_near, t_far, best_t: self.best.t(), verdict });
        (verdict == Verdict::Hit).then_some(Met { node, within })
    }

    /// Enters a node: its two children, or, from a leaf, nothing once its primitives are tested.
    #[inline(always)]
    pub(crate) fn open(&mut self, here: Met) -> Option<[NodeId; 2]> {
        let bvh = self.bvh;
        let (children, prims) = (bvh.children(here.node), bvh.leaf_prims(here.node));
        let Interval { near: t_near, far: t_far } = here.within;
        self.watch.on(Visit::Enter {
            place: Place::Node(here.node),
            t_near,
            t_far,
            prims: prims.len() as u32,
            leaf: children.is_none(),
        });
        for &prim in prims {
            test(self.prims, prim, self.ray, &mut self.best, self.watch);
            if self.best.answered() {
                break;
            }
        }
        children
    }

    /// Both children are met: tells which comes first. `t` is where the farther one begins.
    fn split(&mut self, here: Met, near: Met, far: Met) {
        let Interval { near: t_near, far: t_far } = here.within;
        let (t, near, far) = (far.within.near, near.node, far.node);
        self.watch.on(Visit::Split { node: here.node, near, far, t, t_near, t_far, side: Side::Both });
    }

    /// The walk is over.
    pub(crate) fn end(self, why: Ending) -> Option<Hit> {
        let best = self.best;
        self.watch.on(Visit::End { why, hit: best.hit.is_some(), t: best.t() });
        best.hit
    }
}
