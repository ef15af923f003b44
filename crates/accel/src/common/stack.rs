//! How a ray enters a tree, and what waits while it walks: the same in every tree that cuts space.

use crate::{Aabb, Best, Ending, Interval, NodeId, Observer, Place, Ray, Verdict, Visit, slab};

/// A node and the part of the ray that may lie in it. A walk that needs the node's cell carries it along.
#[derive(Clone, Copy)]
pub(crate) struct Part<Cell = ()> {
    pub(crate) node: NodeId,
    pub(crate) live: Interval,
    pub(crate) cell: Cell,
}

impl<Cell> Part<Cell> {
    /// The part of the ray in the root's box; none if it misses.
    #[inline]
    pub(crate) fn root(bounds: &Aabb, cell: Cell, ray: &Ray, watch: &mut impl Observer<Visit>) -> Option<Part<Cell>> {
        if bounds.is_empty() {
            return None;
        }
        let (node, place) = (NodeId::ROOT, Place::Node(NodeId::ROOT));
        let live = slab(bounds, ray, ray.range(), place, watch);
        let verdict = if live.is_empty() { Verdict::Miss } else { Verdict::Hit };
        watch.on(Visit::Volume { place, t_near: live.near, t_far: live.far, best_t: f32::INFINITY, verdict });
        (!live.is_empty()).then_some(Part { node, live, cell })
    }

    /// Enters the node: an inner one, or a leaf with so many references.
    #[inline]
    pub(crate) fn enter(&self, prims: u32, leaf: bool, watch: &mut impl Observer<Visit>) {
        let Interval { near: t_near, far: t_far } = self.live;
        watch.on(Visit::Enter { place: Place::Node(self.node), t_near, t_far, prims, leaf });
    }
}

/// The parts that wait, the next one on top. There is room for `DEEP` of them, as many as the tree can
/// make wait.
pub(crate) struct Stack<Cell, const DEEP: usize> {
    parts: [Part<Cell>; DEEP],
    len: usize,
}

impl<Cell: Copy, const DEEP: usize> Stack<Cell, DEEP> {
    /// Nothing waits below the root.
    #[inline]
    pub(crate) fn below(root: Part<Cell>) -> Self {
        Stack { parts: [root; DEEP], len: 0 }
    }

    #[inline]
    pub(crate) fn push(&mut self, part: Part<Cell>, watch: &mut impl Observer<Visit>) {
        self.parts[self.len] = part;
        self.len += 1;
        let Interval { near: t_near, far: t_far } = part.live;
        watch.on(Visit::Push { node: part.node, t_near, t_far, depth: self.len as u32 });
    }

    /// The next part, or why there is none. What begins behind the best hit is dropped.
    #[inline]
    pub(crate) fn next(&mut self, best: &Best, watch: &mut impl Observer<Visit>) -> Result<Part<Cell>, Ending> {
        let mut why = Ending::Exhausted;
        while self.len > 0 {
            self.len -= 1;
            let part = self.parts[self.len];
            let (node, depth) = (part.node, self.len as u32);
            let Interval { near: t_near, far: t_far } = part.live;
            if !best.rules_out(t_near) {
                watch.on(Visit::Pop { node, t_near, t_far, depth });
                return Ok(part);
            }
            watch.on(Visit::Drop { node, t_near, t_far, best_t: best.t(), depth });
            why = Ending::Settled;
        }
        Err(why)
    }
}
