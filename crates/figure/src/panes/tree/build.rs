//! The tree that a builder has made so far.

use std::borrow::Cow;

use glam::Vec2;
use raystep_accel::{Direction, NodeId, PrimId};

use super::branches::{Tree, TreeView};
use super::draw::draw_tree;
use crate::moments::GrowMoment;
use crate::page::{Figure, Look};
use crate::theme::Role;
use crate::world::Levels;

/// The tree at a moment of a build.
pub fn tree_of_build(moment: &GrowMoment, view: &TreeView, size: Vec2, look: &Look) -> Figure {
    tree_with(moment, Vec::new(), view, size, look)
}

/// The same, with the nodes marked that a change has touched.
pub(crate) fn tree_with(moment: &GrowMoment, touched: Vec<NodeId>, view: &TreeView, size: Vec2, look: &Look) -> Figure {
    if moment.nodes.is_empty() {
        let mut figure = Figure::new(size);
        look.nothing(&mut figure, "Tree", "No node has come to be yet.");
        return figure;
    }
    let (mut path, roots) = (moment.path(), moment.roots());
    let forest = (2..=FEW).contains(&roots.len()) && moment.nodes.len() <= FEW && !moment.curve.is_empty();
    let forest = if forest { roots } else { Vec::new() };
    // Behind the last node: its number is never shown.
    let ground = NodeId(moment.nodes.last_key_value().map_or(0, |(last, _)| last.0 + 1));
    if !forest.is_empty() {
        path.insert(0, ground);
    }
    draw_tree(&Growing { moment, touched, path, forest, ground }, view, size, look)
}

/// Forests of so many nodes are drawn whole.
const FEW: usize = 72;

/// The state of a node that grows.
pub(crate) fn node_role(moment: &GrowMoment, id: NodeId) -> Role {
    match moment.nodes.get(&id) {
        _ if moment.node == Some(id) => Role::Here,
        // Divided or a leaf; or, where sets are joined, a set by itself.
        Some(_) => Role::Seen,
        // Named by its parent's split, still to be built.
        None => Role::Waiting,
    }
}

/// A tree that grows.
struct Growing<'a> {
    moment: &'a GrowMoment,
    touched: Vec<NodeId>,
    path: Vec<NodeId>,
    /// The roots of several trees that are still to be put together, in their order.
    forest: Vec<NodeId>,
    /// What they stand on.
    ground: NodeId,
}

impl Tree for Growing<'_> {
    fn is_ground(&self, node: NodeId) -> bool {
        !self.forest.is_empty() && node == self.ground
    }

    fn children(&self, node: NodeId) -> Vec<NodeId> {
        if self.is_ground(node) {
            return self.forest.clone();
        }
        self.moment.nodes.get(&node).map(|node| node.children.clone()).unwrap_or_default()
    }

    fn axis(&self, node: NodeId) -> Option<Direction> {
        self.moment.nodes.get(&node)?.split.map(|split| split.axis)
    }

    fn prims(&self, node: NodeId) -> Vec<PrimId> {
        self.moment.nodes.get(&node).map(|node| node.settled.clone()).unwrap_or_default()
    }

    fn role(&self, node: NodeId) -> Role {
        match node_role(self.moment, node) {
            Role::Seen if self.touched.contains(&node) => Role::Plane,
            role => role,
        }
    }

    fn prim_role(&self, prim: PrimId) -> Role {
        if self.moment.prim == Some(prim) { Role::Here } else { Role::Scene }
    }

    fn path(&self) -> Vec<NodeId> {
        if self.path.is_empty() { vec![NodeId::ROOT] } else { self.path.clone() }
    }

    fn levels(&self) -> Cow<'_, Levels> {
        let root = self.path.first().copied().unwrap_or(NodeId::ROOT);
        Cow::Owned(Levels::of(root, |node| self.children(node)))
    }
}
