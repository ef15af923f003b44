//! The costs of the ways to divide a node: along x under the picture, along y beside it, on the picture's own axes.

use glam::Vec2;
use raystep_accel::{Axis, Direction, NodeId, Place};

use super::order::{Order, place_of};
use super::{Area, Candidate, ahead};
use crate::moments::{Build, GrowMoment, Weighed};
use crate::page::{Anchor, Figure, Ink, Look, Ticks, block, line, write};
use crate::stage::covers;
use crate::theme::{Face, Role, text_width};
use crate::words::{VolumeName, number};

/// The two plots.
pub(super) struct Plot<'a> {
    pub(super) figure: &'a mut Figure,
    pub(super) build: &'a Build<'a>,
    pub(super) moment: &'a GrowMoment,
    pub(super) look: &'a Look,
    pub(super) space: &'a Area,
    /// How high the plot of x is with its list; nothing where nothing is weighed.
    pub(super) costs: f32,
    /// How wide the plot of y is with its list.
    pub(super) beside: f32,
    pub(super) hide: bool,
}

impl Plot<'_> {
    pub(super) fn draw(&mut self, now: Option<Candidate>) {
        let u = self.look.text;
        // Where nothing is weighed no list is cut either.
        let listed =
            self.costs > 0.0 && self.moment.node.is_some_and(|node| Order::of(self.build, node, Axis::X).is_some());
        for axis in [Axis::X, Axis::Y] {
            self.axis(axis, listed);
        }
        let Some(node) = self.moment.node else { return };
        let ahead = ahead(self.build, self.moment, node);
        let (weighed, tried) = self.build.weighed(self.moment);
        let all: Vec<Weighed> = weighed.iter().copied().chain(ahead.iter().copied()).collect();
        // One scale of costs for both, of all that are weighed here: nothing jumps while they come.
        let finite = all.iter().map(|weighed| weighed.cost).filter(|cost| cost.is_finite());
        let (least, most) = finite.fold((f32::INFINITY, f32::NEG_INFINITY), |(a, b), cost| (a.min(cost), b.max(cost)));
        let whole = self.whole(node, now);
        let (least, most) = (least, most.max(whole.as_ref().map_or(most, |(_, cost)| *cost)));
        if least > most {
            return;
        }
        let pad = ((most - least) * 0.12).max(most.abs() * 0.01).max(1e-6);
        let (low, high) = (least - pad, most + pad);
        let bottom = self.bottom();
        let up = Ticks { low, high, left: bottom, right: self.under() + u * 0.6 };
        let right = Ticks { low, high, left: self.across(), right: self.across() + self.wide() };
        if self.hide {
            self.keep_back(bottom);
        } else {
            self.scale(Axis::X, &up);
            self.scale(Axis::Y, &right);
        }
        for axis in [Axis::X, Axis::Y] {
            let order = Order::of(self.build, node, axis);
            self.list(axis, order.as_ref(), now);
            let scale = if axis == Axis::X { up } else { right };
            self.curve(node, axis, order.as_ref(), &weighed, tried, &ahead, &scale, whole.as_ref(), now);
        }
        self.legend(bottom, now, &weighed, &ahead);
    }

    /// Where the plot of x begins, under the picture and a list.
    fn under(&self) -> f32 {
        self.space.max.y + self.look.text * 3.0
    }

    /// Where it ends.
    pub(super) fn bottom(&self) -> f32 {
        self.space.max.y + self.costs
    }

    /// How wide the plot of y is.
    fn wide(&self) -> f32 {
        self.beside - self.look.text * 3.4
    }

    /// Where the plot of y begins, beside the picture and a list.
    fn across(&self) -> f32 {
        self.space.max.x + self.look.text * 3.4
    }

    /// The picture's own axis, with ticks; a list that is cut has its own along x.
    fn axis(&mut self, axis: Axis, listed: bool) {
        let (u, small, space) = (self.look.text, self.look.small(), self.space);
        let (low, high) = (space.seen.min[axis], space.seen.max[axis]);
        let ticks = Ticks { low, high, left: 0.0, right: (space.at(axis, high) - space.at(axis, low)).abs() };
        // Without costs the axis of x is the picture's lower edge.
        let bottom = if self.hide { space.max.y } else { self.bottom() };
        // There the planes have their ticks, and the numbers stand under them.
        let below = if self.hide { u * 2.0 } else { u };
        let values = if listed && axis == Axis::X { Vec::new() } else { ticks.marks(u * 4.0) };
        for value in values {
            let at = space.at(axis, value);
            let (from, along, label, anchor) = match axis {
                Axis::Y => (
                    Vec2::new(space.min.x, at),
                    Vec2::new(-u * 0.35, 0.0),
                    Vec2::new(space.min.x - u * 0.6, at),
                    Anchor::End,
                ),
                _ => (Vec2::new(at, bottom), Vec2::new(0.0, u * 0.35), Vec2::new(at, bottom + below), Anchor::Middle),
            };
            self.figure.add(Role::Edge, None, line(from, from + along));
            write(self.figure, Role::Quiet, None, label, &number(value), small, Face::Regular, anchor);
        }
        let (from, to) = (Vec2::new(space.min.x, bottom), Vec2::new(space.max.x, bottom));
        match axis {
            Axis::Y => {
                let at = Vec2::new(space.min.x - u * 0.6, space.min.y - u * 0.9);
                write(self.figure, Role::Quiet, None, at, "y", small, Face::Medium, Anchor::End);
                if self.beside > 0.0 && !self.hide {
                    let (from, to) = (Vec2::new(self.across(), space.max.y), Vec2::new(self.across(), space.min.y));
                    self.figure.add(Role::Edge, None, line(from, to));
                }
            }
            _ if listed && self.hide => {}
            _ => {
                self.figure.add(Role::Edge, None, line(from, to));
                let at = to + Vec2::new(u * 0.9, below);
                let says = if listed { "along x" } else { "x" };
                write(self.figure, Role::Quiet, None, at, says, small, Face::Medium, Anchor::Start);
            }
        }
    }

    /// Says, where the costs stand otherwise, that they wait for an answer.
    fn keep_back(&mut self, bottom: f32) {
        let (u, space) = (self.look.text, self.space);
        if bottom - self.under() < u * 2.0 {
            return;
        }
        let at = Vec2::new((space.min.x + space.max.x) * 0.5, (self.under() + bottom) * 0.5);
        write(self.figure, Role::Quiet, None, at, "The costs come with the answer.", u, Face::Regular, Anchor::Middle);
    }

    /// The scale of the costs.
    fn scale(&mut self, axis: Axis, ticks: &Ticks) {
        let (u, small, space) = (self.look.text, self.look.small(), self.space);
        let measure = Ticks { left: 0.0, right: (ticks.right - ticks.left).abs(), ..*ticks };
        for cost in measure.marks(u * 3.2) {
            let at = ticks.x(cost);
            let (from, along, label, anchor) = match axis {
                Axis::X => (
                    Vec2::new(space.min.x, at),
                    Vec2::new(-u * 0.35, 0.0),
                    Vec2::new(space.min.x - u * 0.6, at),
                    Anchor::End,
                ),
                _ => (
                    Vec2::new(at, space.max.y),
                    Vec2::new(0.0, u * 0.35),
                    Vec2::new(at, space.max.y + u * 1.0),
                    Anchor::Middle,
                ),
            };
            self.figure.add(Role::Edge, None, line(from, from + along));
            write(self.figure, Role::Quiet, None, label, &number(cost), small, Face::Regular, anchor);
        }
        let (from, to, at, says) = match axis {
            Axis::X => {
                let left = space.min.x;
                let (from, to) = (Vec2::new(left, self.under()), Vec2::new(left, self.bottom()));
                (from, to, from - Vec2::new(u * 0.6, 0.0), "cost")
            }
            _ => {
                let (left, y) = (self.across(), space.max.y);
                let at = Vec2::new(left + self.wide() * 0.5, space.min.y - u * 1.0);
                (Vec2::new(left, y), Vec2::new(left + self.wide(), y), at, "cost, along y")
            }
        };
        self.figure.add(Role::Edge, None, line(from, to));
        let anchor = if axis == Axis::X { Anchor::End } else { Anchor::Middle };
        write(self.figure, Role::Quiet, None, at, says, small, Face::Regular, anchor);
    }

    /// What the node costs if it stays whole, with the words for it.
    fn whole(&self, node: NodeId, now: Option<Candidate>) -> Option<(String, f32)> {
        let prims = self.moment.nodes.get(&node)?.prims;
        let test = now.map(|now| now.test)?;
        let cost = test * prims as f32;
        Some((format!("not divided: {} · {prims} = {}", number(test), number(cost)), cost))
    }

    /// The costs along an axis: what was weighed, the least so far, what is weighed now, what is still to come.
    fn curve(
        &mut self,
        node: NodeId,
        axis: Axis,
        order: Option<&Order>,
        weighed: &[Weighed],
        tried: Option<Weighed>,
        ahead: &[Weighed],
        scale: &Ticks,
        whole: Option<&(String, f32)>,
        now: Option<Candidate>,
    ) {
        let (u, small, space) = (self.look.text, self.look.small(), self.space);
        let place = Some(Place::Node(node));
        let own = |weighed: &&Weighed| weighed.axis == Direction::from(axis) && weighed.cost.is_finite();
        let edge = if axis == Axis::Y { space.max.x + u * 0.4 } else { space.max.y + u * 0.4 };
        let edge = if order.is_some() { edge + u * 2.5 } else { edge };
        let point =
            |across: f32, along: f32| if axis == Axis::Y { Vec2::new(along, across) } else { Vec2::new(across, along) };
        let (low, high) = (scale.left.min(scale.right), scale.left.max(scale.right));
        let cost_at = |weighed: &Weighed| {
            let across = place_of(space, axis, order, weighed.plane, weighed.below);
            point(across, scale.x(weighed.cost).clamp(low, high))
        };
        let tick = |weighed: &Weighed, length: f32| {
            let across = place_of(space, axis, order, weighed.plane, weighed.below);
            line(point(across, edge), point(across, edge + length))
        };
        let waits: Vec<Ink> = ahead.iter().filter(own).map(|weighed| tick(weighed, u * 0.5)).collect();
        let done: Vec<Weighed> = weighed.iter().filter(own).copied().collect();
        let ticks: Vec<Ink> = done.iter().map(|weighed| tick(weighed, u * 0.6)).collect();
        let mut points: Vec<Vec2> = done.iter().map(cost_at).collect();
        let cheapest = Weighed::cheapest(weighed).filter(|least| own(&least));
        let least = cheapest.map(|least| (cost_at(&least), tick(&least, u * 0.7), least.cost));
        let last = tried.or(done.last().copied());
        let here = now.filter(|now| now.axis == axis).and(last).map(|last| (cost_at(&last), last));
        let taken = self.moment.nodes.get(&node).and_then(|node| node.split);
        // Several ways to share out a list may end at one coordinate: the cost tells them apart.
        let is_taken = |weighed: &Weighed| {
            taken.is_some_and(|t| (t.axis, t.plane, t.cost) == (weighed.axis, weighed.plane, weighed.cost))
        };
        let by_hand = done.iter().rfind(|weighed| is_taken(weighed) && cheapest != Some(**weighed));
        let by_hand = by_hand.map(|weighed| (cost_at(weighed), weighed.cost));
        self.figure.marks.extend(waits.into_iter().map(|ink| crate::page::Mark { ink, role: Role::Hidden, place }));
        if self.hide {
            for ink in ticks {
                self.figure.add(Role::Candidate, place, ink);
            }
            return;
        }
        for ink in ticks {
            self.figure.add(Role::Edge, place, ink);
        }
        if let Some((says, cost)) = whole.filter(|_| axis == Axis::X) {
            let y = scale.x(*cost);
            let (from, to) = (Vec2::new(space.min.x, y), Vec2::new(space.max.x, y));
            self.figure.add(Role::Hidden, None, line(from, to));
            // At the end where the curve leaves it room.
            let wide = text_width(says, Face::Regular, small) + u * 0.6;
            let in_row = |at: &&Vec2| (at.y - (y - u * 0.8)).abs() < u;
            let under = |at: &Vec2, from: f32| at.x > from && at.x < from + wide;
            // The line of what is weighed now comes from above.
            let crossed = |from: f32| here.is_some_and(|(at, _)| under(&at, from) && at.y > y - u * 1.4);
            let near = |from: f32| {
                let dots = points.iter().filter(in_row).filter(|at| under(at, from)).count();
                dots + if crossed(from) { points.len() + 1 } else { 0 }
            };
            let (at, anchor) = match near(to.x - wide) > near(from.x) {
                true => (from + Vec2::new(u * 0.3, -u * 0.8), Anchor::Start),
                false => (to - Vec2::new(u * 0.3, u * 0.8), Anchor::End),
            };
            write(self.figure, Role::Quiet, None, at, says, small, Face::Regular, anchor);
        }
        if let (Some(order), Axis::X) = (order, axis) {
            self.cuts(order, now);
        }
        if axis == Axis::Y {
            points.sort_by(|a, b| a.y.total_cmp(&b.y));
        } else {
            points.sort_by(|a, b| a.x.total_cmp(&b.x));
        }
        if points.len() > 1 {
            self.figure.add(Role::Edge, None, Ink::Line { points: points.clone() });
        }
        for center in points {
            self.figure.add(Role::Edge, place, Ink::Circle { center, radius: u * 0.2 });
        }
        // What is weighed now may be the least so far: then one label says both.
        let is_least = match (&least, &here) {
            (Some((least, ..)), Some((here, _))) => taken.is_none() && least.distance(*here) < u * 0.5,
            _ => false,
        };
        if let Some((at, ink, cost)) = least {
            self.figure.add(Role::Best, place, ink);
            self.figure.add(Role::Best, place, Ink::Circle { center: at, radius: u * 0.34 });
            let says = match taken {
                Some(_) if cheapest.is_some_and(|least| is_taken(&least)) => format!("taken: {}", number(cost)),
                Some(_) => format!("least: {}", number(cost)),
                None => format!("least so far: {}", number(cost)),
            };
            if !is_least {
                self.beside_dot(axis, at, &says, Role::Best, u * 1.3);
            }
        }
        if let Some((center, cost)) = by_hand {
            self.figure.add(Role::Tick, place, Ink::Circle { center, radius: u * 0.5 });
            self.beside_dot(axis, center, &format!("taken by hand: {}", number(cost)), Role::Value, -u * 1.3);
        }
        if let Some((at, last)) = here {
            let across = place_of(space, axis, order, last.plane, last.below);
            let cut = match axis {
                Axis::Y => line(Vec2::new(space.min.x, across), at),
                _ => line(Vec2::new(across, space.min.y), at),
            };
            // A hierarchy does not cut space: its line begins at the list.
            let cut = if order.is_some() { line(point(across, edge - u * 1.6), at) } else { cut };
            self.figure.add(Role::Value, place, cut);
            self.figure.add(Role::Tick, place, Ink::Circle { center: at, radius: u * 0.5 });
            let cut = VolumeName::of(self.build.structure).cut;
            let whose = if tried.is_some() { format!("your {cut}:") } else { "cost".to_owned() };
            let so_far = if is_least { ", the least so far" } else { "" };
            self.beside_dot(axis, at, &format!("{whose} {}{so_far}", number(last.cost)), Role::Value, -u * 1.3);
            let says = match order {
                Some(_) => format!("{} | {}", last.below, last.above),
                None => format!("{axis} = {}", number(last.plane)),
            };
            let (size, face, anchor) = (small, Face::Medium, Anchor::Middle);
            let half = text_width(&says, face, size) * 0.5 + u * 0.6;
            let at = match axis {
                Axis::Y => Vec2::new((space.min.x - u * 0.2 - half).max(half), across),
                _ => Vec2::new(across, self.bottom() + u * 1.0),
            };
            self.figure.add(Role::Value, place, Ink::Text { at, text: says, size, face, anchor, boxed: true });
        }
    }

    /// A boxed word beside a dot, where it covers least; of places that are as good, the first.
    fn beside_dot(&mut self, axis: Axis, dot: Vec2, says: &str, role: Role, dy: f32) {
        let (u, small) = (self.look.text, self.look.small());
        let width = text_width(says, Face::Medium, small) + u * 1.2;
        let (left, right) = match axis {
            Axis::Y => (self.across(), self.figure.size.x - u * 0.4),
            _ => (self.space.min.x, self.space.max.x),
        };
        let (low, high) = match axis {
            Axis::Y => (self.space.min.y, self.space.max.y),
            _ => (self.under(), self.bottom()),
        };
        let (least, most) = (left + u * 0.4, (right - width).max(left + u * 0.4));
        let sides = [dot.x + u * 1.4, dot.x - u * 0.6 - width, dot.x - width * 0.5];
        let heights = [dy, -dy, 2.0 * dy, -2.0 * dy, 3.0 * dy, -3.0 * dy].map(|dy| dot.y + dy);
        let label = |x: f32, y: f32| {
            let (at, anchor, face) = (Vec2::new(x.clamp(least, most), y), Anchor::Start, Face::Medium);
            Ink::Text { at, text: says.to_owned(), size: small, face, anchor, boxed: true }
        };
        let inside = heights.into_iter().filter(|y| (low + u..=high - u).contains(y));
        let places = inside.flat_map(|y| sides.map(|x| label(x, y)));
        let cost = |(index, label): &(usize, Ink)| *index as f32 * 2.0 + covers(label, self.figure);
        let best = places.enumerate().min_by(|a, b| cost(a).total_cmp(&cost(b)));
        let ink = best.map_or_else(|| label(sides[0], dot.y + dy), |(_, ink)| ink);
        self.figure.add(role, None, ink);
    }

    /// What the signs mean that are drawn, in the corner that the two plots leave: each always in its own row.
    fn legend(&mut self, bottom: f32, now: Option<Candidate>, weighed: &[Weighed], ahead: &[Weighed]) {
        let (u, small) = (self.look.text, self.look.small());
        let cut = VolumeName::of(self.build.structure).cut;
        let (now, known) = (now.is_some() && !self.hide, !weighed.is_empty() && !self.hide);
        let rows = [
            (now, Role::Tick, format!("{cut} weighed now")),
            (known, Role::Edge, "weighed".to_owned()),
            (known, Role::Best, if ahead.is_empty() { "least" } else { "least so far" }.to_owned()),
            (!ahead.is_empty(), Role::Hidden, "still to weigh".to_owned()),
            (now, Role::Below, "below".to_owned()),
            (now, Role::Above, "above".to_owned()),
        ];
        let left = self.across() + u * 0.5;
        let top = self.under() + u * 0.8;
        let step = ((bottom - top) / rows.len() as f32).min(u * 1.7);
        if step < u * 1.15 {
            return;
        }
        for (index, (_, role, says)) in rows.into_iter().enumerate().filter(|(_, (drawn, ..))| *drawn) {
            let at = Vec2::new(left, top + step * (index as f32 + 0.3));
            let ink = match role {
                Role::Tick => Ink::Circle { center: at, radius: u * 0.5 },
                Role::Edge => Ink::Circle { center: at, radius: u * 0.2 },
                Role::Best => Ink::Circle { center: at, radius: u * 0.34 },
                Role::Hidden => line(at - Vec2::new(0.0, u * 0.4), at + Vec2::new(0.0, u * 0.4)),
                _ => block(at - Vec2::new(u * 0.7, u * 0.5), Vec2::new(u * 1.4, u), 0.0),
            };
            self.figure.add(role, None, ink);
            let at = at + Vec2::new(u * 1.4, 0.0);
            write(self.figure, Role::Quiet, None, at, &says, small, Face::Regular, Anchor::Start);
        }
    }
}
