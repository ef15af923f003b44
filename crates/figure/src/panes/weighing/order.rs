//! The list of a hierarchy's primitives along an axis, which is cut between two of them.

use glam::Vec2;
use raystep_accel::{Axis, NodeId, Place, PrimId, Primitives, Structure};

use super::plots::Plot;
use super::sides::members;
use super::{Area, Candidate, ROWS};
use crate::moments::Build;
use crate::page::{Anchor, block, line, write};
use crate::theme::{Face, Role, text_width};

/// The node's primitives in the order of their centres, each with a place on the page: a hierarchy is cut between two.
pub(super) struct Order {
    prims: Vec<PrimId>,
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

impl Plot<'_> {
    /// The list of primitives along an axis, each joined to its centre.
    pub(super) fn list(&mut self, axis: Axis, order: Option<&Order>, now: Option<Candidate>) {
        let Some(order) = order else { return };
        let (u, small, space) = (self.look.text, self.look.small(), self.space);
        let count = order.prims.len() as f32;
        for (index, &prim) in order.prims.iter().enumerate() {
            let center = space.at(axis, self.build.prims.bounds(prim).center()[axis]);
            let share = (index as f32 + 0.5) / count;
            let (at, from, size) = match axis {
                Axis::Y => {
                    let y = space.max.y + (space.min.y - space.max.y) * share;
                    let high = ((space.max.y - space.min.y) / count - 3.0).clamp(4.0, u * 1.6);
                    let at = Vec2::new(space.max.x + u * 2.0, y);
                    (at, Vec2::new(space.max.x, center), Vec2::new(u * 1.9, high))
                }
                _ => {
                    let x = space.min.x + (space.max.x - space.min.x) * share;
                    let wide = ((space.max.x - space.min.x) / count - 3.0).clamp(4.0, u * 3.0);
                    let at = Vec2::new(x, space.max.y + u * 2.0);
                    (at, Vec2::new(center, space.max.y), Vec2::new(wide, u * 1.5))
                }
            };
            let role = match now {
                Some(now) if now.axis == axis && !self.hide && (index as u32) < now.below => Role::Below,
                Some(now) if now.axis == axis && !self.hide => Role::Above,
                _ => Role::Edge,
            };
            let edge = if axis == Axis::Y { Vec2::new(size.x * 0.5, 0.0) } else { Vec2::new(0.0, size.y * 0.5) };
            self.figure.add(Role::Hidden, None, line(from, at - edge));
            self.figure.add(role, Some(Place::Prim(prim)), block(at - size * 0.5, size, u * 0.2));
            let place = Some(Place::Prim(prim));
            write(
                self.figure,
                Role::Text,
                place,
                at,
                &prim.0.to_string(),
                small.min(size.y),
                Face::Regular,
                Anchor::Middle,
            );
        }
    }

    /// Where a list can be cut, by how many come to its two sides.
    pub(super) fn cuts(&mut self, order: &Order, now: Option<Candidate>) {
        let (u, small) = (self.look.text, self.look.small() * 0.92);
        let (count, y) = (order.prims.len(), self.bottom());
        for below in 1..count as u32 {
            let x = self.space.min.x + (self.space.max.x - self.space.min.x) * below as f32 / count as f32;
            let at = Vec2::new(x, y);
            self.figure.add(Role::Edge, None, line(at, at + Vec2::new(0.0, u * 0.35)));
            let now = now.is_some_and(|now| now.axis == Axis::X && now.below.abs_diff(below) <= 1);
            let says = format!("{below}|{}", count as u32 - below);
            let wide = (self.space.max.x - self.space.min.x) / count as f32;
            if !now && text_width(&says, Face::Regular, small) < wide - 2.0 {
                let at = at + Vec2::new(0.0, u);
                write(self.figure, Role::Quiet, None, at, &says, small, Face::Regular, Anchor::Middle);
            }
        }
    }
}
