//! Each ray as a ruler of t over one axis: where it has been, where it is, where it waits, and its hit.

use glam::Vec2;
use raystep_accel::{Interval, Lanes, NodeId, Place};

use super::lanes::{cell, numbered, sample, say};
use crate::moments::{PacketMoment, PacketWalk};
use crate::page::{Anchor, Figure, Ink, Look, Ticks, line, write};
use crate::theme::{Face, Role, text_width};
use crate::words::number;

/// How high a row is, in text sizes.
const ROW: f32 = 1.7;
/// More rays than this stand closer.
const FEW: usize = 8;

/// How high the rulers of so many rays are.
pub(crate) fn rulers_height(rays: usize, look: &Look) -> f32 {
    let rows = rays.min(FEW) as f32 + rays.saturating_sub(FEW) as f32 * 0.5;
    look.heading(&mut Figure::default(), "", "") + look.text * (ROW * rows + 3.8)
}

/// A row for each ray over one axis.
pub(crate) fn rulers(walk: &PacketWalk<'_>, moment: &PacketMoment, hide: bool, size: Vec2, look: &Look) -> Figure {
    let mut figure = Figure::new(size);
    let u = look.text;
    let top = look.heading(&mut figure, "t along each ray", "") + u * 1.3;
    let bottom = size.y - look.margin() - u * 1.1;
    let row = ((bottom - top - u * 0.2) / walk.rays.len().max(1) as f32).clamp(u * 0.3, u * ROW);
    let letters = (u * 0.9).min(row * 0.62);
    let left = look.margin() + cell(letters) * 1.3 + u * 2.4 + u;
    let (low, high) = extent(walk);
    let axis = Ticks { low, high, left, right: (size.x - look.margin() - u).max(left + 1.0) };
    for lane in 0..walk.rays.len() {
        let y = top + row * (lane as f32 + 0.5);
        let takes_part = moment.here.is_none_or(|(_, lanes)| lanes.has(lane));
        let role = if takes_part { Role::Lane } else { Role::Dropped };
        let at = Vec2::new(look.margin() + cell(letters) * 0.6, y);
        numbered(&mut figure, role, None, lane, at, letters);
        sample(&mut figure, Role::thread(lane), Vec2::new(look.margin() + cell(letters) * 1.3, y), u * 2.4);
        of_lane(&mut figure, &axis, walk, moment, lane, y, letters);
        why_not(&mut figure, &axis, moment, lane, hide, [y, row], letters);
        if let Some(hit) = moment.best.get(lane).copied().flatten().filter(|hit| axis.shows(hit.t)) {
            let (center, place) = (Vec2::new(axis.x(hit.t), y), Some(Place::Prim(hit.prim)));
            figure.add(Role::Best, place, Ink::Circle { center, radius: letters * 0.38 });
            figure.add(Role::Page, place, Ink::Circle { center, radius: letters * 0.2 });
            let at = center - Vec2::new(letters * 0.7, row * 0.3);
            write(&mut figure, Role::Best, place, at, &number(hit.t), letters, Face::Bold, Anchor::End);
        }
    }
    // The name of where the packet is, over its first bar.
    if let Some((node, lanes)) = moment.here {
        let first = lanes.iter().find_map(|lane| moment.part(node, lane));
        if let Some(part) = first {
            let x = (axis.x(part.near) + axis.x(part.far)) * 0.5;
            let name = format!("{node} here");
            let half = text_width(&name, Face::Bold, u * 0.9) * 0.5;
            let at = Vec2::new(x.clamp(axis.left + half, axis.right - half), top - u * 0.95);
            write(&mut figure, Role::Here, Some(Place::Node(node)), at, &name, u * 0.9, Face::Bold, Anchor::Middle);
        }
    }
    figure.add(Role::Edge, None, line(Vec2::new(axis.left, bottom), Vec2::new(axis.right, bottom)));
    for mark in axis.marks(u * 5.0) {
        let x = axis.x(mark);
        figure.add(Role::Edge, None, line(Vec2::new(x, bottom - u * 0.25), Vec2::new(x, bottom + u * 0.25)));
        say(&mut figure, Role::Quiet, Vec2::new(x, bottom + u * 1.0), &number(mark), look.small(), Anchor::Middle);
    }
    figure
}

/// The part of t that shows every ray as far as it lies in the structure.
fn extent(walk: &PacketWalk<'_>) -> (f32, f32) {
    let world = walk.bounds(Place::World);
    let parts = walk.rays.iter().map(|ray| raystep_accel::slab(&world, ray, ray.range(), Place::World, &mut ()));
    let far = parts.filter(|part| !part.is_empty() && part.far.is_finite()).fold(0.0, |far, part| part.far.max(far));
    let low = walk.rays.iter().map(|ray| ray.t_min).fold(f32::INFINITY, f32::min).min(far);
    (low, if far > low { far + (far - low) * 0.04 } else { low + 1.0 })
}

/// The leaves that a ray has been in, the nodes where it waits, and where it is.
fn of_lane(
    figure: &mut Figure,
    axis: &Ticks,
    walk: &PacketWalk<'_>,
    moment: &PacketMoment,
    lane: usize,
    y: f32,
    u: f32,
) {
    let here = moment.here.map(|(node, _)| node);
    let leaf = |node: NodeId| walk.structure.children(node).is_empty();
    let takes = |(node, lanes): (NodeId, Lanes)| lanes.has(lane).then_some(node);
    let seen = moment.entered.iter().copied().filter_map(takes).filter(|node| leaf(*node) && Some(*node) != here);
    let waits = moment.stack.iter().copied().filter_map(takes);
    let rows = seen
        .map(|node| (node, Role::Seen))
        .chain(waits.map(|node| (node, Role::Waiting)))
        .chain(moment.here.and_then(takes).map(|node| (node, Role::Here)));
    for (node, role) in rows {
        if let Some(part) = moment.part(node, lane) {
            bar(figure, axis, role, node, part, y, u);
        }
    }
}

/// Why a ray takes no part in what has just been taken from the stack: it has a nearer hit. It stands between its row, at
/// a height and so high, and the one above.
fn why_not(
    figure: &mut Figure,
    axis: &Ticks,
    moment: &PacketMoment,
    lane: usize,
    hide: bool,
    [y, row]: [f32; 2],
    u: f32,
) {
    let Some((node, waited, opened)) = moment.taken.filter(|_| !hide) else { return };
    // What is dropped is told with the lanes for which it is opened: none.
    let stays = moment.here.is_none_or(|_| !opened.has(lane));
    let Some(part) = moment.part(node, lane).filter(|_| waited.has(lane) && stays) else { return };
    bar(figure, axis, Role::Dropped, node, part, y, u);
    let says = format!("begins at {}, behind its hit", number(part.near));
    let width = text_width(&says, Face::Regular, u * 0.85);
    let at = Vec2::new(axis.x(part.near).min(axis.right - width), y - row * 0.5);
    say(figure, Role::Quiet, at, &says, u * 0.85, Anchor::Start);
}

fn bar(figure: &mut Figure, axis: &Ticks, role: Role, node: NodeId, part: Interval, y: f32, u: f32) {
    if part.is_empty() {
        return;
    }
    let place = Some(Place::Node(node));
    let (from, to) = (Vec2::new(axis.x(part.near), y), Vec2::new(axis.x(part.far), y));
    figure.add(role, place, line(from, to));
    let cap = match role {
        Role::Here => Role::Seen,
        Role::Waiting | Role::Dropped => Role::Quiet,
        other => other,
    };
    let tall = Vec2::new(0.0, u * 0.4);
    figure.add(cap, place, line(from - tall, from + tall));
    figure.add(cap, place, line(to - tall, to + tall));
}
