//! A tree as nodes and edges: where the walk stands, what waits, what was seen and what never will be.

mod branches;
mod build;
mod draw;
mod outside;
mod pen;
mod signs;
mod sizes;
mod tidy;

use std::borrow::Cow;
use std::collections::BTreeMap;

use glam::Vec2;
use raystep_accel::{Direction, NodeId, Place, PrimId};

pub(crate) use branches::Tree;
pub use branches::TreeView;
pub use build::tree_of_build;
pub(crate) use build::{node_role, tree_with};
pub(crate) use draw::draw_tree;

use crate::moments::{Moment, Walk};
use crate::page::{Figure, Look};
use crate::theme::Role;
use crate::world::{Levels, Nodes};

/// The structure's tree at a moment of a walk; empty for a structure without nodes.
pub fn tree(walk: &Walk<'_>, moment: &Moment, view: &TreeView, size: Vec2, look: &Look) -> Figure {
    if walk.structure.node_count() == 0 {
        let mut figure = Figure::new(size);
        look.nothing(&mut figure, "Tree", "This structure has no tree.");
        return figure;
    }
    draw_tree(&Walked { walk, moment }, view, size, look)
}

/// How high a pane is in which the whole tree of a structure finds room; nothing for a tree with many nodes.
pub fn tree_height(nodes: &Nodes, look: &Look) -> Option<f32> {
    draw::height(nodes.levels(), look)
}

/// A finished tree with the states that a walk gives its nodes.
pub(crate) struct Walked<'a> {
    pub(crate) walk: &'a Walk<'a>,
    pub(crate) moment: &'a Moment,
}

impl Tree for Walked<'_> {
    fn children(&self, node: NodeId) -> Vec<NodeId> {
        self.walk.structure.children(node)
    }

    fn axis(&self, node: NodeId) -> Option<Direction> {
        self.walk.structure.split(node).map(|(axis, _)| axis)
    }

    fn prims(&self, node: NodeId) -> Vec<PrimId> {
        self.walk.structure.leaf_prims(node).to_vec()
    }

    fn role(&self, node: NodeId) -> Role {
        let place = Place::Node(node);
        match self.moment {
            moment if moment.here == Some(place) => Role::Here,
            moment if moment.guesses.iter().any(|(guess, _)| *guess == place) => Role::Guess,
            moment if moment.waiting(node).is_some() => Role::Waiting,
            moment if moment.seen.contains(&place) => Role::Seen,
            moment if moment.dropped.contains(&place) => Role::Dropped,
            _ => Role::Edge,
        }
    }

    fn prim_role(&self, prim: PrimId) -> Role {
        match self.moment.test_of(prim) {
            _ if self.moment.best.is_some_and(|best| best.prim == prim) => Role::Best,
            Some(test) if test.t.is_some() => Role::Hit,
            Some(_) => Role::Missed,
            None => Role::Scene,
        }
    }

    fn path(&self) -> Vec<NodeId> {
        // Only children of nodes that were entered are ever entered.
        let places = self.moment.seen.iter().chain(&self.moment.here);
        let mut parents = BTreeMap::new();
        let mut last = None;
        for place in places {
            let Place::Node(node) = *place else { continue };
            parents.extend(self.children(node).into_iter().map(|child| (child, node)));
            last = Some(node);
        }
        let mut path: Vec<NodeId> = std::iter::successors(last, |node| parents.get(node).copied()).collect();
        path.reverse();
        if path.is_empty() { vec![NodeId::ROOT] } else { path }
    }

    fn levels(&self) -> Cow<'_, Levels> {
        Cow::Borrowed(self.walk.nodes.levels())
    }
}
