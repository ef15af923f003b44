//! From two children to eight, so that a ray is expected to pay least: the method of Ylitie, Karras and Laine (2017).

use rayon::prelude::*;
use raystep_accel::{Aabb, Mesh};

use super::node::Node;
use crate::build::{Knot, Tree};
use crate::leaf::Four;
use crate::pages::Pages;

/// What a node of eight boxes costs.
const NODE_COST: f32 = 1.0;
/// What a leaf of up to four triangles costs.
const LEAF_COST: f32 = 1.0;
const WHOLE_LEAVES: bool = true;
/// The children of a node.
const WIDE: usize = 8;
/// So many pairs of children below a node are worth a thread of their own.
const WORTH_A_THREAD: usize = 2048;

/// The nodes and leaves, parents before children, siblings side by side.
pub(super) fn nodes(tree: &Tree, mesh: &Mesh) -> (Pages<Node>, Pages<Four>) {
    let mut plans = vec![Plan::default(); tree.pairs.len()];
    if tree.prims.is_empty() {
        let mut nodes = Pages::zeroed(1);
        nodes[0] = Node::EMPTY;
        return (nodes, Pages::zeroed(0));
    }
    plan(tree, &tree.root, &mut plans, 0);
    let plans = Plans { tree, mesh, plans: &plans };
    let below = plans.below(&tree.root);
    let mut nodes = Pages::zeroed(1 + below.nodes as usize);
    let mut leaves = Pages::zeroed(below.leaves as usize);
    if let Some((root, others)) = nodes.split_first_mut() {
        plans.fill(&tree.root, root, others, &mut leaves, Many { nodes: 1, leaves: 0 });
    }
    (nodes, leaves)
}

/// What is planned for a node.
#[derive(Clone, Copy, Default)]
struct Plan {
    /// How many of so many roots, less one, stand on the left; none where one root fewer does as well.
    lefts: [u8; WIDE],
    /// Whether all below it makes one leaf.
    leaf: bool,
    /// What is below it, if it makes a node.
    below: Many,
}

/// So many nodes and leaves.
#[derive(Clone, Copy, Default)]
struct Many {
    nodes: u32,
    leaves: u32,
}

impl std::ops::Add for Many {
    type Output = Many;

    fn add(self, other: Many) -> Many {
        Many { nodes: self.nodes + other.nodes, leaves: self.leaves + other.leaves }
    }
}

/// What all below a node costs, itself included, if its trees have up to so many roots, less one; how much that is; and how
/// many triangles.
struct Costs {
    costs: [f32; WIDE],
    many: [Many; WIDE],
    count: u32,
}

/// Finds the plans of a node and of all below it: `plans` begins with that of pair `first`, which is the node's.
fn plan(tree: &Tree, knot: &Knot, plans: &mut [Plan], first: usize) -> Costs {
    let area = half_area(&knot.bounds);
    let leaf = Many { nodes: 0, leaves: 1 };
    let Some([left, right]) = tree.children(knot) else {
        return Costs { costs: [area * LEAF_COST; WIDE], many: [leaf; WIDE], count: knot.range().1 };
    };
    let (own, below) = plans.split_at_mut(1);
    // The pairs below the left child stand before those below the right one.
    let middle = if tree.children(right).is_some() { right.pair() - first - 1 } else { below.len() };
    let (below_left, below_right) = below.split_at_mut(middle);
    let worth_it = below_left.len().min(below_right.len()) >= WORTH_A_THREAD;
    let mut plan_left = || plan(tree, left, below_left, first + 1);
    let mut plan_right = || plan(tree, right, below_right, first + 1 + middle);
    let (left, right) = if worth_it { rayon::join(plan_left, plan_right) } else { (plan_left(), plan_right()) };
    let count = left.count + right.count;
    let (mut costs, mut many, mut plan) = ([0.0; WIDE], [leaf; WIDE], Plan::default());
    // The least cost if the node itself is opened, and its children's trees have so many roots.
    for roots in 2..=WIDE {
        let (mut least, mut best) = (f32::INFINITY, 1);
        for on_left in 1..roots {
            let cost = left.costs[on_left - 1] + right.costs[roots - on_left - 1];
            if cost < least {
                (least, best) = (cost, on_left);
            }
        }
        (costs[roots - 1], plan.lefts[roots - 1]) = (least, best as u8);
        many[roots - 1] = left.many[best - 1] + right.many[roots - best - 1];
    }
    // With one root: a node of eight children. More roots than are of use are not used.
    plan.below = many[WIDE - 1];
    costs[0] = costs[WIDE - 1] + area * NODE_COST;
    many[0] = plan.below + Many { nodes: 1, leaves: 0 };
    if count as usize <= Four::LANES && area * LEAF_COST <= costs[0] {
        (costs[0], many[0], plan.leaf) = (area * LEAF_COST, leaf, true);
    }
    for roots in 2..WIDE {
        if costs[roots - 2] <= costs[roots - 1] {
            (costs[roots - 1], many[roots - 1], plan.lefts[roots - 1]) = (costs[roots - 2], many[roots - 2], 0);
        }
    }
    // What makes one leaf is not parted again.
    if plan.leaf && WHOLE_LEAVES {
        (costs, many, plan.lefts) = ([costs[0]; WIDE], [leaf; WIDE], [0; WIDE]);
    }
    own[0] = plan;
    Costs { costs, many, count }
}

/// The plans for each pair of children, about their parent.
struct Plans<'a> {
    tree: &'a Tree,
    mesh: &'a Mesh,
    plans: &'a [Plan],
}

impl<'a> Plans<'a> {
    /// The children of a node that is not planned to be a leaf.
    fn inner(&self, knot: &Knot) -> Option<&'a [Knot; 2]> {
        self.tree.children(knot).filter(|_| !self.plans[knot.pair()].leaf)
    }

    /// What is below a node.
    fn below(&self, knot: &Knot) -> Many {
        match self.inner(knot) {
            Some(_) => self.plans[knot.pair()].below,
            None => Many { nodes: 0, leaves: 1 },
        }
    }

    /// Opens a node and finds the roots of the trees below it, `roots` at most.
    fn open(&self, knot: &'a Knot, [left, right]: &'a [Knot; 2], roots: usize, found: &mut Vec<&'a Knot>) {
        let on_left = usize::from(self.plans[knot.pair()].lefts[roots - 1]);
        self.root(left, on_left, found);
        self.root(right, roots - on_left, found);
    }

    /// Finds the roots for a node's tree, `roots` at most: itself or some below it.
    fn root(&self, knot: &'a Knot, mut roots: usize, found: &mut Vec<&'a Knot>) {
        let Some(children) = self.tree.children(knot) else { return found.push(knot) };
        while roots > 1 && self.plans[knot.pair()].lefts[roots - 1] == 0 {
            roots -= 1;
        }
        if roots > 1 { self.open(knot, children, roots, found) } else { found.push(knot) }
    }

    /// Fills a node with the children that were planned for it, and then those: all that is below it goes into `nodes` and
    /// `leaves`, the first of which have the numbers `first`.
    fn fill(&self, knot: &'a Knot, node: &mut Node, nodes: &mut [Node], leaves: &mut [Four], first: Many) {
        let mut children = Vec::with_capacity(WIDE);
        match self.inner(knot) {
            Some(own) => self.open(knot, own, WIDE, &mut children),
            // A leaf alone still needs a node above it.
            None => children.push(knot),
        }
        // Those that are nodes first.
        children.sort_by_key(|child| self.inner(child).is_none());
        let inner = children.iter().filter(|child| self.inner(child).is_some()).count();
        let boxes: Vec<&Aabb> = children.iter().map(|child| &child.bounds).collect();
        *node = Node::new(&boxes, inner, first.nodes as usize, first.leaves as usize);
        let worth_it = nodes.len() >= WORTH_A_THREAD;
        let (own, mut nodes) = nodes.split_at_mut(inner);
        let (own_leaves, mut leaves) = leaves.split_at_mut(children.len() - inner);
        let mut next = first + Many { nodes: inner as u32, leaves: (children.len() - inner) as u32 };
        let mut prims = Vec::with_capacity(Four::LANES);
        for (child, leaf) in children[inner..].iter().zip(own_leaves) {
            prims.clear();
            self.tree.all_prims(child, &mut prims);
            *leaf = Four::of(self.mesh, &prims);
        }
        let parts = children[..inner].iter().zip(own).map(|(child, node)| {
            let (below, first) = (self.below(child), next);
            next = next + below;
            let part = nodes.split_off_mut(..below.nodes as usize).unwrap_or_default();
            (*child, node, part, leaves.split_off_mut(..below.leaves as usize).unwrap_or_default(), first)
        });
        if worth_it {
            let parts: Vec<_> = parts.collect();
            parts.into_par_iter().for_each(|(child, node, nodes, leaves, first)| {
                self.fill(child, node, nodes, leaves, first);
            });
        } else {
            parts.for_each(|(child, node, nodes, leaves, first)| self.fill(child, node, nodes, leaves, first));
        }
    }
}

/// Half the surface of a box.
fn half_area(bounds: &Aabb) -> f32 {
    let side = bounds.extent();
    side.x * side.y + side.y * side.z + side.z * side.x
}
