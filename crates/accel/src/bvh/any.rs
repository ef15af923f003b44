//! A hierarchy over any of the volumes: which one, the rule says.

use super::Bvh;
use crate::{
    Aabb, Accel, BvhRule, BvhVolume, Cancelled, Found, Grow, Hit, NodeId, Observer, Packet, PacketVisit, PrimId,
    Primitives, Ray, Visit, WalkPackets, Want,
};

/// A hierarchy of bounding volumes of one kind.
#[derive(Clone, Debug, PartialEq)]
pub enum AnyBvh {
    /// Of axis-aligned boxes.
    Aabb(Bvh<Aabb>),
}

/// Does the same with the tree of any kind.
macro_rules! each {
    ($any:expr, $tree:ident => $do:expr) => {
        match $any {
            $crate::AnyBvh::Aabb($tree) => $do,
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
            BvhVolume::Aabb => AnyBvh::Aabb(Bvh::over(prims, rule, watch)?),
        })
    }

    /// The box around the root's volume; empty if there are no primitives.
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

impl WalkPackets for AnyBvh {
    fn walk_packet(
        &self,
        prims: &impl Primitives,
        packet: Packet<'_>,
        want: Want,
        watch: &mut impl Observer<PacketVisit>,
    ) -> Found {
        each!(self, tree => tree.walk_packet(prims, packet, want, watch))
    }
}
