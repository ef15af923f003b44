//! Where the step before stood, faintly below everything else.

use raystep_accel::Place;

use crate::moments::{Build, GrowMoment, Moment, Walk};
use crate::theme::Role;
use crate::world::{Form, Space, SpaceMark};

/// Puts the outline of the place where an earlier moment of the walk stood below the marks of space.
pub fn ghost(walk: &Walk<'_>, before: &Moment, now: &Moment, space: &mut Space) {
    let left = before.here.filter(|here| now.here != Some(*here) && now.inside.is_none() && before.inside.is_none());
    let forms = match left {
        Some(Place::Node(node)) => {
            walk.nodes.look(walk.structure, node, walk.bounds(Place::Node(node)), walk.flat).into_iter().collect()
        }
        Some(place @ Place::Cell(_)) => boxed(walk.bounds(place)),
        _ => Vec::new(),
    };
    below(space, left, forms);
}

/// The same for a build: the node that it has left.
pub fn ghost_of_build(build: &Build<'_>, before: &GrowMoment, now: &GrowMoment, space: &mut Space) {
    let left = before.node.filter(|node| now.node != Some(*node));
    let bounds = left.and_then(|node| before.nodes.get(&node)).map(|node| node.bounds);
    let cell = match (before.event.map(|event| event.place()), now.event.map(|event| event.place())) {
        (Some(cell @ Place::Cell(id)), now) if now != Some(cell) => build
            .structure
            .grid()
            .filter(|grid| id.index() < grid.cell_count())
            .map(|grid| (cell, grid.cell_bounds(id))),
        _ => None,
    };
    match (left.zip(bounds), cell) {
        (Some((node, bounds)), _) => below(space, Some(Place::Node(node)), boxed(bounds)),
        (None, Some((cell, bounds))) => below(space, Some(cell), boxed(bounds)),
        _ => {}
    }
}

fn boxed(bounds: raystep_accel::Aabb) -> Vec<Form> {
    if bounds.is_empty() { Vec::new() } else { vec![Form::Box(bounds)] }
}

fn below(space: &mut Space, place: Option<Place>, forms: Vec<Form>) {
    let marks = forms.into_iter().map(|form| SpaceMark { form, role: Role::Ghost, place });
    space.marks.splice(0..0, marks);
}
