//! Walking a kd-tree, slides 33-38: in an inner node split the interval, in a leaf intersect.

use super::Kd;
use super::node::Kind;
use crate::mailbox::Mailbox;
use crate::{
    Accel, Axis, Best, Ending, Hit, Interval, List, NodeId, Observer, Place, Primitives, Ray, Side, Verdict, Visit,
    Want, slab, test,
};

/// A node and the part of the ray that may lie in it.
#[derive(Clone, Copy)]
pub(crate) struct Part {
    pub(crate) node: NodeId,
    pub(crate) live: Interval,
}

impl Accel for Kd {
    fn walk(&self, prims: &impl Primitives, ray: &Ray, want: Want, watch: &mut impl Observer<Visit>) -> Option<Hit> {
        if !self.margin.covers(ray.o) {
            watch.on(Visit::Distant { reach: self.margin.reach });
            return List.walk(prims, ray, want, watch);
        }
        let mut best = Best::new(want);
        let why = self.find(prims, ray, &mut best, watch);
        watch.on(Visit::End { why, hit: best.hit.is_some(), t: best.t() });
        best.hit
    }
}

impl Kd {
    /// The walk itself: fills `best` and says why it ended.
    fn find(&self, prims: &impl Primitives, ray: &Ray, best: &mut Best, watch: &mut impl Observer<Visit>) -> Ending {
        // The part of the ray in the tree's box.
        let Some(live) = self.enter(ray, watch) else { return Ending::Outside };
        let mut here = Part { node: NodeId::ROOT, live };
        let mut stack = Stack::new();
        let mut mailbox = Mailbox::new();

        loop {
            match self.nodes[here.node.index()].kind() {
                Kind::Inner { axis, plane, below, above } => {
                    // Inner node: split the interval.
                    enter(here, 0, false, watch);
                    here = match split(here, axis, plane, [below, above], ray, watch) {
                        (near, None) => near,
                        (near, Some(far)) => {
                            // The far child waits.
                            stack.push(far, watch);
                            near
                        }
                    };
                    continue;
                }
                Kind::Leaf { first, count } => {
                    // Leaf: intersect.
                    enter(here, count, true, watch);
                    for &prim in &self.refs[first as usize..(first + count) as usize] {
                        if self.mailbox && mailbox.holds(prim) {
                            watch.on(Visit::Skip { prim });
                            continue;
                        }
                        test(prims, prim, ray, best, watch);
                        mailbox.put(prim);
                        if best.answered() {
                            return Ending::Found;
                        }
                    }
                }
            }
            // Next is what waits, unless the best hit lies before it.
            here = match stack.next(best, watch) {
                Ok(part) => part,
                Err(why) => return why,
            };
        }
    }

    /// The part of the ray in the root's box; none if it misses.
    #[inline]
    pub(crate) fn enter(&self, ray: &Ray, watch: &mut impl Observer<Visit>) -> Option<Interval> {
        if self.bounds.is_empty() {
            return None;
        }
        let place = Place::Node(NodeId::ROOT);
        let live = slab(&self.bounds, ray, ray.range(), place, watch);
        let verdict = if live.is_empty() { Verdict::Miss } else { Verdict::Hit };
        watch.on(Visit::Volume { place, t_near: live.near, t_far: live.far, best_t: f32::INFINITY, verdict });
        (!live.is_empty()).then_some(live)
    }
}

#[inline]
pub(crate) fn enter(here: Part, prims: u32, leaf: bool, watch: &mut impl Observer<Visit>) {
    let Interval { near: t_near, far: t_far } = here.live;
    watch.on(Visit::Enter { place: Place::Node(here.node), t_near, t_far, prims, leaf });
}

/// Splits the interval of an inner node between its children `[below, above]`: the child to walk now and,
/// if the ray meets both, the one to walk later.
#[inline]
pub(crate) fn split(
    here: Part,
    axis: Axis,
    plane: f32,
    [below, above]: [NodeId; 2],
    ray: &Ray,
    watch: &mut impl Observer<Visit>,
) -> (Part, Option<Part>) {
    let (o, d) = (ray.o[axis], ray.d[axis]);
    let Interval { near: t_near, far: t_far } = here.live;

    // Solve o + t·d = plane.
    let t = (plane - o) / d;
    watch.on(Visit::Plane { node: here.node, axis: axis.into(), plane, o, d, t, t_near, t_far });

    // Near is where the ray comes from, whatever is left or right.
    let from_below = if d == 0.0 { o <= plane } else { d > 0.0 };
    let (near, far) = if from_below { (below, above) } else { (above, below) };

    let (side, now, later) = if d == 0.0 {
        // Parallel to the plane: on one side for ever, or in the plane and on both.
        let side = if o == plane { Side::Both } else { Side::Near };
        (side, here.live, here.live)
    } else if t >= t_far {
        (Side::Near, here.live, here.live)
    } else if t <= t_near {
        (Side::Far, here.live, here.live)
    } else {
        (Side::Both, Interval::new(t_near, t), Interval::new(t, t_far))
    };
    watch.on(Visit::Split { node: here.node, near, far, t, t_near, t_far, side });

    match side {
        Side::Near => (Part { node: near, live: now }, None),
        Side::Far => (Part { node: far, live: later }, None),
        Side::Both => (Part { node: near, live: now }, Some(Part { node: far, live: later })),
    }
}

/// The parts that wait, the next one on top. No deeper than the tree.
pub(crate) struct Stack {
    parts: [Part; Kd::DEEPEST],
    len: usize,
}

impl Stack {
    pub(crate) fn new() -> Stack {
        Stack { parts: [Part { node: NodeId::ROOT, live: Interval::ALL }; Kd::DEEPEST], len: 0 }
    }

    #[inline]
    pub(crate) fn push(&mut self, part: Part, watch: &mut impl Observer<Visit>) {
        self.parts[self.len] = part;
        self.len += 1;
        let Interval { near: t_near, far: t_far } = part.live;
        watch.on(Visit::Push { node: part.node, t_near, t_far, depth: self.len as u32 });
    }

    /// The next part, or why there is none. What begins behind the best hit is dropped.
    #[inline]
    pub(crate) fn next(&mut self, best: &Best, watch: &mut impl Observer<Visit>) -> Result<Part, Ending> {
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
