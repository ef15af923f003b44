//! Walking a tree of planes, slides 33-38: in an inner node split the interval, in a leaf intersect.

use super::{DEEPEST, Kind, Node, Plane, PlaneTree};
use crate::common::{Mailbox, Part, Stack, test_each};
use crate::{
    Accel, Best, Direction, Ending, Hit, Interval, List, NodeId, Observer, Primitives, Ray, Side, Visit, Want,
};

/// A plane and the ray along the plane's direction: what is left of three dimensions when they meet.
#[derive(Clone, Copy, Debug)]
pub struct Meeting {
    /// The direction across which the plane stands.
    pub axis: Direction,
    /// The plane's place along it.
    pub plane: f32,
    /// The ray's origin along it.
    pub o: f32,
    /// The ray's direction along it.
    pub d: f32,
}

impl<N: Node> Accel for PlaneTree<N> {
    fn walk(&self, prims: &impl Primitives, ray: &Ray, want: Want, watch: &mut impl Observer<Visit>) -> Option<Hit> {
        if let Some(why) = self.bars(ray) {
            watch.on(why);
            return List.walk(prims, ray, want, watch);
        }
        let mut best = Best::new(want);
        let why = self.find(prims, ray, &mut best, watch);
        watch.on(Visit::End { why, hit: best.hit.is_some(), t: best.t() });
        best.hit
    }
}

impl<N: Node> PlaneTree<N> {
    /// The walk itself: fills `best` and says why it ended.
    fn find(&self, prims: &impl Primitives, ray: &Ray, best: &mut Best, watch: &mut impl Observer<Visit>) -> Ending {
        // The part of the ray in the tree's box.
        let Some(mut here) = self.enter(ray, watch) else { return Ending::Outside };
        let mut stack = Stack::<(), DEEPEST>::below(here);
        let mut mailbox = Mailbox::new();

        loop {
            match self.nodes[here.node.index()].kind() {
                Kind::Inner { plane, below, above } => {
                    // Inner node: split the interval.
                    here.enter(0, false, watch);
                    here = match split(here, plane.across(ray), [below, above], watch) {
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
                    here.enter(count, true, watch);
                    let refs = &self.refs[first as usize..(first + count) as usize];
                    test_each(refs, self.mailbox.then_some(&mut mailbox), prims, ray, best, watch);
                    if best.answered() {
                        return Ending::Found;
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
    pub(crate) fn enter(&self, ray: &Ray, watch: &mut impl Observer<Visit>) -> Option<Part> {
        Part::root(&self.bounds, (), ray, watch)
    }
}

/// Splits the interval of an inner node between its children `[below, above]`: the child to walk now and,
/// if the ray meets both, the one to walk later.
#[inline]
pub(crate) fn split(
    here: Part,
    Meeting { axis, plane, o, d }: Meeting,
    [below, above]: [NodeId; 2],
    watch: &mut impl Observer<Visit>,
) -> (Part, Option<Part>) {
    let Interval { near: t_near, far: t_far } = here.live;

    // Solve o + t·d = plane.
    let t = (plane - o) / d;
    watch.on(Visit::Plane { node: here.node, axis, plane, o, d, t, t_near, t_far });

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

    let part = |node: NodeId, live: Interval| Part { node, live, cell: () };
    match side {
        Side::Near => (part(near, now), None),
        Side::Far => (part(far, later), None),
        Side::Both => (part(near, now), Some(part(far, later))),
    }
}
