//! Sets in the order of their codes: the curve through them, the quarters that a code names, and the neighbours chosen.

use glam::Vec3;
use raystep_accel::{Aabb, Axis, Grow, Interval, NodeId, Place, Ray};

use super::Drawing;
use crate::moments::GrowNode;
use crate::theme::Role;
use crate::world::Form;

/// How large the numbers of the quarters are, on those levels of a code that have some: further down there is no room.
const NUMBERED: [f32; 2] = [1.5, 0.85];

/// Most sets on a curve that is drawn.
const CURVE: usize = 400;

impl Drawing<'_> {
    /// The line through the middles of the sets in the order of their codes, and which neighbour each has chosen.
    pub(super) fn curve(&mut self) {
        let (moment, flat) = (self.moment, self.build.flat);
        if moment.curve.is_empty() || moment.curve.len() > CURVE {
            if !moment.curve.is_empty() {
                self.notes.push(format!("a curve through {} sets, not drawn", moment.curve.len()));
            }
            return self.chosen();
        }
        let seen = |at: Vec3| if flat { at.with_z(0.0) } else { at };
        for pair in moment.curve.windows(2) {
            let place = Some(Place::Node(pair[1].0));
            self.add(Role::Line, place, Form::Segment(seen(pair[0].1), seen(pair[1].1)));
        }
        let middle = |node: NodeId| moment.curve.iter().find(|(own, _)| *own == node).map(|(_, at)| seen(*at));
        for (node, nearest) in &moment.preferred {
            if let (Some(from), Some(to)) = (middle(*node), middle(*nearest)) {
                // Up to its box: two that chose each other have two heads.
                let bounds = moment.nodes.get(nearest).map_or(Aabb::EMPTY, |node| node.bounds);
                let tip = entry(from, to, &bounds).unwrap_or_else(|| from.lerp(to, 0.8));
                self.add(Role::Candidate, Some(Place::Node(*node)), Form::Arrow(from, tip));
            }
        }
        for (node, at) in &moment.curve {
            self.add(Role::Tick, Some(Place::Node(*node)), Form::Point(seen(*at)));
        }
        if let Some(Grow::Rank { node, first, second, third, x, y, z, .. }) = moment.event {
            self.codes([first, second, third]);
            let text = format!("code {first}{second}{third}…");
            let form = Form::Label { at: seen(Vec3::new(x, y, z)), within: None, text };
            self.add(Role::Tick, Some(Place::Node(node)), form);
        }
    }

    /// Of a curve that is not drawn, the neighbour that a set has just chosen.
    fn chosen(&mut self) {
        let Some(Grow::Prefer { node, nearest }) = self.moment.event else { return };
        let bounds = |id| self.moment.nodes.get(&id).map(|node: &GrowNode| node.bounds);
        let (Some(from), Some(to)) = (bounds(node), bounds(nearest)) else { return };
        let tip = entry(from.center(), to.center(), &to).unwrap_or(to.center());
        self.add(Role::Candidate, Some(Place::Node(nearest)), Form::Box(to));
        self.add(Role::Candidate, Some(Place::Node(node)), Form::Arrow(from.center(), tip));
        self.title(Role::Candidate, nearest, to, format!("node {nearest}"));
    }

    /// The box around the middles of all sets, halved along every axis, and the part where a code leads, again and again.
    fn codes(&mut self, code: [u32; 3]) {
        let mut cell = Aabb::around(self.moment.nodes.values().map(|node| node.bounds.center()));
        for (level, digit) in code.into_iter().enumerate() {
            let middle = cell.center();
            let part = |digit: u32| {
                let mut part = cell;
                for axis in Axis::ALL {
                    let side = if digit >> axis.index() & 1 == 0 { &mut part.max } else { &mut part.min };
                    side[axis] = middle[axis];
                }
                part
            };
            if self.build.flat {
                for digit in 0..4 {
                    let quarter = part(digit);
                    self.add(Role::Edge, None, Form::Box(quarter));
                    if let Some(&scale) = NUMBERED.get(level) {
                        self.add(Role::Edge, None, Form::Number { within: quarter, text: digit.to_string(), scale });
                    }
                }
            } else {
                self.add(Role::Edge, None, Form::Box(cell));
            }
            cell = part(digit);
        }
        self.add(Role::Plane, None, Form::Box(cell));
    }
}

/// Where the way from one point to another enters a box, if it begins outside.
fn entry(from: Vec3, to: Vec3, bounds: &Aabb) -> Option<Vec3> {
    let way = Ray::new(from, to - from).ok()?;
    let inside = raystep_accel::slab(bounds, &way, Interval::new(0.0, 1.0), Place::World, &mut ());
    (inside.near > 0.0 && !inside.is_empty()).then(|| way.at(inside.near))
}
