//! A ray through an octree, slide 44: as through a kd-tree, with up to four of the eight children in ray order.

use super::{Node, Octree};
use crate::common::{Mailbox, Stack, test_each};
use crate::{
    Aabb, Accel, Axis, Best, Ending, Hit, Interval, List, NodeId, Observer, OctreeRule, Primitives, Ray, Visit, Want,
};

/// A child that the ray meets: its number, and its part of the ray.
type Child = (u32, Interval);

/// A node, its cell and the part of the ray that may lie in it.
type Part = crate::common::Part<Aabb>;

/// As many nodes can wait: three beside each that is walked.
const WAITING: usize = 3 * OctreeRule::DEEPEST as usize;

impl Accel for Octree {
    fn walk(&self, prims: &impl Primitives, ray: &Ray, want: Want, watch: &mut impl Observer<Visit>) -> Option<Hit> {
        if let Some(why) = self.margin.bars(ray) {
            watch.on(why);
            return List.walk(prims, ray, want, watch);
        }
        let mut best = Best::new(want);
        let why = self.find(prims, ray, &mut best, watch);
        watch.on(Visit::End { why, hit: best.hit.is_some(), t: best.t() });
        best.hit
    }
}

impl Octree {
    /// The walk itself: fills `best` and says why it ended.
    fn find(&self, prims: &impl Primitives, ray: &Ray, best: &mut Best, watch: &mut impl Observer<Visit>) -> Ending {
        // The part of the ray in the tree's box.
        let Some(mut here) = Part::root(&self.bounds, self.bounds, ray, watch) else { return Ending::Outside };
        let mut stack = Stack::<Aabb, WAITING>::below(here);
        let mut mailbox = Mailbox::new();

        loop {
            match &self.nodes[here.node.index()] {
                Node::Inner(first) => {
                    // Inner node: order the children along the ray; all but the first wait.
                    here.enter(0, false, watch);
                    let (children, count) = self.order(here, ray, watch);
                    let part = |(number, live): Child| Part {
                        node: NodeId(first.0 + number),
                        cell: self.child_cell(&here.cell, number),
                        live,
                    };
                    for &later in children[1..count].iter().rev() {
                        stack.push(part(later), watch);
                    }
                    here = part(children[0]);
                    continue;
                }
                Node::Leaf(held) => {
                    // Leaf: intersect.
                    here.enter(held.len() as u32, true, watch);
                    test_each(held, self.rule.mailbox.then_some(&mut mailbox), prims, ray, best, watch);
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

    /// The children that the ray meets within `part`, in its order: the three middle planes can be crossed
    /// three times, so there are at most four.
    fn order(&self, here: Part, ray: &Ray, watch: &mut impl Observer<Visit>) -> ([Child; 4], usize) {
        let Interval { near: t_near, far: t_far } = here.live;
        let middle = here.cell.center();
        let mut number = 0;
        let mut crossings: [Option<(f32, Axis)>; 3] = [None; 3];
        for &axis in self.rule.axes.list() {
            let (o, d, plane) = (ray.o[axis], ray.d[axis], middle[axis]);
            let bit = 1 << axis.index();
            if d == 0.0 {
                // Parallel to the middle plane: on one side of it for ever.
                if o >= plane {
                    number |= bit;
                }
                continue;
            }
            let t = (plane - o) / d;
            watch.on(Visit::Plane { node: here.node, axis: axis.into(), plane, o, d, t, t_near, t_far });
            // Before the crossing the ray is on the side it comes from.
            let crossed = t <= t_near;
            if (d > 0.0) == crossed {
                number |= bit;
            }
            if !crossed && t <= t_far {
                crossings[axis.index()] = Some((t, axis));
            }
        }
        crossings.sort_by(|a, b| match (a, b) {
            (Some(a), Some(b)) => a.0.total_cmp(&b.0),
            (a, b) => b.is_some().cmp(&a.is_some()),
        });

        // Each crossing ends one child and begins the next.
        let mut children = [(0, here.live); 4];
        let mut count = 0;
        let mut near = t_near;
        for (t, axis) in crossings.into_iter().flatten() {
            children[count] = (number, Interval::new(near, t));
            count += 1;
            number ^= 1 << axis.index();
            near = t;
        }
        children[count] = (number, Interval::new(near, t_far));
        (children, count + 1)
    }
}
