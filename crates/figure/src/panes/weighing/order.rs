//! The list of a hierarchy's primitives along an axis, which is cut between two of them.

use raystep_accel::{Axis, NodeId, PrimId, Primitives, Structure};

use super::sides::members;
use super::{Area, ROWS};
use crate::moments::Build;

/// The node's primitives in the order of their centres, each with a place on the page: a hierarchy is cut between two.
pub(super) struct Order {
    pub(super) prims: Vec<PrimId>,
}

impl Order {
    /// The sorted primitives, where a hierarchy has few.
    pub(super) fn of(build: &Build<'_>, node: NodeId, axis: Axis) -> Option<Order> {
        let Structure::Bvh(_) = build.structure else { return None };
        let mut prims = members(build, node);
        let center = |prim: &PrimId| build.prims.bounds(*prim).center()[axis];
        prims.sort_by(|a, b| center(a).total_cmp(&center(b)).then(a.cmp(b)));
        (prims.len() <= ROWS).then_some(Order { prims })
    }

    /// How far along the list a cut lies with so many below it.
    pub(super) fn share(&self, below: u32) -> f32 {
        below as f32 / self.prims.len().max(1) as f32
    }

    /// The first primitive above the cut that lies nearest to a share of the list.
    pub(super) fn after(&self, share: f32) -> Option<PrimId> {
        let last = self.prims.len().checked_sub(1)?;
        let below = (share * self.prims.len() as f32).round().clamp(1.0, last.max(1) as f32);
        self.prims.get(below as usize).copied()
    }
}

/// Where a cut lies along its axis: between two primitives of the list, or at its plane.
pub(super) fn place_of(space: &Area, axis: Axis, order: Option<&Order>, plane: f32, below: u32) -> f32 {
    match order {
        Some(order) => space.along(axis, order.share(below)),
        None => space.at(axis, plane),
    }
}
