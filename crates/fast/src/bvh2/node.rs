//! A node in one cache line.

use bytemuck::{Pod, Zeroable};
use raystep_accel::{Aabb, Mesh};

use crate::build::{Knot, Tree};
use crate::leaf::Four;

/// Both children of a node.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C, align(64))]
pub(crate) struct Node {
    /// For each axis the lower planes of both children, then the upper ones.
    pub(crate) planes: [[f32; 4]; 3],
    /// Where the children are.
    pub(crate) children: [Child; 2],
    spare: [u32; 2],
}

/// A child: the number of an inner node, or that of a leaf.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Pod, Zeroable)]
#[repr(transparent)]
pub(crate) struct Child(u32);

impl Child {
    pub(crate) const ROOT: Child = Child(0);
    const LEAF: u32 = 1 << 31;

    pub(crate) fn inner(node: usize) -> Child {
        assert!(node < Child::LEAF as usize, "more nodes than can be told apart");
        Child(node as u32)
    }

    pub(crate) fn leaf(leaf: usize) -> Child {
        assert!(leaf < Child::LEAF as usize, "more leaves than can be told apart");
        Child(leaf as u32 | Child::LEAF)
    }

    /// As one number, for a stack.
    #[inline(always)]
    pub(crate) fn number(self) -> u32 {
        self.0
    }

    /// The child of such a number.
    #[inline(always)]
    pub(crate) fn numbered(number: u32) -> Child {
        Child(number)
    }

    #[inline(always)]
    pub(crate) fn is_leaf(self) -> bool {
        self.0 & Child::LEAF != 0
    }

    #[inline(always)]
    pub(crate) fn index(self) -> usize {
        (self.0 & !Child::LEAF) as usize
    }
}

impl Node {
    const EMPTY: Node = Node {
        planes: [[f32::INFINITY, f32::INFINITY, f32::NEG_INFINITY, f32::NEG_INFINITY]; 3],
        children: [Child::ROOT; 2],
        spare: [0; 2],
    };

    fn set(&mut self, side: usize, bounds: &Aabb, child: Child) {
        for (axis, planes) in self.planes.iter_mut().enumerate() {
            planes[side] = bounds.min[axis];
            planes[side + 2] = bounds.max[axis];
        }
        self.children[side] = child;
    }

    /// A child's box.
    pub(crate) fn bounds(&self, side: usize) -> Aabb {
        let [x, y, z] = self.planes;
        Aabb {
            min: glam::Vec3::new(x[side], y[side], z[side]),
            max: glam::Vec3::new(x[side + 2], y[side + 2], z[side + 2]),
        }
    }
}

/// The nodes and leaves of a tree, parents before children and near each other.
pub(crate) fn nodes(tree: &Tree, mesh: &Mesh) -> (Vec<Node>, Vec<Four>) {
    let mut laying = Laying { tree, mesh, nodes: vec![Node::EMPTY], leaves: Vec::new() };
    if !tree.prims.is_empty() {
        match tree.children(&tree.root) {
            Some(children) if !laying.merges(&tree.root) => laying.fill(0, children),
            // A leaf alone still needs a node above it.
            _ => {
                let leaf = laying.leaf(&tree.root);
                laying.nodes[0].set(0, &tree.root.bounds, leaf);
            }
        }
    }
    (laying.nodes, laying.leaves)
}

struct Laying<'a> {
    tree: &'a Tree,
    mesh: &'a Mesh,
    nodes: Vec<Node>,
    leaves: Vec<Four>,
}

impl Laying<'_> {
    fn leaf(&mut self, knot: &Knot) -> Child {
        let mut prims = Vec::with_capacity(Four::LANES);
        self.tree.all_prims(knot, &mut prims);
        self.leaves.push(Four::of(self.mesh, &prims));
        Child::leaf(self.leaves.len() - 1)
    }

    /// Whether a node's triangles fit in one leaf, which is never dearer than two.
    fn merges(&self, knot: &Knot) -> bool {
        self.tree.has_few(knot, Four::LANES)
    }

    fn fill(&mut self, node: usize, children: &[Knot; 2]) {
        for (side, knot) in children.iter().enumerate() {
            let child = match self.tree.children(knot) {
                Some(below) if !self.merges(knot) => {
                    let child = self.nodes.len();
                    self.nodes.push(Node::EMPTY);
                    self.fill(child, below);
                    Child::inner(child)
                }
                _ => self.leaf(knot),
            };
            self.nodes[node].set(side, &knot.bounds, child);
        }
    }
}
