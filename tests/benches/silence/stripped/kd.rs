//! The walk of the kd-tree, stripped.

use raystep_accel::{Aabb, Accel, Axis, Hit, Interval, Kd, List, Margin, NodeId, PrimId, Primitives, Ray, Side, Want};

use super::{Best, Mailbox, slab, test};

/// The tree's own data, laid out as in `raystep-accel`.
pub(crate) struct StrippedKd {
    bounds: Aabb,
    margin: Margin,
    mailbox: bool,
    nodes: Vec<Node>,
    refs: Vec<PrimId>,
}

#[derive(Clone, Copy)]
struct Node {
    place: u32,
    tag: u32,
}

enum Kind {
    Inner { axis: Axis, plane: f32, below: NodeId, above: NodeId },
    Leaf { first: u32, count: u32 },
}

impl Node {
    const LEAF: u32 = 3;

    #[inline]
    fn kind(self) -> Kind {
        let number = self.tag >> 2;
        match self.tag & 3 {
            Node::LEAF => Kind::Leaf { first: self.place, count: number },
            axis => Kind::Inner {
                axis: Axis::ALL[axis as usize],
                plane: f32::from_bits(self.place),
                below: NodeId(number),
                above: NodeId(number + 1),
            },
        }
    }
}

#[derive(Clone, Copy)]
struct Part {
    node: NodeId,
    live: Interval,
}

impl StrippedKd {
    pub(crate) fn of(tree: &Kd, mailbox: bool) -> StrippedKd {
        let mut refs: Vec<PrimId> = Vec::new();
        let nodes =
            (0..tree.node_count() as u32).map(NodeId).map(|node| match tree.split(node).zip(tree.children(node)) {
                Some(((axis, plane), [below, _])) => {
                    Node { place: plane.to_bits(), tag: (below.0 << 2) | axis.index() as u32 }
                }
                None => {
                    let prims = tree.leaf_prims(node);
                    let first = refs.len() as u32;
                    refs.extend(prims);
                    Node { place: first, tag: ((prims.len() as u32) << 2) | Node::LEAF }
                }
            });
        let (nodes, bounds) = (nodes.collect(), tree.bounds());
        StrippedKd { bounds, margin: Margin::of(&bounds), mailbox, nodes, refs }
    }

    pub(crate) fn walk(&self, prims: &impl Primitives, ray: &Ray, want: Want) -> Option<Hit> {
        if !self.margin.covers(ray.o) {
            return List.walk(prims, ray, want, &mut ());
        }
        let mut best = Best::new(want);
        self.find(prims, ray, &mut best);
        best.hit
    }

    fn find(&self, prims: &impl Primitives, ray: &Ray, best: &mut Best) {
        let Some(live) = self.enter(ray) else { return };
        let mut here = Part { node: NodeId::ROOT, live };
        let mut stack = Stack::new();
        let mut mailbox = Mailbox::new();

        loop {
            match self.nodes[here.node.index()].kind() {
                Kind::Inner { axis, plane, below, above } => {
                    here = match split(here, axis, plane, [below, above], ray) {
                        (near, None) => near,
                        (near, Some(far)) => {
                            stack.push(far);
                            near
                        }
                    };
                    continue;
                }
                Kind::Leaf { first, count } => {
                    for &prim in &self.refs[first as usize..(first + count) as usize] {
                        if self.mailbox && mailbox.holds(prim) {
                            continue;
                        }
                        test(prims, prim, ray, best);
                        mailbox.put(prim);
                        if best.answered() {
                            return;
                        }
                    }
                }
            }
            here = match stack.next(best) {
                Some(part) => part,
                None => return,
            };
        }
    }

    #[inline]
    fn enter(&self, ray: &Ray) -> Option<Interval> {
        if self.bounds.is_empty() {
            return None;
        }
        let live = slab(&self.bounds, ray, ray.range());
        (!live.is_empty()).then_some(live)
    }
}

#[inline]
fn split(here: Part, axis: Axis, plane: f32, [below, above]: [NodeId; 2], ray: &Ray) -> (Part, Option<Part>) {
    let (o, d) = (ray.o[axis], ray.d[axis]);
    let Interval { near: t_near, far: t_far } = here.live;
    let t = (plane - o) / d;
    let from_below = if d == 0.0 { o <= plane } else { d > 0.0 };
    let (near, far) = if from_below { (below, above) } else { (above, below) };

    let (side, now, later) = if d == 0.0 {
        let side = if o == plane { Side::Both } else { Side::Near };
        (side, here.live, here.live)
    } else if t >= t_far {
        (Side::Near, here.live, here.live)
    } else if t <= t_near {
        (Side::Far, here.live, here.live)
    } else {
        (Side::Both, Interval::new(t_near, t), Interval::new(t, t_far))
    };
    match side {
        Side::Near => (Part { node: near, live: now }, None),
        Side::Far => (Part { node: far, live: later }, None),
        Side::Both => (Part { node: near, live: now }, Some(Part { node: far, live: later })),
    }
}

struct Stack {
    parts: [Part; Kd::DEEPEST],
    len: usize,
}

impl Stack {
    fn new() -> Stack {
        Stack { parts: [Part { node: NodeId::ROOT, live: Interval::ALL }; Kd::DEEPEST], len: 0 }
    }

    #[inline]
    fn push(&mut self, part: Part) {
        self.parts[self.len] = part;
        self.len += 1;
    }

    #[inline]
    fn next(&mut self, best: &Best) -> Option<Part> {
        while self.len > 0 {
            self.len -= 1;
            let part = self.parts[self.len];
            if !best.rules_out(part.live.near) {
                return Some(part);
            }
        }
        None
    }
}
