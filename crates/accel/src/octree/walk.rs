//! A ray through an octree, slide 44: as through a kd-tree, with up to four of the eight children in ray order.

use super::{Node, Octree};
use crate::{
    Aabb, Accel, Axis, Best, Ending, Hit, Interval, List, Mailbox, NodeId, Observer, Place, Primitives, Ray, Verdict, Visit,
    Want, slab, test,
};

/// A child that the ray meets: its number, and its part of the ray.
type Part = (u32, Interval);

impl Accel for Octree {
    fn walk(&self, prims: &impl Primitives, ray: &Ray, want: Want, watch: &mut impl Observer<Visit>) -> Option<Hit> {
        if !self.margin.covers(ray.o) {
            watch.on(Visit::Distant { reach: self.margin.reach });
            return List.walk(prims, ray, want, watch);
        }
        let mut best = Best::new(want);
        let mut mailbox = Mailbox::new(self.rule.mailbox);
        let end = |why: Ending, best: &Best| Visit::End { why, hit: best.hit.is_some(), t: best.t() };

        // Clip the ray to the root's cell.
        if self.bounds.is_empty() {
            watch.on(end(Ending::Outside, &best));
            return None;
        }
        let root = slab(&self.bounds, ray, ray.range(), Place::Node(NodeId::ROOT), watch);
        let verdict = if root.is_empty() { Verdict::Miss } else { Verdict::Hit };
        let place = Place::Node(NodeId::ROOT);
        watch.on(Visit::Volume { place, t_near: root.near, t_far: root.far, best_t: best.t(), verdict });
        if root.is_empty() {
            watch.on(end(Ending::Outside, &best));
            return None;
        }

        let mut stack: Vec<(NodeId, Aabb, Interval)> = Vec::new();
        let mut here = Some((NodeId::ROOT, self.bounds, root));
        while let Some((node, cell, part)) = here {
            here = match &self.nodes[node.index()] {
                Node::Inner(first) => {
                    watch.on(Visit::Enter { place: Place::Node(node), t_near: part.near, t_far: part.far, prims: 0, leaf: false });
                    // Order the children along the ray; all but the first wait.
                    let (children, count) = self.order(node, ray, &cell, part, watch);
                    let child = |(number, part): Part| (NodeId(first.0 + number), self.child_cell(&cell, number), part);
                    for &later in children[1..count].iter().rev() {
                        let (node, cell, part) = child(later);
                        stack.push((node, cell, part));
                        watch.on(Visit::Push { node, t_near: part.near, t_far: part.far, depth: stack.len() as u32 });
                    }
                    Some(child(children[0]))
                }
                Node::Leaf(held) => {
                    let (t_near, t_far) = (part.near, part.far);
                    watch.on(Visit::Enter { place: Place::Node(node), t_near, t_far, prims: held.len() as u32, leaf: true });
                    // Test the leaf's primitives, keep the nearest.
                    for &prim in held {
                        if mailbox.tested(prim) {
                            watch.on(Visit::Skip { prim });
                            continue;
                        }
                        test(prims, prim, ray, &mut best, watch);
                        if best.answered() {
                            watch.on(end(Ending::Found, &best));
                            return best.hit;
                        }
                    }
                    // The next child that waits; done if the hit lies before it.
                    let next = stack.pop();
                    if let Some((node, _, part)) = next {
                        let (t_near, t_far, depth) = (part.near, part.far, stack.len() as u32);
                        if best.rules_out(t_near) {
                            watch.on(Visit::Drop { node, t_near, t_far, best_t: best.t(), depth });
                            while let Some((node, _, part)) = stack.pop() {
                                let (t_near, t_far, depth) = (part.near, part.far, stack.len() as u32);
                                watch.on(Visit::Drop { node, t_near, t_far, best_t: best.t(), depth });
                            }
                            watch.on(end(Ending::Settled, &best));
                            return best.hit;
                        }
                        watch.on(Visit::Pop { node, t_near, t_far, depth });
                    }
                    next
                }
            };
        }
        watch.on(end(Ending::Exhausted, &best));
        best.hit
    }
}

impl Octree {
    /// The children that the ray meets within `part`, in its order: the three middle planes can be crossed
    /// three times, so there are at most four.
    fn order(&self, node: NodeId, ray: &Ray, cell: &Aabb, part: Interval, watch: &mut impl Observer<Visit>) -> ([Part; 4], usize) {
        let middle = cell.center();
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
            watch.on(Visit::Plane { node, axis, plane, o, d, t, t_near: part.near, t_far: part.far });
            // Before the crossing the ray is on the side it comes from.
            let crossed = t <= part.near;
            if (d > 0.0) == crossed {
                number |= bit;
            }
            if !crossed && t <= part.far {
                crossings[axis.index()] = Some((t, axis));
            }
        }
        crossings.sort_by(|a, b| match (a, b) {
            (Some(a), Some(b)) => a.0.total_cmp(&b.0),
            (a, b) => b.is_some().cmp(&a.is_some()),
        });

        // Each crossing ends one child and begins the next.
        let mut children = [(0, part); 4];
        let mut count = 0;
        let mut near = part.near;
        for (t, axis) in crossings.into_iter().flatten() {
            children[count] = (number, Interval::new(near, t));
            count += 1;
            number ^= 1 << axis.index();
            near = t;
        }
        children[count] = (number, Interval::new(near, part.far));
        (children, count + 1)
    }
}
