//! Any of the structures, with what views ask of them.

use crate::{
    Aabb, Accel, Axis, Cancelled, Grow, Hit, List, NodeId, Observer, OneBox, PrimId, Primitives, Ray, Rule, Visit, Want,
};

/// A structure of any kind.
#[derive(Clone, Debug, PartialEq)]
pub enum Structure {
    /// No structure: brute force.
    List(List),
    /// Only the box around everything.
    Slab(OneBox),
}

impl Structure {
    /// Builds what `rule` says over `prims`.
    ///
    /// # Errors
    /// `watch` asked to give up.
    pub fn build(
        prims: &impl Primitives,
        rule: &Rule,
        watch: &mut impl Observer<Grow>,
    ) -> Result<Structure, Cancelled> {
        let _ = (prims, &watch);
        match rule {
            Rule::List => Ok(Structure::List(List)),
            Rule::Slab => Ok(Structure::Slab(OneBox::around(prims))),
            Rule::Grid(_) | Rule::Kd(_) | Rule::Bvh(_) => Ok(Structure::List(List)),
        }
    }

    /// The box around everything; empty for a list, which keeps none.
    pub fn bounds(&self) -> Aabb {
        match self {
            Structure::List(_) => Aabb::EMPTY,
            Structure::Slab(one) => one.bounds,
        }
    }

    /// How many nodes a tree has; 0 in a grid or a list.
    pub fn node_count(&self) -> usize {
        match self {
            Structure::List(_) | Structure::Slab(_) => 0,
        }
    }

    /// The children of a node, the lower or left one first; none of a leaf.
    pub fn children(&self, node: NodeId) -> Vec<NodeId> {
        let _ = node;
        match self {
            Structure::List(_) | Structure::Slab(_) => Vec::new(),
        }
    }

    /// What a leaf refers to, in order; nothing in an inner node.
    pub fn leaf_prims(&self, node: NodeId) -> &[PrimId] {
        let _ = node;
        match self {
            Structure::List(_) | Structure::Slab(_) => &[],
        }
    }

    /// The plane that splits a node's space: only inner nodes of a kd-tree have one.
    pub fn split(&self, node: NodeId) -> Option<(Axis, f32)> {
        let _ = node;
        match self {
            Structure::List(_) | Structure::Slab(_) => None,
        }
    }

    /// The boxes of all nodes, by id.
    pub fn node_bounds(&self) -> Vec<Aabb> {
        match self {
            Structure::List(_) | Structure::Slab(_) => Vec::new(),
        }
    }

    /// How many bytes the structure's arrays take.
    pub fn bytes(&self) -> usize {
        match self {
            Structure::List(_) | Structure::Slab(_) => 0,
        }
    }
}

impl Accel for Structure {
    fn walk(&self, prims: &impl Primitives, ray: &Ray, want: Want, watch: &mut impl Observer<Visit>) -> Option<Hit> {
        match self {
            Structure::List(list) => list.walk(prims, ray, want, watch),
            Structure::Slab(one) => one.walk(prims, ray, want, watch),
        }
    }
}
