//! Several rays in space: who takes part in the current node, and where each has its hit.

use glam::Vec3;
use raystep_accel::{Aabb, Interval, Place, Ray};

use super::together::{is_best, together};
use crate::moments::{Cut, PacketMoment, PacketWalk};
use crate::panes::space_to;
use crate::theme::Role;
use crate::words::{mask, number};
use crate::world::{Depth, Form, Space, SpaceMark};

/// Of more rays than this the hits have no numbers.
const FEW: usize = 4;

/// What space shows of a packet at a moment.
pub(crate) fn space_of_packet(walk: &PacketWalk<'_>, moment: &PacketMoment, depth: Depth) -> Space {
    let (Some(one), Some(mut shared)) = (walk.one(0), together(walk, moment)) else { return Space::default() };
    if let Some((node, axis, plane)) = moment.plane {
        shared.cut = Some(Cut { node, axis, plane, t: f32::NAN, children: None });
    }
    let mut space = space_to(&one, &shared, depth);
    // The rays are drawn by their numbers below.
    space.marks.retain(|mark| !matches!(mark.role, Role::Ray | Role::Line | Role::Live | Role::Tick));
    for ray in walk.rays {
        if space.bounds.center().distance(ray.o) <= 2.0 * space.bounds.extent().length() {
            space.bounds = space.bounds.with_point(ray.o);
        }
    }
    for mark in &mut space.marks {
        if let (Form::Prim(prim), Role::Hit) = (&mark.form, mark.role)
            && is_best(moment, *prim)
        {
            mark.role = Role::Best;
        }
        let Some(Place::Node(node)) = mark.place else { continue };
        if let (Form::Label { text, .. }, Some(lanes), true) =
            (&mut mark.form, moment.lanes_of(node), matches!(mark.role, Role::Here | Role::Waiting))
        {
            *text = format!("{text} {}", mask(lanes));
        }
    }
    // Numbers stand on top of the rays, so the rays come first.
    let texts = |mark: &SpaceMark| matches!(mark.form, Form::Label { .. } | Form::Number { .. });
    let at = space.marks.iter().position(texts).unwrap_or(space.marks.len());
    let labels = space.marks.split_off(at);
    plane(walk, moment, &mut space);
    for (lane, ray) in walk.rays.iter().enumerate() {
        thread(moment, lane, ray, &mut space);
    }
    space.marks.extend(labels);
    for (lane, ray) in walk.rays.iter().enumerate() {
        ends(walk, moment, lane, ray, &mut space);
    }
    space
}

fn add(space: &mut Space, role: Role, place: Option<Place>, form: Form) {
    space.marks.push(SpaceMark { form, role, place });
}

/// The name of the plane that splits the current node.
fn plane(walk: &PacketWalk<'_>, moment: &PacketMoment, space: &mut Space) {
    let Some((node, axis, at)) = moment.plane.filter(|_| walk.flat) else { return };
    let Some(along) = axis.axis() else { return };
    let mut sheet = walk.bounds(Place::Node(node));
    (sheet.min[along], sheet.max[along]) = (at, at);
    let text = format!("{axis} = {}", number(at));
    add(space, Role::Plane, Some(Place::Node(node)), Form::Label { at: sheet.center(), within: Some(sheet), text });
}

/// The part of a ray in the picture.
fn shown(ray: &Ray, bounds: &Aabb) -> Interval {
    let within = Interval::new(0.0, ray.t_max);
    raystep_accel::slab(bounds, ray, within, Place::World, &mut ())
}

/// A ray in its own dashes, thick where it takes part; what lies behind its hit is not needed any more.
fn thread(moment: &PacketMoment, lane: usize, ray: &Ray, space: &mut Space) {
    let part = shown(ray, &space.bounds);
    if part.is_empty() {
        return;
    }
    let hit = moment.best.get(lane).copied().flatten();
    let end = hit.map_or(part.far, |hit| hit.t.min(part.far));
    add(space, Role::thread(lane), None, Form::Segment(ray.at(part.near), ray.at(end)));
    if end < part.far {
        add(space, Role::Dropped, None, Form::Segment(ray.at(end), ray.at(part.far)));
    }
    if let Some((node, lanes)) = moment.here
        && lanes.has(lane)
        && let Some(live) = moment.part(node, lane)
    {
        let (near, far) = (live.near.max(part.near), live.far.min(part.far));
        if near < far {
            add(space, Role::strand(lane), Some(Place::Node(node)), Form::Segment(ray.at(near), ray.at(far)));
        }
    }
    if let Some(hit) = hit {
        add(space, Role::Best, Some(Place::Prim(hit.prim)), Form::Point(ray.at(hit.t)));
    }
}

/// A ray's number at its end, and where it has its hit.
fn ends(walk: &PacketWalk<'_>, moment: &PacketMoment, lane: usize, ray: &Ray, space: &mut Space) {
    let part = shown(ray, &space.bounds);
    if part.is_empty() {
        return;
    }
    if lane == 0 || walk.rays[0].o != ray.o {
        add(space, Role::Live, None, Form::Point(ray.o));
    }
    let takes_part = moment.here.is_none_or(|(_, lanes)| lanes.has(lane));
    let role = if takes_part { Role::Lane } else { Role::Dropped };
    let at: Vec3 = ray.at(part.far);
    add(space, role, None, Form::Label { at, within: None, text: (lane + 1).to_string() });
    // In space, where there is less room, the rulers say it.
    let few = walk.flat && walk.rays.len() <= FEW;
    if let Some(hit) = moment.best.get(lane).copied().flatten().filter(|_| few) {
        let text = format!("t = {}", number(hit.t));
        let at = ray.at(hit.t);
        add(space, Role::Best, Some(Place::Prim(hit.prim)), Form::Label { at, within: None, text });
    }
}
