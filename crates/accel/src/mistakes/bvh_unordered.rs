//! The walk of boxes that opens the left child first, wherever the ray comes from.

use crate::bvh::{BvhWalk, Met};
use crate::{Bvh, Ending, Hit, Interval, NodeId, Observer, Primitives, Ray, Visit, Volume, Want};

pub(super) fn walk<V: Volume>(
    tree: &Bvh<V>,
    prims: &impl Primitives,
    ray: &Ray,
    watch: &mut impl Observer<Visit>,
) -> Option<Hit> {
    let mut walk = BvhWalk::new(tree, prims, ray, Want::Nearest, watch);
    let mut stack: Vec<Met> = walk.root().into_iter().collect();
    let mut why = if stack.is_empty() { Ending::Outside } else { Ending::Exhausted };
    while let Some(here) = stack.pop() {
        let depth = stack.len() as u32;
        let (node, Interval { near: t_near, far: t_far }) = (here.node, here.within);
        if node != NodeId::ROOT {
            if walk.best.rules_out(t_near) {
                walk.watch.on(Visit::Drop { node, t_near, t_far, best_t: walk.best.t(), depth });
                why = Ending::Settled;
                continue;
            }
            walk.watch.on(Visit::Pop { node, t_near, t_far, depth });
            why = Ending::Exhausted;
        }
        let Some([left, right]) = walk.open(here) else { continue };
        let (left, right) = (walk.volume(left, here.within), walk.volume(right, here.within));
        // MISTAKE: left comes first, even if the ray enters the right box before it.
        for child in [right, left].into_iter().flatten() {
            stack.push(child);
            let Interval { near: t_near, far: t_far } = child.within;
            walk.watch.on(Visit::Push { node: child.node, t_near, t_far, depth: stack.len() as u32 });
        }
    }
    walk.end(why)
}
