//! The volume so far around its set, and where in space the step happens.

use glam::{DVec2, Vec3};
use raystep_accel::{Aabb, CellId, Direction, Fit, NodeId, Outline, Place, outline};

use crate::moments::FitMoment;
use crate::theme::Role;
use crate::words::{number, whole};
use crate::world::{Form, Space, SpaceMark, forms_of_volume};

/// Around an oriented box there is so much more room, in parts of the set: it turns. In a drawing also around planes
/// that lean: out there they are not covered by the volume that they bound.
const TURNS: f32 = 0.16;

/// Space at a moment of the fitting that these events tell of.
pub(crate) fn space_of_fit(events: &[Fit], moment: &FitMoment, flat: bool) -> Space {
    let bounds = room(events, flat);
    let mut drawing = Drawing { moment, flat, bounds, marks: Vec::new() };
    if moment.step > 0 {
        drawing.volume();
        drawing.faces();
        drawing.planes();
        drawing.directions();
        drawing.points();
        drawing.size();
    }
    let margin = 0.05 * if bounds.is_empty() { 0.0 } else { bounds.extent().length() };
    Space { marks: drawing.marks, bounds: bounds.padded(margin), flat, notes: Vec::new() }
}

/// What every picture of the fitting shows: the set, and all spheres that it comes to.
fn room(events: &[Fit], flat: bool) -> Aabb {
    let around = |all: Aabb, event: &Fit| match *event {
        Fit::Begin { bounds, .. } | Fit::Widen { bounds, .. } => all.union(bounds),
        Fit::Ball { x, y, z, radius, .. } | Fit::Sphere { x, y, z, radius } => {
            all.union(Aabb::around([Vec3::new(x, y, z)]).padded(radius))
        }
        _ => all,
    };
    let all = events.iter().fold(Aabb::EMPTY, around);
    let turns = |event: &Fit| matches!(event, Fit::Frame { .. });
    let leans = |event: &Fit| flat && matches!(event, Fit::Push { axis: Direction::Slanted(_), .. });
    if events.iter().any(|event| turns(event) || leans(event)) {
        all.padded(TURNS * all.extent().max_element())
    } else {
        all
    }
}

/// How far what is drawn within a face keeps from its edges, in parts of the way to its middle.
const INWARDS: f32 = 0.1;

struct Drawing<'a> {
    moment: &'a FitMoment,
    flat: bool,
    bounds: Aabb,
    marks: Vec<SpaceMark>,
}

impl Drawing<'_> {
    fn add(&mut self, role: Role, place: Place, form: Form) {
        self.marks.push(SpaceMark { form, role, place: Some(place) });
    }

    /// In a drawing everything lies in its plane.
    fn seen(&self, at: Vec3) -> Vec3 {
        if self.flat { at.with_z(0.0) } else { at }
    }

    fn label(&mut self, role: Role, place: Place, at: Vec3, text: String) {
        let at = self.seen(at);
        self.add(role, place, Form::Label { at, within: None, text });
    }

    /// The box that the fitting begins with, the volume so far, and what is tried instead.
    fn volume(&mut self) {
        let moment = self.moment;
        let plain = matches!(moment.volume, Some(Outline::Box(_)));
        if !moment.bounds.is_empty() && !plain {
            self.add(Role::Edge, Place::World, Form::Box(moment.bounds));
        }
        let trying = moment.tried.is_some();
        if let Some(volume) = moment.volume.as_ref().filter(|_| moment.faces.is_empty() || moment.fresh.is_empty()) {
            let role = if trying { Role::Seen } else { Role::Here };
            for form in forms_of_volume(volume, self.flat) {
                self.add(role, Place::World, form);
            }
        }
        if let Some(tried) = &moment.tried {
            for form in forms_of_volume(tried, self.flat) {
                self.add(Role::Candidate, Place::World, form);
            }
        }
        if let Some(Fit::Widen { prim, .. }) = moment.event {
            self.add(Role::Best, Place::Prim(prim), Form::Prim(prim));
        }
    }

    /// The faces of a hull: those that stay, those that the newest corner removes, those that it makes.
    fn faces(&mut self) {
        let moment = self.moment;
        if matches!(moment.event, Some(Fit::Enough { .. } | Fit::Plane { .. })) {
            return;
        }
        if self.flat {
            return self.shadow();
        }
        let fresh = |face: &u32| moment.fresh.contains(face);
        for (face, corners) in moment.faces.iter().filter(|(face, _)| !fresh(face)) {
            let place = Place::Node(NodeId(*face));
            for [from, to] in moment.corners(*corners).iter().flat_map(|corners| around(corners)) {
                self.add(Role::Seen, place, Form::Segment(from, to));
            }
        }
        self.gone();
        for face in moment.fresh.iter().filter(|face| moment.faces.contains_key(face)) {
            let corners = moment.faces.get(face).and_then(|face| moment.corners(*face));
            if let Some(corners) = corners {
                self.add(Role::Here, Place::Node(NodeId(*face)), Form::Polygon(corners));
            }
        }
    }

    /// The faces that the newest corner removes, a little smaller: their edges are those of faces that stay.
    fn gone(&mut self) {
        let moment = self.moment;
        for corners in moment.gone.iter().filter_map(|face| moment.corners(*face)) {
            let middle = corners.iter().sum::<Vec3>() / corners.len() as f32;
            let inner = corners.iter().map(|corner| self.seen(corner.lerp(middle, INWARDS))).collect();
            self.add(Role::Dropped, Place::World, Form::Polygon(inner));
            if let Some(Fit::Hide { face }) = moment.event {
                self.label(Role::Dropped, Place::World, middle, format!("face {face} goes"));
            }
        }
    }

    /// A hull as it is seen in a drawing, straight from above: the outline of its corners so far. The newest one belongs
    /// to it from its first face on.
    fn shadow(&mut self) {
        let moment = self.moment;
        let corners: Vec<Vec3> = moment.deciding.iter().filter_map(|point| moment.points.get(point).copied()).collect();
        let hull = |corners: &[Vec3]| -> Vec<Vec3> {
            let flat: Vec<DVec2> = corners.iter().map(|corner| corner.truncate().as_dvec2()).collect();
            outline(&flat).into_iter().map(|index| corners[index].with_z(0.0)).collect()
        };
        let (all, before) = (hull(&corners), hull(&corners[..corners.len().saturating_sub(1)]));
        if moment.faces.is_empty() {
            return;
        }
        if moment.fresh.is_empty() && before.len() > 2 {
            // What of the outline is not one of the hull with the newest corner, goes.
            for [from, to] in around(&before) {
                let stays = around(&all).contains(&[from, to]) || moment.gone.is_empty();
                let role = if stays { Role::Here } else { Role::Dropped };
                self.add(role, Place::World, Form::Segment(from, to));
            }
            return self.gone();
        }
        if before.len() > 2 && before != all {
            self.add(Role::Seen, Place::World, Form::Polygon(before));
        }
        if all.len() > 2 {
            self.add(Role::Here, Place::World, Form::Polygon(all));
        }
    }

    /// The two planes that were just pushed out.
    fn planes(&mut self) {
        let Some(Fit::Push { x, y, z, low, high, .. }) = self.moment.event else { return };
        let (n, center) = (Vec3::new(x, y, z), self.moment.bounds.center());
        let way = n / n.length_squared();
        let reach = self.bounds.extent().length() * 0.5;
        for (at, name) in [(low, "low"), (high, "high")] {
            let foot = center + way * at;
            if self.flat {
                let along = Vec3::Z.cross(n).normalize_or_zero() * reach;
                let cut = clipped(self.seen(foot), along, &self.bounds);
                if let Some([from, to]) = cut {
                    self.add(Role::Plane, Place::World, Form::Segment(from, to));
                }
            } else {
                self.add(Role::Plane, Place::World, Form::Polygon(sheet(foot, n, reach * 0.55)));
            }
            self.label(Role::Plane, Place::World, foot, format!("{name} = {}", number(at)));
        }
        let outer = self.seen(center + way * high);
        let inner = self.seen(center + way * low);
        self.add(Role::Live, Place::World, Form::Segment(inner, outer));
    }

    /// The directions of an oriented box.
    fn directions(&mut self) {
        let moment = self.moment;
        let shown = matches!(moment.event, Some(Fit::Frame { .. } | Fit::Choose { .. } | Fit::Align { .. }));
        let (Some(axes), Some(middle), true) = (moment.axes, moment.middle, shown) else { return };
        let long = moment.bounds.extent().max_element() * 0.3;
        let middle = self.seen(middle);
        let names = ["u", "v", "w"];
        for (axis, name) in axes.into_iter().zip(names).take(if self.flat { 2 } else { 3 }) {
            let tip = middle + axis * long;
            self.add(Role::Live, Place::World, Form::Arrow(middle, tip));
            self.label(Role::Live, Place::World, tip, name.to_owned());
        }
    }

    /// The points that decide, and the one of this step.
    fn points(&mut self) {
        let moment = self.moment;
        for point in &moment.deciding {
            if let Some(at) = moment.points.get(point) {
                let at = self.seen(*at);
                self.add(Role::Best, Place::Cell(CellId(*point)), Form::Point(at));
            }
        }
        if let Some(Fit::Mean { x, y, z, .. }) = moment.event {
            let at = self.seen(Vec3::new(x, y, z));
            self.add(Role::Tick, Place::World, Form::Point(at));
            self.label(Role::Tick, Place::World, at, "mean".to_owned());
        }
        let (point, far) = match moment.event {
            Some(Fit::Far { point, far, .. }) => (point, far),
            Some(Fit::Seed { point, far, .. } | Fit::Apex { point, far, .. }) => (point, far),
            _ => return,
        };
        let Some(at) = moment.points.get(&point).copied() else { return };
        let (place, at) = (Place::Cell(CellId(point)), self.seen(at));
        if let (Some(Fit::Far { .. }), Some(middle)) = (moment.event, moment.middle.or(Some(moment.bounds.center()))) {
            let middle = self.seen(middle);
            self.add(Role::Plane, place, Form::Segment(middle, at));
            self.add(Role::Tick, Place::World, Form::Point(middle));
        }
        self.add(Role::Tick, place, Form::Point(at));
        self.label(Role::Tick, place, at, format!("point {}: {} away", whole(point.into()), number(far)));
    }

    /// How large a sphere is, where it stands.
    fn size(&mut self) {
        let Some(Fit::Try { radius, .. } | Fit::Ball { radius, .. } | Fit::Sphere { radius, .. }) = self.moment.event
        else {
            return;
        };
        let (Some(Outline::Sphere(sphere)), role) = (match &self.moment.tried {
            Some(tried) => (Some(tried), Role::Candidate),
            None => (self.moment.volume.as_ref(), Role::Here),
        }) else {
            return;
        };
        let center = self.seen(sphere.center);
        self.add(role, Place::World, Form::Point(center));
        self.label(role, Place::World, center, format!("radius = {}", number(radius)));
    }
}

/// The sides of a closed line.
fn around(corners: &[Vec3]) -> Vec<[Vec3; 2]> {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(from, to)| [*from, *to]).collect()
}

/// A square part of a plane.
fn sheet(foot: Vec3, normal: Vec3, reach: f32) -> Vec<Vec3> {
    let aside = normal.any_orthogonal_vector().normalize_or_zero() * reach;
    let across = normal.normalize_or_zero().cross(aside);
    [aside + across, aside - across, -aside - across, across - aside].map(|way| foot + way).to_vec()
}

/// The part of a line in a drawing that lies in a box.
fn clipped(middle: Vec3, along: Vec3, bounds: &Aabb) -> Option<[Vec3; 2]> {
    let (mut from, mut to) = (-1.0_f32, 1.0_f32);
    for axis in 0..2 {
        if along[axis] == 0.0 {
            continue;
        }
        let ends = [bounds.min, bounds.max].map(|side| (side[axis] - middle[axis]) / along[axis]);
        from = from.max(ends[0].min(ends[1]));
        to = to.min(ends[0].max(ends[1]));
    }
    (from < to).then(|| [middle + along * from, middle + along * to])
}
