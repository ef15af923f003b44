//! A tree in the making: sets that are joined and moved until one is left, then laid out.

use super::{Bvh, BvhNode, SAH_DEPTH};
use crate::events::{BETWEEN_LOOKS, Unheard};
use crate::{Aabb, BvhRule, Cancelled, Draft, Grow, LeafReason, NodeId, Observer, PrimId, Primitives, Volume};

/// A node of a tree in the making.
struct Bud<D> {
    draft: D,
    bounds: Aabb,
    parent: Option<u32>,
    below: Below,
    /// How many primitives lie below.
    count: u32,
}

#[derive(Clone, Copy)]
enum Below {
    Prim(PrimId),
    Two([u32; 2]),
}

/// Sets of primitives, joined to trees. Their ids are not final: they begin where the final ones end.
pub(super) struct Sapling<'a, D, P> {
    buds: Vec<Bud<D>>,
    prims: &'a P,
    boxes: Vec<Aabb>,
    pub(super) rule: &'a BvhRule,
}

/// How far apart two sets are: the smaller, the sooner they are joined.
pub(super) type Nearness = [u32; 2];

/// A node on its way to its place.
enum Task {
    /// As it was put together.
    Bud(u32),
    /// Too deep: these primitives are halved on.
    Halves(Vec<PrimId>),
}

impl<'a, D: Draft, P: Primitives> Sapling<'a, D, P> {
    pub(super) fn new(prims: &'a P, boxes: Vec<Aabb>, rule: &'a BvhRule) -> Self {
        Sapling { buds: Vec::with_capacity(2 * boxes.len()), prims, boxes, rule }
    }

    /// How many primitives there are.
    pub(super) fn len(&self) -> usize {
        self.boxes.len()
    }

    /// What a set is called until the tree stands.
    pub(super) fn id(&self, bud: u32) -> NodeId {
        NodeId(2 * self.boxes.len() as u32 - 1 + bud)
    }

    /// A set of one primitive.
    pub(super) fn sprout(&mut self, prim: PrimId, watch: &mut impl Observer<Grow>) -> u32 {
        let mut corners = Vec::new();
        self.prims.shape(prim).corners(|corner| corners.push(corner));
        let bounds = self.boxes[prim.index()];
        let draft = D::of(&corners, &bounds);
        self.buds.push(Bud { draft, bounds, parent: None, below: Below::Prim(prim), count: 1 });
        let bud = self.buds.len() as u32 - 1;
        watch.on(Grow::Open { node: self.id(bud), bounds, prims: 1, depth: 0 });
        bud
    }

    /// All primitives as sets of one.
    pub(super) fn sprout_all(&mut self, watch: &mut impl Observer<Grow>) -> Result<Vec<u32>, Cancelled> {
        let mut buds = Vec::with_capacity(self.boxes.len());
        for prim in 0..self.boxes.len() {
            if prim % BETWEEN_LOOKS == 0 && watch.cancelled() {
                return Err(Cancelled);
            }
            buds.push(self.sprout(PrimId(prim as u32), watch));
        }
        Ok(buds)
    }

    /// Joins two sets.
    pub(super) fn join(&mut self, left: u32, right: u32, watch: &mut impl Observer<Grow>) -> u32 {
        let (a, b) = (&self.buds[left as usize], &self.buds[right as usize]);
        let (draft, bounds, count) = (a.draft.join(&b.draft), a.bounds.union(b.bounds), a.count + b.count);
        self.buds.push(Bud { draft, bounds, parent: None, below: Below::Two([left, right]), count });
        let bud = self.buds.len() as u32 - 1;
        for child in [left, right] {
            self.buds[child as usize].parent = Some(bud);
        }
        watch.on(Grow::Merge { node: self.id(bud), left: self.id(left), right: self.id(right), bounds });
        bud
    }

    /// Hangs a set under another one in the place of `old`.
    pub(super) fn hang(&mut self, bud: u32, parent: u32, old: u32, watch: &mut impl Observer<Grow>) {
        self.buds[bud as usize].parent = Some(parent);
        if let Below::Two(children) = &mut self.buds[parent as usize].below
            && let Some(place) = children.iter_mut().find(|child| **child == old)
        {
            *place = bud;
        }
        let cost = self.measure(bud);
        watch.on(Grow::Move { node: self.id(bud), parent: self.id(parent), cost });
    }

    /// Bounds a set anew after what lies below has changed.
    pub(super) fn refit(&mut self, bud: u32, watch: &mut impl Observer<Grow>) {
        let Below::Two([left, right]) = self.buds[bud as usize].below else { return };
        let (a, b) = (&self.buds[left as usize], &self.buds[right as usize]);
        let (draft, bounds, count) = (a.draft.join(&b.draft), a.bounds.union(b.bounds), a.count + b.count);
        let old = &mut self.buds[bud as usize];
        let grew = old.bounds != bounds;
        (old.draft, old.bounds, old.count) = (draft, bounds, count);
        if grew {
            watch.on(Grow::Refit { node: self.id(bud), bounds });
        }
    }

    /// Tells that a set was looked at.
    pub(super) fn touch(&self, bud: u32, watch: &mut impl Observer<Grow>) {
        watch.on(Grow::Touch { node: self.id(bud) });
    }

    pub(super) fn bounds(&self, bud: u32) -> Aabb {
        self.buds[bud as usize].bounds
    }

    pub(super) fn parent(&self, bud: u32) -> Option<u32> {
        self.buds[bud as usize].parent
    }

    pub(super) fn count(&self, bud: u32) -> u32 {
        self.buds[bud as usize].count
    }

    pub(super) fn children(&self, bud: u32) -> Option<[u32; 2]> {
        match self.buds[bud as usize].below {
            Below::Prim(_) => None,
            Below::Two(children) => Some(children),
        }
    }

    /// How large a set's volume is.
    pub(super) fn measure(&self, bud: u32) -> f32 {
        self.buds[bud as usize].draft.measure(self.rule.measure)
    }

    /// How large the volume around two sets is.
    pub(super) fn joint(&self, a: u32, b: u32) -> f32 {
        self.buds[a as usize].draft.join(&self.buds[b as usize].draft).measure(self.rule.measure)
    }

    /// How large the volume around two sets is, then, where volumes have no size, how long. Bits of numbers
    /// that are not negative sort as the numbers do.
    pub(super) fn nearness(&self, a: u32, b: u32) -> Nearness {
        let length = self.bounds(a).union(self.bounds(b)).extent().element_sum();
        [self.joint(a, b).max(0.0).to_bits(), length.max(0.0).to_bits()]
    }

    /// The primitives below a set, from left to right.
    fn under(&self, bud: u32) -> impl Iterator<Item = PrimId> {
        let mut waiting = vec![bud];
        std::iter::from_fn(move || {
            loop {
                match self.buds[waiting.pop()? as usize].below {
                    Below::Prim(prim) => return Some(prim),
                    Below::Two([left, right]) => waiting.extend([right, left]),
                }
            }
        })
    }

    /// Lays the tree out: the root first, siblings side by side, each node with its true volume.
    pub(super) fn plant<V: Volume>(
        self,
        root: u32,
        bvh: &mut Bvh<V>,
        watch: &mut impl Observer<Grow>,
    ) -> Result<(), Cancelled> {
        let add = |bvh: &mut Bvh<V>, task: &Task, watch: &_| {
            let watch = &mut Unheard(watch);
            let (axes, prims) = (self.rule.axes, self.prims);
            let volume = match task {
                Task::Bud(bud) => V::fit(prims, self.under(*bud), &self.bounds(*bud), axes, watch)?,
                Task::Halves(ids) => V::fit(prims, ids.iter().copied(), &self.around(ids), axes, watch)?,
            };
            bvh.nodes.push(BvhNode { volume, first: 0, count: 0 });
            Ok(NodeId(bvh.nodes.len() as u32 - 1))
        };
        let task = Task::Bud(root);
        let mut waiting = vec![(add(bvh, &task, watch)?, task, 0)];
        while let Some((node, task, depth)) = waiting.pop() {
            if watch.cancelled() {
                return Err(Cancelled);
            }
            let volume = bvh.volume(node).bounds();
            let count = match &task {
                Task::Bud(bud) => {
                    watch.on(Grow::Renumber { from: self.id(*bud), to: node });
                    if volume != self.bounds(*bud) {
                        watch.on(Grow::Refit { node, bounds: volume });
                    }
                    self.count(*bud)
                }
                Task::Halves(ids) => ids.len() as u32,
            };
            // Few enough: a leaf.
            if count <= self.rule.leaf_size.max(1) {
                watch.on(Grow::Leaf { node, prims: count, why: LeafReason::Few });
                match task {
                    Task::Bud(bud) => bvh.settle(node, self.under(bud), watch),
                    Task::Halves(ids) => bvh.settle(node, ids.into_iter(), watch),
                }
                continue;
            }
            let halves = |ids: &[PrimId]| {
                let (below, above) = ids.split_at(ids.len() / 2);
                [Task::Halves(below.to_vec()), Task::Halves(above.to_vec())]
            };
            let (parts, fresh) = match task {
                Task::Bud(bud) => match self.children(bud) {
                    Some(children) if depth < SAH_DEPTH => (children.map(Task::Bud), false),
                    // Below this depth sets are halved, however they were put together.
                    _ => (halves(&self.under(bud).collect::<Vec<_>>()), true),
                },
                Task::Halves(ids) => (halves(&ids), true),
            };
            let [left, right] = [add(bvh, &parts[0], watch)?, add(bvh, &parts[1], watch)?];
            bvh.nodes[node.index()].first = left.0;
            if fresh {
                for (child, part) in [left, right].into_iter().zip(&parts) {
                    let Task::Halves(ids) = part else { continue };
                    let bounds = bvh.volume(child).bounds();
                    watch.on(Grow::Open { node: child, bounds, prims: ids.len() as u32, depth: depth as u32 + 1 });
                }
                watch.on(Grow::Merge { node, left, right, bounds: volume });
            }
            let [below, above] = parts;
            waiting.push((right, above, depth + 1));
            waiting.push((left, below, depth + 1));
        }
        Ok(())
    }

    fn around(&self, ids: &[PrimId]) -> Aabb {
        ids.iter().fold(Aabb::EMPTY, |all, prim| all.union(self.boxes[prim.index()]))
    }
}
