//! The kd walk that stops at the first leaf with a hit.

use crate::bsp::{Plane, split};
use crate::common::Stack;
use crate::{Best, Ending, Hit, Kd, Observer, Primitives, Ray, Visit, Want, test};

pub(super) fn walk(tree: &Kd, prims: &impl Primitives, ray: &Ray, watch: &mut impl Observer<Visit>) -> Option<Hit> {
    let mut best = Best::new(Want::Nearest);
    let mut why = Ending::Outside;
    let mut next = tree.enter(ray, watch);
    let mut stack = next.map(Stack::<(), { Kd::DEEPEST }>::below);
    while let Some((here, stack)) = next.zip(stack.as_mut()) {
        let refs = tree.leaf_prims(here.node);
        let inner = tree.plane(here.node).zip(tree.children(here.node));
        here.enter(refs.len() as u32, inner.is_none(), watch);
        if let Some((plane, children)) = inner {
            let (near, far) = split(here, plane.across(ray), children, watch);
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
