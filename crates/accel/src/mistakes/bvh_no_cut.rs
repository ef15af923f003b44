//! The walk of boxes that opens every box it meets, whatever it has found: as slide 56 prints it, with an order.

use crate::bvh::{BvhWalk, Met};
use crate::{Bvh, Ending, Hit, Interval, NodeId, Observer, Primitives, Ray, Visit, Volume, Want};

pub(super) fn walk<V: Volume>(
    tree: &Bvh<V>,
    prims: &impl Primitives,
    ray: &Ray,
    watch: &mut impl Observer<Visit>,
) -> Option<Hit> {
    let mut walk = BvhWalk::new(tree, prims, ray, Want::Nearest, watch);
    // MISTAKE: no box is compared with the best hit, neither here nor when it is taken from the stack.
    walk.cuts = false;
    let mut stack: Vec<Met> = walk.root().into_iter().collect();
    let why = if stack.is_empty() { Ending::Outside } else { Ending::Exhausted };
    while let Some(here) = stack.pop() {
        let (node, Interval { near: t_near, far: t_far }) = (here.node, here.within);
        if node != NodeId::ROOT {
            walk.watch.on(Visit::Pop { node, t_near, t_far, depth: stack.len() as u32 });
        }
        let Some([left, right]) = walk.open(here) else { continue };
        // The farther one waits below the nearer one.
        let mut met: Vec<Met> =
            [walk.volume(left, here.within), walk.volume(right, here.within)].into_iter().flatten().collect();
        met.sort_by(|a, b| b.within.near.total_cmp(&a.within.near));
        for child in met {
            stack.push(child);
            let Interval { near: t_near, far: t_far } = child.within;
            walk.watch.on(Visit::Push { node: child.node, t_near, t_far, depth: stack.len() as u32 });
        }
    }
    walk.end(why)
}
