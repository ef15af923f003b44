//! The ways to divide the current node: what is weighed, taken, proposed or asked for, and what a cut leaves of a node.

use glam::Vec3;
use raystep_accel::{Aabb, Axis, Direction, FreePlane, Grow, Place, Structure};

use super::{Drawing, LEVELS};
use crate::panes::weighing::Sides;
use crate::theme::Role;
use crate::words::{VolumeName, coordinate, counted, number};
use crate::world::{Form, convex};

/// Most weighed splits in one picture.
const TICKS: usize = 120;

impl Drawing<'_> {
    /// The planes that an open question offers.
    pub(super) fn guesses(&mut self) {
        let Some((id, node)) = self.moment.node.and_then(|id| self.moment.nodes.get_key_value(&id)) else { return };
        for (axis, plane, text) in &self.moment.guesses {
            let Some(axis) = axis.axis() else { continue };
            let sheet = sheet(&node.bounds, axis, *plane);
            self.add(Role::Guess, Some(Place::Node(*id)), Form::Sheet(sheet));
            let form = Form::Label { at: sheet.center(), within: None, text: text.clone() };
            self.add(Role::Guess, Some(Place::Node(*id)), form);
        }
    }

    /// In space, the halves of split nodes whose turn has not come: what the plane leaves of them. In a hierarchy nobody knows
    /// yet.
    pub(super) fn halves(&mut self) {
        let Structure::Kd(_) = self.build.structure else { return };
        if self.build.flat {
            return;
        }
        let moment = self.moment;
        let path = moment.path();
        for node in path.iter().rev().take(LEVELS).filter_map(|id| moment.nodes.get(id)) {
            let Some((taken, axis)) = node.split.and_then(|taken| Some((taken, taken.axis.axis()?))) else { continue };
            let (mut below, mut above) = (node.bounds, node.bounds);
            below.max[axis] = taken.plane;
            above.min[axis] = taken.plane;
            for (id, half) in [(taken.below, below), (taken.above, above)] {
                if moment.waiting.contains(&id) && !moment.nodes.contains_key(&id) {
                    self.add(Role::Waiting, Some(Place::Node(id)), Form::Box(half).apart(&half, &moment.bounds));
                }
            }
        }
    }

    /// The splits weighed for the current node as ticks at its edges, the one at hand as a whole plane.
    pub(super) fn splits(&mut self) {
        let Some((id, node)) = self.moment.node.and_then(|id| self.moment.nodes.get_key_value(&id)) else { return };
        let place = Some(Place::Node(*id));
        let every = self.moment.weighed.len().div_ceil(TICKS).max(1);
        // Once the node is split, what else was weighed covers no primitives any more.
        for weighed in self.moment.weighed.iter().step_by(every).filter(|_| node.split.is_none()) {
            let Some(axis) = weighed.axis.axis() else { continue };
            for (from, to) in ticks(&node.bounds, axis, weighed.plane) {
                self.add(Role::Candidate, place, Form::Segment(from, to));
            }
        }
        let flat = self.build.flat;
        // What is cut is a list, and no line in space.
        let listed = matches!(self.build.structure, Structure::Bvh(_));
        let cell = if let Structure::Bsp(tree) = self.build.structure { Some(tree.cell(*id)) } else { None };
        let sheet = |across: Direction, plane: f32, free: Option<FreePlane>| match &cell {
            Some(cell) => convex::sheet(cell, free?, flat),
            None => Some(Form::Sheet(sheet(&node.bounds, across.axis()?, plane))),
        };
        let taken = node.split.filter(|_| !listed);
        if let Some(sheet) = taken.and_then(|taken| sheet(taken.axis, taken.plane, taken.free)) {
            self.add(Role::Plane, place, sheet);
        }
        match self.moment.event {
            // A proposed plane, its normal, and who proposed it.
            Some(Grow::Normal { plane, from, .. }) => {
                if let Place::Prim(prim) = from {
                    self.add(Role::Here, Some(from), Form::Prim(prim));
                }
                let free = self.moment.free.zip(cell.as_ref());
                let forms =
                    free.map(|(free, cell)| [convex::sheet(cell, free, flat), convex::normal(cell, free, flat)]);
                for form in forms.into_iter().flatten().flatten() {
                    self.add(Role::Candidate, place, form);
                }
                self.title(Role::Candidate, *id, node.bounds, format!("proposed: n · p = {}", number(plane)));
            }
            Some(Grow::Weigh { axis, plane, below, above, cost, .. }) => {
                // A hierarchy puts a box around each of two sets; in a drawing they stand in the picture of the weighing.
                let sets = axis.axis().filter(|_| listed && !flat);
                if let Some(axis) = sets {
                    let sides = Sides::of(self.build, *id, axis, plane, below);
                    for side in [sides.below_box, sides.above_box] {
                        self.add(Role::Candidate, place, Form::Box(side));
                    }
                } else if let Some(sheet) = sheet(axis, plane, self.moment.free) {
                    self.add(Role::Candidate, place, sheet);
                }
                // Where n points to is above.
                let normal =
                    self.moment.free.zip(cell.as_ref()).and_then(|(free, cell)| convex::normal(cell, free, flat));
                if let Some(Form::Arrow(from, tip)) = normal {
                    self.add(Role::Candidate, place, Form::Arrow(from, tip));
                    // Beyond its tip, so that all of it is seen.
                    let at = tip + (tip - from) * 0.3;
                    let form = Form::Label { at, within: None, text: "n, to above".to_owned() };
                    self.add(Role::Candidate, place, form);
                }
                self.title(
                    Role::Candidate,
                    *id,
                    node.bounds,
                    format!("{below} below, {above} above: cost {}", number(cost)),
                );
            }
            // The lines that cut a cell into equal ones.
            Some(Grow::Divide { at_x, at_y, at_z, .. }) => {
                for (axis, at) in [(Axis::X, at_x), (Axis::Y, at_y), (Axis::Z, at_z)] {
                    if !(flat && axis == Axis::Z) {
                        self.add(Role::Plane, place, Form::Sheet(self::sheet(&node.bounds, axis, at)));
                    }
                }
                self.title(
                    Role::Here,
                    *id,
                    node.bounds,
                    format!("node {id}: divided into {} cells", node.children.len()),
                );
            }
            Some(Grow::Split { axis, plane, .. }) => {
                let cut = if VolumeName::of(self.build.structure).cut == "way" { "shared out" } else { "cut" };
                let text = match listed {
                    true => format!("node {id}: {cut} along {axis}"),
                    false => format!("node {id}: {cut} at {} = {}", coordinate(axis), number(plane)),
                };
                self.title(Role::Here, *id, node.bounds, text);
            }
            _ => {
                let count = counted(u64::from(node.prims), "primitive", "primitives");
                self.title(Role::Here, *id, node.bounds, format!("node {id}: {count}"));
            }
        }
    }
}

/// The part of a plane across `axis` that lies in a box.
fn sheet(bounds: &Aabb, axis: Axis, plane: f32) -> Aabb {
    let mut sheet = *bounds;
    sheet.min[axis] = plane;
    sheet.max[axis] = plane;
    sheet
}

/// Short lines at the two sides of a box that a plane across `axis` would cut.
fn ticks(bounds: &Aabb, axis: Axis, plane: f32) -> [(Vec3, Vec3); 2] {
    let along = if axis == Axis::Y { Axis::X } else { Axis::Y };
    let length = 0.05 * bounds.extent()[along];
    let at = |value: f32| {
        let mut at = bounds.center();
        at[axis] = plane;
        at[along] = value;
        at
    };
    let (low, high) = (bounds.min[along], bounds.max[along]);
    [(at(low), at(low + length)), (at(high - length), at(high))]
}
