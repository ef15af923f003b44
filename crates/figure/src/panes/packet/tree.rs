//! The tree of a packet: beside each node that rays have come to, a strip of those who took part.

use std::borrow::Cow;

use glam::Vec2;
use raystep_accel::{Direction, Lanes, NodeId, PrimId};

use super::together::{is_best, together};
use crate::moments::{Moment, PacketMoment, PacketWalk, Walk};
use crate::page::{Figure, Look};
use crate::panes::TreeView;
use crate::panes::tree::{Tree, Walked, draw_tree};
use crate::theme::Role;
use crate::world::Levels;

/// The structure's tree at a moment of a packet.
pub(crate) fn tree_of_packet(
    walk: &PacketWalk<'_>,
    moment: &PacketMoment,
    view: &TreeView,
    size: Vec2,
    look: &Look,
) -> Figure {
    match (walk.one(0), together(walk, moment)) {
        (Some(one), Some(shared)) => {
            let lanes = Lanes::none(walk.width());
            draw_tree(&Lined { walk: &one, shared: &shared, moment, lanes }, view, size, look)
        }
        _ => Figure::new(size),
    }
}

/// A finished tree with the states that a packet gives its nodes.
struct Lined<'a> {
    walk: &'a Walk<'a>,
    shared: &'a Moment,
    moment: &'a PacketMoment,
    /// As many as the packet has.
    lanes: Lanes,
}

impl Lined<'_> {
    fn walked(&self) -> Walked<'_> {
        Walked { walk: self.walk, moment: self.shared }
    }
}

impl Tree for Lined<'_> {
    fn children(&self, node: NodeId) -> Vec<NodeId> {
        self.walk.structure.children(node)
    }

    fn axis(&self, node: NodeId) -> Option<Direction> {
        self.walked().axis(node)
    }

    fn prims(&self, node: NodeId) -> Vec<PrimId> {
        self.walked().prims(node)
    }

    fn role(&self, node: NodeId) -> Role {
        self.walked().role(node)
    }

    fn prim_role(&self, prim: PrimId) -> Role {
        if is_best(self.moment, prim) { Role::Best } else { self.walked().prim_role(prim) }
    }

    fn path(&self) -> Vec<NodeId> {
        self.walked().path()
    }

    fn levels(&self) -> Cow<'_, Levels> {
        Cow::Borrowed(self.walk.nodes.levels())
    }

    fn lanes(&self, node: NodeId) -> Option<Lanes> {
        self.moment.lanes_of(node)
    }

    fn has_lanes(&self) -> Option<Lanes> {
        Some(self.lanes)
    }
}
