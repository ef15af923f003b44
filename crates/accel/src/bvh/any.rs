//! A hierarchy over any of the volumes: which one, the rule says.

use super::Bvh;
use crate::{
    Aabb, Accel, BvhRule, BvhVolume, Cancelled, Grow, Hit, Hull, Interval, KDop, NodeId, Obb, Observer, Outline, Place,
    PrimId, Primitives, Ray, Sphere, Visit, Volume, Want,
};

/// A hierarchy of bounding volumes of one kind.
#[derive(Clone, Debug, PartialEq)]
pub enum AnyBvh {
    /// Of spheres.
    Sphere(Bvh<Sphere>),
    /// Of axis-aligned boxes.
    Aabb(Bvh<Aabb>),
    /// Of oriented boxes.
    Obb(Bvh<Obb>),
    /// Of boxes, as k-DOPs.
    KDop6(Bvh<KDop<0, 0>>),
    /// Of k-DOPs across a cube's faces and corners.
    KDop14(Bvh<KDop<0, 4>>),
    /// Of k-DOPs across a cube's faces and edges.
    KDop18(Bvh<KDop<4, 6>>),
    /// Of k-DOPs across a cube's faces, corners and edges.
    KDop26(Bvh<KDop<0, 10>>),
    /// Of convex hulls.
    Hull(Bvh<Hull>),
}

/// Does the same with the tree of any kind.
macro_rules! each {
    ($any:expr, $tree:ident => $do:expr) => {
        match $any {
            $crate::AnyBvh::Sphere($tree) => $do,
            $crate::AnyBvh::Aabb($tree) => $do,
            $crate::AnyBvh::Obb($tree) => $do,
            $crate::AnyBvh::KDop6($tree) => $do,
            $crate::AnyBvh::KDop14($tree) => $do,
            $crate::AnyBvh::KDop18($tree) => $do,
            $crate::AnyBvh::KDop26($tree) => $do,
            $crate::AnyBvh::Hull($tree) => $do,
        }
    };
}
pub(crate) use each;

impl AnyBvh {
    /// Builds what `rule` says.
    ///
    /// # Errors
    /// The observer cancelled it.
    pub fn build(
        prims: &impl Primitives,
        rule: &BvhRule,
        watch: &mut impl Observer<Grow>,
    ) -> Result<AnyBvh, Cancelled> {
        Ok(match rule.volume {
            BvhVolume::Sphere => AnyBvh::Sphere(Bvh::over(prims, rule, watch)?),
            BvhVolume::Aabb => AnyBvh::Aabb(Bvh::over(prims, rule, watch)?),
            BvhVolume::Obb => AnyBvh::Obb(Bvh::over(prims, rule, watch)?),
            BvhVolume::KDop6 => AnyBvh::KDop6(Bvh::over(prims, rule, watch)?),
            BvhVolume::KDop14 => AnyBvh::KDop14(Bvh::over(prims, rule, watch)?),
            BvhVolume::KDop18 => AnyBvh::KDop18(Bvh::over(prims, rule, watch)?),
            BvhVolume::KDop26 => AnyBvh::KDop26(Bvh::over(prims, rule, watch)?),
            BvhVolume::Hull => AnyBvh::Hull(Bvh::over(prims, rule, watch)?),
        })
    }

    /// The box around all primitives; empty if there are none.
    pub fn bounds(&self) -> Aabb {
        each!(self, tree => tree.bounds())
    }

    /// The number of nodes, leaves included; 0 if there are no primitives.
    pub fn node_count(&self) -> usize {
        each!(self, tree => tree.node_count())
    }

    /// A node's two children, or nothing for a leaf.
    pub fn children(&self, node: NodeId) -> Option<[NodeId; 2]> {
        each!(self, tree => tree.children(node))
    }

    /// The primitives of a leaf; empty for inner nodes.
    pub fn leaf_prims(&self, node: NodeId) -> &[PrimId] {
        each!(self, tree => tree.leaf_prims(node))
    }

    /// The boxes around the volumes of all nodes.
    pub fn node_bounds(&self) -> Vec<Aabb> {
        each!(self, tree => tree.node_bounds())
    }

    /// Tests a node's volume alone, as slide 52 compares them.
    pub fn meet(&self, node: NodeId, ray: &Ray, watch: &mut impl Observer<Visit>) -> Interval {
        each!(self, tree => Volume::meet(tree.volume(node), ray, ray.range(), Place::Node(node), watch))
    }

    /// The surface of a node's volume.
    pub fn outline(&self, node: NodeId) -> Outline {
        each!(self, tree => tree.volume(node).outline())
    }

    /// How much memory it takes.
    pub fn bytes(&self) -> usize {
        each!(self, tree => tree.bytes())
    }
}

impl Accel for AnyBvh {
    fn walk(&self, prims: &impl Primitives, ray: &Ray, want: Want, watch: &mut impl Observer<Visit>) -> Option<Hit> {
        each!(self, tree => tree.walk(prims, ray, want, watch))
    }
}
