//! The kd walk that takes the left child for the near one, whichever way the ray runs.

use crate::bsp::{Meeting, Plane};
use crate::common::{Part, Stack};
use crate::{Best, Ending, Hit, Interval, Kd, NodeId, Observer, Primitives, Ray, Side, Visit, Want, test};

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
        next = stack.next(&best, watch).map_err(|ending| why = ending).ok();
    }
    watch.on(Visit::End { why, hit: best.hit.is_some(), t: best.t() });
    best.hit
}

fn split(
    here: Part,
    Meeting { axis, plane, o, d }: Meeting,
    [below, above]: [NodeId; 2],
    watch: &mut impl Observer<Visit>,
) -> (Part, Option<Part>) {
    let Interval { near: t_near, far: t_far } = here.live;
    let t = (plane - o) / d;
    watch.on(Visit::Plane { node: here.node, axis, plane, o, d, t, t_near, t_far });

    // MISTAKE: near is where the ray comes from, and that can be above the plane.
    let (near, far) = (below, above);

    let part = |node: NodeId, t_near: f32, t_far: f32| Part { node, live: Interval::new(t_near, t_far), cell: () };
    let (side, next, later) = if t >= t_far || (d == 0.0 && o <= plane) {
        (Side::Near, part(near, t_near, t_far), None)
    } else if t <= t_near || d == 0.0 {
        (Side::Far, part(far, t_near, t_far), None)
    } else {
        (Side::Both, part(near, t_near, t), Some(part(far, t, t_far)))
    };
    watch.on(Visit::Split { node: here.node, near, far, t, t_near, t_far, side });
    (next, later)
}
