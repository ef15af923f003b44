//! Binary space partition, slides 28-46: trees that cut space in two by a plane, again and again.
//!
//! The planes of the general tree stand free in space (slide 45, `free/`); those of a kd-tree, its special case,
//! stand across axes ([`kd`](crate::kd)). The two differ in how a plane stands, how a node is packed, and which
//! plane a builder takes. The tree, the loop that builds it (`build.rs`) and its walk (`walk.rs`) stand here once.

mod build;
mod free;
mod walk;

pub(crate) use build::{Cutter, Half, Stops};
pub use free::{Bsp, BspNode, ConvexCell, FreePlane};
pub(crate) use walk::{Meeting, split};

use std::fmt::Debug;

use crate::{Aabb, Direction, Margin, NodeId, PrimId, Ray, Visit};

/// The deepest a tree can be, and so the most nodes that can wait; the root has depth 0.
const DEEPEST: usize = 64;

/// A plane that cuts space.
pub trait Plane: Copy + Debug + PartialEq {
    /// What it takes to cut a ray by it.
    const TEST: PlaneTest;

    /// The direction across which it stands, and its place along that direction.
    fn stand(self) -> (Direction, f32);

    /// The plane and the ray along the plane's direction.
    fn across(self, ray: &Ray) -> Meeting;

    /// What keeps the ray from being told its way along any plane's direction, if anything does.
    fn bars(ray: &Ray) -> Option<Visit>;
}

/// What it takes to cut a ray by one plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PlaneTest {
    /// How many numbers say where the plane is.
    pub numbers: u32,
    /// Multiplications.
    pub products: u32,
    /// Additions and subtractions.
    pub sums: u32,
    /// Divisions.
    pub quotients: u32,
}

/// A node, however it is packed.
pub trait Node: Copy + Debug + PartialEq {
    /// What it is cut by.
    type Plane: Plane;

    /// The most nodes and references that it can count.
    const MOST: u32;

    /// An inner node whose children are `below` and the node after it.
    fn inner(plane: Self::Plane, below: NodeId) -> Self;

    /// A leaf with `count` references from `first` on.
    fn leaf(first: u32, count: u32) -> Self;

    /// Unpacks it.
    fn kind(self) -> Kind<Self::Plane>;
}

/// What a node says when it is unpacked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind<P> {
    /// An inner node: a plane and two children.
    Inner {
        /// What it is cut by.
        plane: P,
        /// The child below the plane.
        below: NodeId,
        /// The child above the plane.
        above: NodeId,
    },
    /// A leaf: a run of references.
    Leaf {
        /// The first of them.
        first: u32,
        /// How many they are.
        count: u32,
    },
}

/// A tree of planes. Only leaves refer to primitives; a primitive that lies on both sides of a plane is
/// referred to from both. Siblings are neighbours in the array of nodes.
#[derive(Clone, Debug, PartialEq)]
pub struct PlaneTree<N> {
    pub(crate) bounds: Aabb,
    pub(crate) margin: Margin,
    pub(crate) mailbox: bool,
    pub(crate) nodes: Vec<N>,
    /// The references of all leaves, one leaf after the other.
    pub(crate) refs: Vec<PrimId>,
}

impl<N: Node> PlaneTree<N> {
    /// The deepest a tree can be; the root has depth 0.
    pub const DEEPEST: usize = DEEPEST;

    /// How many bytes a node takes.
    pub const NODE_BYTES: usize = size_of::<N>();

    /// What it takes to cut a ray by one of its planes.
    pub const PLANE_TEST: PlaneTest = N::Plane::TEST;

    /// The box around all primitives, which is the root's; empty if there are none.
    pub fn bounds(&self) -> Aabb {
        self.bounds
    }

    /// The number of nodes, leaves included; 1 if there are no primitives.
    pub fn node_count(&self) -> usize {
        self.nodes.len()
    }

    /// The number of references from leaves to primitives.
    pub fn reference_count(&self) -> usize {
        self.refs.len()
    }

    /// A node's children, the one below its plane first, or nothing for a leaf.
    pub fn children(&self, node: NodeId) -> Option<[NodeId; 2]> {
        match self.nodes[node.index()].kind() {
            Kind::Inner { below, above, .. } => Some([below, above]),
            Kind::Leaf { .. } => None,
        }
    }

    /// The plane across a node, or nothing for a leaf.
    pub fn plane(&self, node: NodeId) -> Option<N::Plane> {
        match self.nodes[node.index()].kind() {
            Kind::Inner { plane, .. } => Some(plane),
            Kind::Leaf { .. } => None,
        }
    }

    /// The primitives that a leaf refers to; empty for inner nodes.
    pub fn leaf_prims(&self, node: NodeId) -> &[PrimId] {
        match self.nodes[node.index()].kind() {
            Kind::Inner { .. } => &[],
            Kind::Leaf { first, count } => &self.refs[first as usize..(first + count) as usize],
        }
    }

    /// What keeps the ray from being told which side of a plane it is on, if anything does.
    #[inline]
    pub(crate) fn bars(&self, ray: &Ray) -> Option<Visit> {
        self.margin.bars(ray).or_else(|| N::Plane::bars(ray))
    }

    /// What of the whole each node covers, where `cut` says what of a node its two children cover.
    pub(crate) fn spread<S: Clone>(&self, whole: S, cut: impl Fn(&S, N::Plane) -> [S; 2]) -> Vec<S> {
        let mut spaces = vec![whole; self.nodes.len()];
        // Parents come before their children.
        for (i, node) in self.nodes.iter().enumerate() {
            if let Kind::Inner { plane, below, above } = node.kind() {
                [spaces[below.index()], spaces[above.index()]] = cut(&spaces[i], plane);
            }
        }
        spaces
    }

    /// How much memory it takes.
    pub fn bytes(&self) -> usize {
        size_of::<Self>() + size_of_val(&*self.nodes) + size_of_val(&*self.refs)
    }
}
