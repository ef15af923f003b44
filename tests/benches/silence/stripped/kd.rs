//! The walk of the kd-tree, stripped.

use raystep_accel::{
    Aabb, Accel, Axis, Ending, Hit, Interval, Kd, List, Margin, NodeId, PrimId, Primitives, Ray, Side, Want,
};

use super::{Best, Mailbox, slab, test_each};

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
    Inner { plane: Upright, below: NodeId, above: NodeId },
    Leaf { first: u32, count: u32 },
}

struct Upright {
    axis: Axis,
    at: f32,
}

impl Node {
    const LEAF: u32 = 3;

    #[inline]
    fn kind(self) -> Kind {
        let number = self.tag >> 2;
        let axis = match self.tag & 3 {
            0 => Axis::X,
            1 => Axis::Y,
            2 => Axis::Z,
            _ => return Kind::Leaf { first: self.place, count: number },
        };
        let plane = Upright { axis, at: f32::from_bits(self.place) };
        Kind::Inner { plane, below: NodeId(number), above: NodeId(number + 1) }
    }
}

#[derive(Clone, Copy)]
struct Part {
    node: NodeId,
    live: Interval,
}

impl StrippedKd {
    pub(crate) fn of(tree: &Kd, mailbox: bool, count: usize) -> StrippedKd {
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
        StrippedKd { bounds, margin: Margin::of(&bounds, count), mailbox, nodes, refs }
    }

    #[inline(never)]
    pub(crate) fn intersect(&self, prims: &impl Primitives, ray: &Ray) -> Option<Hit> {
        self.walk(prims, ray, Want::Nearest)
    }

    #[inline(always)]
    fn walk(&self, prims: &impl Primitives, ray: &Ray, want: Want) -> Option<Hit> {
        if self.margin.bars(ray).is_some() {
            return List.walk(prims, ray, want, &mut ());
        }
        let mut best = Best::new(want);
        self.find(prims, ray, &mut best);
        best.hit
    }

    fn find(&self, prims: &impl Primitives, ray: &Ray, best: &mut Best) -> Ending {
        let Some(mut here) = Part::root(&self.bounds, ray) else { return Ending::Outside };
        let mut stack = Stack::below(here);
        let mut mailbox = Mailbox::new();

        loop {
            match self.nodes[here.node.index()].kind() {
                Kind::Inner { plane, below, above } => {
                    here = match split(here, plane, ray, [below, above]) {
                        (near, None) => near,
                        (near, Some(far)) => {
                            stack.push(far);
                            near
                        }
                    };
                    continue;
                }
                Kind::Leaf { first, count } => {
                    let refs = &self.refs[first as usize..(first + count) as usize];
                    test_each(refs, self.mailbox.then_some(&mut mailbox), prims, ray, best);
                    if best.answered() {
                        return Ending::Found;
                    }
                }
            }
            here = match stack.next(best) {
                Ok(part) => part,
                Err(why) => return why,
            };
        }
    }
}

impl Part {
    #[inline]
    fn root(bounds: &Aabb, ray: &Ray) -> Option<Part> {
        if bounds.is_empty() {
            return None;
        }
        let live = slab(bounds, ray, ray.range());
        (!live.is_empty()).then_some(Part { node: NodeId::ROOT, live })
    }
}

#[inline]
fn split(
    here: Part,
    Upright { axis, at: plane }: Upright,
    ray: &Ray,
    [below, above]: [NodeId; 2],
) -> (Part, Option<Part>) {
    let Interval { near: t_near, far: t_far } = here.live;
    let (o, d) = (ray.o[axis], ray.d[axis]);
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
    let part = |node: NodeId, live: Interval| Part { node, live };
    match side {
        Side::Near => (part(near, now), None),
        Side::Far => (part(far, later), None),
        Side::Both => (part(near, now), Some(part(far, later))),
    }
}

struct Stack {
    parts: [Part; Kd::DEEPEST],
    len: usize,
}

impl Stack {
    #[inline]
    fn below(root: Part) -> Stack {
        Stack { parts: [root; Kd::DEEPEST], len: 0 }
    }

    #[inline]
    fn push(&mut self, part: Part) {
        self.parts[self.len] = part;
        self.len += 1;
    }

    #[inline]
    fn next(&mut self, best: &Best) -> Result<Part, Ending> {
        let mut why = Ending::Exhausted;
        while self.len > 0 {
            self.len -= 1;
            let part = self.parts[self.len];
            if !best.rules_out(part.live.near) {
                return Ok(part);
            }
            why = Ending::Settled;
        }
        Err(why)
    }
}
