//! The kd-tree, slides 28-42 and 60-62, at production speed: nodes of eight bytes, eight of them in a cache line, and
//! leaves whose triangles stand in lanes.

mod node;
mod walk;

use raystep_accel::{Aabb, Hit, Kd as Textbook, KdRule, Margin, Mesh, NodeId, Primitives, Ray, Want};

use crate::fast::Fast;
use crate::judge::{Count, NotOrdinary};
use crate::lanes::{Isa, dispatch};
use crate::leaf::{Four, any_ray};
use node::Node;

/// A kd-tree: the textbook's, packed.
#[derive(Clone, Debug)]
pub struct Kd {
    bounds: Aabb,
    margin: Margin,
    nodes: Vec<Node>,
    leaves: Vec<Four>,
    reach: f32,
    isa: Isa,
}

impl Kd {
    /// Builds it as the textbook does, by surface area, and packs it.
    pub fn build(mesh: &Mesh) -> Kd {
        let tree = match Textbook::build(mesh, &KdRule::default(), &mut ()) {
            Ok(tree) => tree,
            Err(cancelled) => unreachable!("nobody asks to give up: {cancelled}"),
        };
        let bounds = tree.bounds();
        let mut leaves = Vec::new();
        let pack = |node: u32| match (tree.split(NodeId(node)), tree.children(NodeId(node))) {
            (Some((axis, at)), Some([below, _])) => Node::inner(axis, at, below.0),
            _ => {
                let first = leaves.len();
                let prims: Vec<u32> = tree.leaf_prims(NodeId(node)).iter().map(|prim| prim.0).collect();
                leaves.extend(prims.chunks(Four::LANES).map(|prims| Four::of(mesh, prims)));
                Node::leaf(first, leaves.len() - first)
            }
        };
        let nodes = (0..tree.node_count() as u32).map(pack).collect();
        let reach = if bounds.is_empty() { 0.0 } else { bounds.min.abs().max(bounds.max.abs()).max_element() };
        Kd { bounds, margin: Margin::of(&bounds, mesh.len()), nodes, leaves, reach, isa: Isa::best() }
    }

    /// The same with other instructions.
    #[must_use]
    pub fn with(self, isa: Isa) -> Kd {
        Kd { isa, ..self }
    }
}

impl Fast for Kd {
    fn walk(&self, ray: &Ray, want: Want, count: &mut impl Count) -> Option<Hit> {
        // As in the textbook, a ray from too far away cannot be told which cells it meets.
        let walked = if self.margin.bars(ray).is_some() {
            Err(NotOrdinary)
        } else {
            let Kd { nodes, leaves, bounds, reach, .. } = self;
            walk::STACK.with_borrow_mut(|stack| {
                dispatch!(self.isa, walk::walk(nodes, leaves, bounds, ray, *reach, want, stack, count))
            })
        };
        walked.unwrap_or_else(|NotOrdinary| any_ray(&self.leaves, ray, want, count))
    }

    fn bytes(&self) -> usize {
        size_of_val(&*self.nodes) + size_of_val(&*self.leaves)
    }
}
