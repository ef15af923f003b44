//! From two children to eight, so that a ray is expected to pay least: the method of Ylitie, Karras and Laine (2017).

use raystep_accel::{Aabb, Mesh};

use super::node::Node;
use crate::build::{Knot, Tree};
use crate::leaf::Four;

/// What a node of eight boxes costs.
const NODE_COST: f32 = 1.0;
/// What a leaf of up to four triangles costs.
const LEAF_COST: f32 = 1.0;
/// The children of a node.
const WIDE: usize = 8;

/// The nodes and leaves, parents before children, siblings side by side.
pub(super) fn nodes(tree: &Tree, mesh: &Mesh) -> (Vec<Node>, Vec<Four>) {
    let mut plans = Plans { tree, plans: vec![Plan::default(); tree.pairs.len()] };
    let mut laid = Laid { mesh, nodes: vec![Node::EMPTY], leaves: Vec::new() };
    if !tree.prims.is_empty() {
        plans.plan(&tree.root);
        laid.fill(0, &tree.root, &plans);
    }
    (laid.nodes, laid.leaves)
}

/// What the tree below a node costs at least.
#[derive(Clone, Copy, Default)]
struct Plan {
    /// With up to so many roots, less one.
    costs: [f32; WIDE],
    /// How many of so many roots, less one, stand on the left; none where one root fewer does as well.
    lefts: [u8; WIDE],
    /// Whether all below it makes one leaf.
    leaf: bool,
}

/// What a node and all below it cost, and how many triangles that is.
type Costs = ([f32; WIDE], u32);

/// A plan for each pair of children, about their parent.
struct Plans<'a> {
    tree: &'a Tree,
    plans: Vec<Plan>,
}

impl<'a> Plans<'a> {
    /// Finds the plans of a node and of all below it; the costs of the node.
    fn plan(&mut self, knot: &Knot) -> Costs {
        let area = half_area(&knot.bounds);
        let Some([left, right]) = self.tree.children(knot) else { return ([area * LEAF_COST; WIDE], knot.range().1) };
        let ((left, on_left), (right, on_right)) = (self.plan(left), self.plan(right));
        let count = on_left + on_right;
        let mut plan = Plan::default();
        // The least cost if the node itself is opened, and its children's trees have so many roots.
        for roots in 2..=WIDE {
            let (mut least, mut best) = (f32::INFINITY, 1);
            for on_left in 1..roots {
                let cost = left[on_left - 1] + right[roots - on_left - 1];
                if cost < least {
                    (least, best) = (cost, on_left);
                }
            }
            (plan.costs[roots - 1], plan.lefts[roots - 1]) = (least, best as u8);
        }
        // With one root: a node of eight children. More roots than are of use are not used.
        plan.costs[0] = plan.costs[WIDE - 1] + area * NODE_COST;
        if count as usize <= Four::LANES && area * LEAF_COST <= plan.costs[0] {
            (plan.costs[0], plan.leaf) = (area * LEAF_COST, true);
        }
        for roots in 2..WIDE {
            if plan.costs[roots - 2] <= plan.costs[roots - 1] {
                (plan.costs[roots - 1], plan.lefts[roots - 1]) = (plan.costs[roots - 2], 0);
            }
        }
        self.plans[knot.pair()] = plan;
        (plan.costs, count)
    }

    /// The children of a node that is not planned to be a leaf.
    fn inner(&self, knot: &Knot) -> Option<&'a [Knot; 2]> {
        self.tree.children(knot).filter(|_| !self.plans[knot.pair()].leaf)
    }

    /// Opens a node and finds the roots of the trees below it, `roots` at most.
    fn open(&self, knot: &'a Knot, roots: usize, found: &mut Vec<&'a Knot>) {
        let Some([left, right]) = self.inner(knot) else {
            found.push(knot);
            return;
        };
        let on_left = usize::from(self.plans[knot.pair()].lefts[roots - 1]);
        self.root(left, on_left, found);
        self.root(right, roots - on_left, found);
    }

    /// Finds the roots for a node's tree, `roots` at most: itself or some below it.
    fn root(&self, knot: &'a Knot, mut roots: usize, found: &mut Vec<&'a Knot>) {
        if self.inner(knot).is_some() {
            while roots > 1 && self.plans[knot.pair()].lefts[roots - 1] == 0 {
                roots -= 1;
            }
            if roots > 1 {
                return self.open(knot, roots, found);
            }
        }
        found.push(knot);
    }
}

struct Laid<'a> {
    mesh: &'a Mesh,
    nodes: Vec<Node>,
    leaves: Vec<Four>,
}

impl Laid<'_> {
    /// Fills a node with the children that were planned for it, and then those.
    fn fill(&mut self, at: usize, knot: &Knot, plans: &Plans<'_>) {
        let mut children = Vec::with_capacity(WIDE);
        plans.open(knot, WIDE, &mut children);
        // Those that are nodes first.
        children.sort_by_key(|child| plans.inner(child).is_none());
        let nodes = children.iter().filter(|child| plans.inner(child).is_some()).count();
        let boxes: Vec<&Aabb> = children.iter().map(|child| &child.bounds).collect();
        let (first_node, first_leaf) = (self.nodes.len(), self.leaves.len());
        self.nodes[at] = Node::new(&boxes, nodes, first_node, first_leaf);
        self.nodes.resize(first_node + nodes, Node::EMPTY);
        for leaf in &children[nodes..] {
            let mut prims = Vec::with_capacity(Four::LANES);
            plans.tree.all_prims(leaf, &mut prims);
            self.leaves.push(Four::of(self.mesh, &prims));
        }
        for (i, child) in children[..nodes].iter().enumerate() {
            self.fill(first_node + i, child, plans);
        }
    }
}

/// Half the surface of a box.
fn half_area(bounds: &Aabb) -> f32 {
    let side = bounds.extent();
    side.x * side.y + side.y * side.z + side.z * side.x
}
