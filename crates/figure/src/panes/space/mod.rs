//! What a walk shows in space: the ray, the boxes and cells it meets, and what became of them.

mod boxes;
mod build;
mod cells;
mod ghost;
mod instances;
mod layer;
mod numbers;
mod prims;
mod rays;
mod slabs;

use glam::Vec3;
use raystep_accel::{Aabb, Axis, Interval, NodeId, Place, Structure, Visit};

pub(crate) use build::depth_of_build;
pub use build::{space_of_build, space_of_build_to};
pub use ghost::{ghost, ghost_of_build};

use crate::moments::{Moment, Walk};
use crate::theme::Role;
use crate::world::{Depth, Form, Space, SpaceMark};

/// What space shows at a moment of a walk; of a tree in a solid scene, the end of the way down.
pub fn space(walk: &Walk<'_>, moment: &Moment) -> Space {
    space_to(walk, moment, Depth::Path)
}

/// The same, with as many boxes of a tree in a solid scene as asked for.
pub fn space_to(walk: &Walk<'_>, moment: &Moment, depth: Depth) -> Space {
    let bounds = visible(walk);
    let single = walk.flat && matches!(walk.structure, Structure::Slab(_));
    // What happens in an instance is drawn there; out in the world the walk rests.
    let outside = moment.inside.as_ref().map(|_| Moment { event: None, ..moment.clone() });
    let moment_outside = outside.as_ref().unwrap_or(moment);
    let (marks, notes) = (Vec::new(), Vec::new());
    let mut drawing = Drawing { walk, moment: moment_outside, bounds, depth, marks, notes, back: f32::INFINITY };
    match walk.structure.grid() {
        Some(grid) => drawing.cells(grid),
        None => drawing.nodes(),
    }
    drawing.the_box();
    drawing.prims();
    if let Some(inside) = &moment.inside {
        drawing.inside(inside, moment.event);
    }
    drawing.split();
    drawing.slabs();
    drawing.wall();
    drawing.ray();
    drawing.cuts();
    drawing.next_planes();
    drawing.hits();
    drawing.guesses();
    drawing.line();
    drawing.numbers();
    if single {
        drawing.add(Role::Edge, None, Form::Axes(bounds));
    }
    let bounds = if single { with_axes(bounds) } else { bounds };
    Space { marks: drawing.marks, bounds, flat: walk.flat, notes: drawing.notes }
}

/// A space being drawn.
struct Drawing<'a> {
    walk: &'a Walk<'a>,
    moment: &'a Moment,
    bounds: Aabb,
    depth: Depth,
    marks: Vec<SpaceMark>,
    /// The smallest t of a ring.
    back: f32,
    notes: Vec<String>,
}

impl Drawing<'_> {
    fn add(&mut self, role: Role, place: Option<Place>, form: Form) {
        self.marks.push(SpaceMark { form, role, place });
    }

    /// A label at a point.
    fn note(&mut self, role: Role, place: Option<Place>, at: Vec3, text: String) {
        self.add(role, place, Form::Label { at, within: None, text });
    }

    /// A label in a corner of a place's box.
    fn title(&mut self, role: Role, place: Place, text: String) {
        let bounds = self.walk.bounds(place);
        if !bounds.is_empty() {
            self.add(role, Some(place), Form::Label { at: bounds.center(), within: Some(bounds), text });
        }
    }

    /// What is said of the current place: a primitive that is skipped there may reach into many others.
    fn here(&self, name: &str) -> String {
        match self.moment.event {
            Some(Visit::Skip { prim }) => format!("{name}: {prim} skipped"),
            _ => format!("{name} here"),
        }
    }

    /// The outline of a place.
    fn outline(&mut self, role: Role, place: Place) {
        // Around everything in a hierarchy lies the volume of its root.
        let place = match (place, self.walk.structure) {
            (Place::World, Structure::Bvh(tree)) if tree.node_count() > 0 => Place::Node(NodeId::ROOT),
            _ => place,
        };
        let bounds = self.walk.bounds(place);
        if let Place::Node(node) = place {
            // In space, what waits would share its edges with where the walk is; volumes of a hierarchy have their own.
            let shares = !self.walk.flat && role == Role::Waiting && !matches!(self.walk.structure, Structure::Bvh(_));
            for form in self.walk.nodes.look(self.walk.structure, node, bounds, self.walk.flat) {
                let form = if shares { form.apart(&bounds, &self.walk.world()) } else { form };
                self.add(role, Some(place), form);
            }
        } else if !bounds.is_empty() {
            self.add(role, Some(place), Form::Box(bounds));
        }
    }

    /// A ring where the ray is at `t`, if that is in the picture.
    fn ring(&mut self, role: Role, place: Option<Place>, t: f32, text: Option<String>) {
        let at = self.walk.ray.at(t);
        if !at.is_finite() || !self.bounds.contains(at) {
            return;
        }
        self.back = self.back.min(t);
        self.add(role, place, Form::Point(at));
        if let Some(text) = text {
            self.note(role, place, at, text);
        }
    }
}

/// What the picture is about: the box around everything and, if it is not far off, the ray's origin.
fn visible(walk: &Walk<'_>) -> Aabb {
    let world = walk.world();
    if world.is_empty() {
        return world.with_point(walk.ray.o).with_point(walk.ray.at(1.0));
    }
    let diagonal = world.extent().length();
    let near = |p: &Vec3| (*p - world.center()).length() <= 2.0 * diagonal;
    let mut all = world.union(walk.nodes.reach());
    if near(&walk.ray.o) {
        all = all.with_point(walk.ray.o);
    }
    // A slab test is about where the ray meets the planes, also outside the box.
    if let (Structure::Slab(_), true) = (walk.structure, walk.flat) {
        let planes = [Axis::X, Axis::Y].into_iter().flat_map(|axis| [(axis, world.min[axis]), (axis, world.max[axis])]);
        let crossings = planes.map(|(axis, plane)| walk.ray.at((plane - walk.ray.o[axis]) / walk.ray.d[axis]));
        all = crossings.filter(|p| p.is_finite() && near(p)).fold(all, Aabb::with_point);
    }
    // In space they are drawn as far as they reach beyond the box.
    if let (Structure::Slab(_), false) = (walk.structure, walk.flat) {
        all = all.union(slabs::beyond(&world));
    }
    let air = if matches!(walk.structure, Structure::Slab(_)) { 0.08 } else { 0.025 };
    all.padded(air * diagonal)
}

/// The box with room for its axes to the left of it and below.
fn with_axes(bounds: Aabb) -> Aabb {
    let room = bounds.extent().truncate().max_element();
    Aabb { min: bounds.min - Vec3::new(0.1, 0.07, 0.0) * room, ..bounds }
}

/// The part of the line of the ray in the picture: also what lies behind its origin.
fn line(walk: &Walk<'_>, bounds: &Aabb) -> Interval {
    raystep_accel::slab(bounds, &walk.ray, Interval::ALL, Place::World, &mut ())
}

/// The part of the ray in the picture; empty if there is none.
fn shown(walk: &Walk<'_>, bounds: &Aabb) -> Interval {
    let within = Interval::new(0.0, walk.ray.t_max);
    let part = raystep_accel::slab(bounds, &walk.ray, within, Place::World, &mut ());
    if !part.is_empty() || !bounds.contains(walk.ray.o) { part } else { within }
}
