//! A hierarchy of bounding volumes, slides 48-57: primitives in nested sets, each with a volume around it.

mod any;
mod binned;
mod bottom_up;
mod build;
mod insertion;
mod ploc;
mod sapling;
mod split;
mod splitter;
mod sweep;
mod walk;

pub use any::AnyBvh;
pub(crate) use any::each;
pub(crate) use walk::{BvhWalk, Met};

use crate::{Aabb, BvhOrder, BvhRule, Cancelled, Grow, NodeId, Observer, Place, PrimId, Primitives, Volume};

/// Below this depth nodes are split into halves, whatever the rule: no scene can make the tree so deep
/// that a walk's stack overflows.
const SAH_DEPTH: usize = 40;

/// A binary tree of volumes, boxes unless another is named. Siblings are neighbours in the array of nodes, so that a parent needs the
/// place of the first only.
#[derive(Clone, Debug, PartialEq)]
pub struct Bvh<V: Volume = Aabb> {
    /// The box around all primitives.
    bounds: Aabb,
    nodes: Vec<BvhNode<V>>,
    /// The primitives of all leaves, one leaf after the other; each primitive once.
    refs: Vec<PrimId>,
    /// In which order a walk opens the nodes.
    pub(crate) order: BvhOrder,
}

/// A node; of boxes, 32 bytes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BvhNode<V> {
    /// The volume around all that lies below.
    pub(crate) volume: V,
    /// In an inner node the first child, in a leaf the first of its references.
    first: u32,
    /// How many references a leaf has; 0 in an inner node.
    count: u32,
}

impl Bvh {
    /// The deepest a tree can be; the root has depth 0.
    pub const DEEPEST: usize = SAH_DEPTH + u32::BITS as usize;

    /// Builds a hierarchy of boxes over `prims`.
    ///
    /// # Errors
    /// The observer cancelled it.
    pub fn build(prims: &impl Primitives, rule: &BvhRule, watch: &mut impl Observer<Grow>) -> Result<Bvh, Cancelled> {
        Bvh::over(prims, rule, watch)
    }
}

impl<V: Volume> Bvh<V> {
    /// The box around all primitives; empty if there are none.
    pub fn bounds(&self) -> Aabb {
        self.bounds
    }

    /// A node's volume.
    pub fn volume(&self, node: NodeId) -> &V {
        &self.nodes[node.index()].volume
    }

    /// The number of nodes, leaves included; 0 if there are no primitives.
    pub fn node_count(&self) -> usize {
        self.nodes.len()
    }

    /// A node's two children, or nothing for a leaf.
    #[inline]
    pub fn children(&self, node: NodeId) -> Option<[NodeId; 2]> {
        let node = &self.nodes[node.index()];
        (node.count == 0).then_some([NodeId(node.first), NodeId(node.first + 1)])
    }

    /// The primitives of a leaf; empty for inner nodes.
    #[inline]
    pub fn leaf_prims(&self, node: NodeId) -> &[PrimId] {
        let node = &self.nodes[node.index()];
        match node.count {
            0 => &[],
            count => &self.refs[node.first as usize..(node.first + count) as usize],
        }
    }

    /// The boxes around the volumes of all nodes.
    pub fn node_bounds(&self) -> Vec<Aabb> {
        self.nodes.iter().map(|node| node.volume.bounds()).collect()
    }

    /// How much memory it takes.
    pub fn bytes(&self) -> usize {
        let volumes: usize = self.nodes.iter().map(|node| node.volume.bytes() - size_of::<V>()).sum();
        size_of_val(self) + size_of_val(&*self.nodes) + volumes + size_of_val(&*self.refs)
    }

    /// Makes a node a leaf with these primitives.
    fn settle(&mut self, node: NodeId, prims: impl Iterator<Item = PrimId>, watch: &mut impl Observer<Grow>) {
        let first = self.refs.len();
        self.refs.extend(prims);
        self.refs[first..].sort_unstable();
        for &prim in &self.refs[first..] {
            watch.on(Grow::Settle { prim, place: Place::Node(node) });
        }
        let leaf = &mut self.nodes[node.index()];
        (leaf.first, leaf.count) = (first as u32, (self.refs.len() - first) as u32);
    }
}
