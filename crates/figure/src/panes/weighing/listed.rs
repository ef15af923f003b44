//! The list of primitives beside a plot, and the cuts between them.

use glam::Vec2;
use raystep_accel::{Axis, Place, Primitives};

use super::Candidate;
use super::order::Order;
use super::plots::Plot;
use crate::page::{Anchor, block, line, write};
use crate::theme::{Face, Role, text_width};

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
