//! The kd walk that stops at the first leaf with a hit.

use crate::kd::{Part, Stack, enter, split};
use crate::{Best, Ending, Hit, Kd, NodeId, Observer, Primitives, Ray, Visit, Want, test};

pub(super) fn walk(tree: &Kd, prims: &impl Primitives, ray: &Ray, watch: &mut impl Observer<Visit>) -> Option<Hit> {
    let (mut best, mut stack) = (Best::new(Want::Nearest), Stack::new());
    let mut why = Ending::Outside;
    let mut next = tree.enter(ray, watch).map(|live| Part { node: NodeId::ROOT, live });
    while let Some(here) = next {
        let refs = tree.leaf_prims(here.node);
        let inner = tree.split(here.node).zip(tree.children(here.node));
        enter(here, refs.len() as u32, inner.is_none(), watch);
        if let Some(((axis, plane), children)) = inner {
            let (near, far) = split(here, axis, plane, children, ray, watch);
            if let Some(far) = far {
                stack.push(far, watch);
            }
            next = Some(near);
            continue;
        }
        for &prim in refs {
            test(prims, prim, ray, &mut best, watch);
        }
        // MISTAKE: the hit may lie beyond this leaf, behind something in the far child.
        if best.hit.is_some() {
            why = Ending::Settled;
            break;
        }
        next = stack.next(&best, watch).map_err(|ending| why = ending).ok();
    }
    watch.on(Visit::End { why, hit: best.hit.is_some(), t: best.t() });
    best.hit
}
