//! How full the lanes were: a column for each node that the packet entered, a row for each ray. The columns are the
//! packet's work, the filled cells what its rays would have to do one by one.

use glam::Vec2;
use raystep_accel::Place;

use super::lanes::{cell, numbered, sample, say};
use crate::moments::{PacketMoment, PacketWalk};
use crate::page::{Anchor, Figure, Look, block, line, write};
use crate::theme::{Face, Role, text_width};
use crate::words::{counted, number};

/// How high a row is where there is room, in text sizes.
const ROW: f32 = 1.5;

/// How high the matrix of so many rays is, with its bars.
pub(crate) fn matrix_height(rays: usize, look: &Look) -> f32 {
    let rows = if rays > 8 { rays as f32 * 0.75 } else { rays as f32 * ROW };
    look.heading(&mut Figure::default(), "", "") + look.text * (rows + BARS + 0.6)
}

/// How high the bars below are, in text sizes.
const BARS: f32 = 7.6;

/// The matrix, how full it is, and the nodes that the packet entered beside those of its rays one by one. `hide` leaves
/// out what a question asks for.
pub(crate) fn matrix(walk: &PacketWalk<'_>, moment: &PacketMoment, hide: bool, size: Vec2, look: &Look) -> Figure {
    let mut figure = Figure::new(size);
    let u = look.text;
    let (title, remark) = ("How full the lanes were", "a column a node, a row a ray");
    let wide = text_width(title, Face::Bold, u * 0.95) + text_width(remark, Face::Regular, look.small()) + u * 2.5;
    let top = look.heading(&mut figure, title, if wide < size.x { remark } else { "" });
    let rays = walk.rays.len();
    let room = size.y - top - u * (BARS + 1.2);
    let row = (room / rays.max(1) as f32).clamp(u * 0.55, u * ROW);
    let letters = (u * 0.85).min(row * 0.62);
    let left = look.margin() + cell(letters) * 1.3 + if rays > 8 { u * 0.4 } else { u * 2.2 };
    let right = size.x - look.margin() - u * 2.6;
    // Of many columns the last ones, as small as can be told apart.
    let wide = ((right - left) / moment.entered.len().max(1) as f32).clamp(u * 0.55, u * 1.25).min(row);
    let fit = ((right - left) / wide).max(1.0) as usize;
    let first = moment.entered.len().saturating_sub(fit);
    for lane in 0..rays {
        let y = top + row * (lane as f32 + 0.5);
        let takes_part = moment.here.is_none_or(|(_, lanes)| lanes.has(lane));
        let role = if takes_part { Role::Lane } else { Role::Dropped };
        numbered(&mut figure, role, None, lane, Vec2::new(look.margin() + cell(letters) * 0.6, y), letters);
        if rays <= 8 {
            sample(&mut figure, Role::thread(lane), Vec2::new(look.margin() + cell(letters) * 1.3, y), u * 1.7);
        }
        for (index, &(node, lanes)) in moment.entered[first..].iter().enumerate() {
            let side = wide.min(row) * 0.86;
            let corner = Vec2::new(left + wide * index as f32, y - side * 0.5);
            let role = if lanes.has(lane) { Role::Lane } else { Role::Edge };
            figure.add(role, Some(Place::Node(node)), block(corner, Vec2::splat(side), side * 0.18));
        }
        let so_far = moment.entered.iter().filter(|(_, lanes)| lanes.has(lane)).count();
        let at = Vec2::new(size.x - look.margin(), y);
        write(&mut figure, Role::Text, None, at, &so_far.to_string(), letters.max(u * 0.8), Face::Medium, Anchor::End);
    }
    let mut y = top + row * rays as f32 + u * 0.6;
    // Under each column its node, where they can be read.
    if wide >= u * 0.95 {
        for (index, &(node, _)) in moment.entered[first..].iter().enumerate() {
            let now = moment.here.is_some_and(|(here, _)| here == node) && first + index + 1 == moment.entered.len();
            let at = Vec2::new(left + wide * (index as f32 + 0.43), y);
            let role = if now { Role::Here } else { Role::Quiet };
            let text = node.to_string();
            let fits = (wide * 0.95 / text_width(&text, Face::Medium, 1.0)).min(u * 0.82);
            write(&mut figure, role, Some(Place::Node(node)), at, &text, fits, Face::Medium, Anchor::Middle);
        }
    } else if first > 0 {
        say(&mut figure, Role::Quiet, Vec2::new(left, y), &format!("the last {fit}"), u * 0.82, Anchor::Start);
    }
    y += u * 1.3;
    full(&mut figure, moment, y, size, look);
    y += u * 1.7;
    bars(&mut figure, walk, moment, hide, y, size, look);
    figure
}

/// The share of the cells that are filled.
fn full(figure: &mut Figure, moment: &PacketMoment, y: f32, size: Vec2, look: &Look) {
    let u = look.text;
    let Some(share) = moment.fill.share() else { return };
    let (left, width) = (look.margin() + u * 6.2, size.x - 2.0 * look.margin() - u * 17.5);
    say(figure, Role::Text, Vec2::new(look.margin(), y), "lanes full", u, Anchor::Start);
    let corner = Vec2::new(left, y - u * 0.38);
    figure.add(Role::Panel, None, block(corner, Vec2::new(width, u * 0.76), u * 0.2));
    figure.add(Role::Lane, None, block(corner, Vec2::new(width * share, u * 0.76), u * 0.2));
    let at = Vec2::new(left + width + u * 0.6, y);
    let percent = format!("{} %", number(share * 100.0));
    write(figure, Role::Value, None, at, &percent, u, Face::Bold, Anchor::Start);
    let says = format!("{} of {}", moment.fill.lane_visits, moment.fill.lanes);
    let at = Vec2::new(size.x - look.margin(), y);
    say(figure, Role::Quiet, at, &says, look.small(), Anchor::End);
}

/// Nodes entered: by the packet, by its rays within it, and by the same rays one by one in the end; then tests.
fn bars(
    figure: &mut Figure,
    walk: &PacketWalk<'_>,
    moment: &PacketMoment,
    hide: bool,
    y: f32,
    size: Vec2,
    look: &Look,
) {
    let u = look.text;
    let all: u64 = walk.alone.iter().map(|cost| cost.node_visits).sum();
    let longest = all.max(moment.fill.lane_visits).max(1) as f32;
    let (left, width) = (look.margin() + u * 6.2, size.x - 2.0 * look.margin() - u * 12.4);
    let length = |nodes: u64| (width * nodes as f32 / longest).max(1.0);
    let mut row = |index: usize, name: &str, role: Role, nodes: u64, parts: &[u64]| {
        let y = y + u * 1.6 * index as f32;
        say(figure, Role::Text, Vec2::new(look.margin(), y), name, u, Anchor::Start);
        let corner = Vec2::new(left, y - u * 0.42);
        if nodes > 0 {
            figure.add(role, None, block(corner, Vec2::new(length(nodes), u * 0.84), u * 0.15));
        }
        let mut x = left;
        for (lane, part) in parts.iter().enumerate() {
            let (from, to) = (x, x + length(*part));
            if lane > 0 {
                figure.add(role, None, line(Vec2::new(from, y - u * 0.42), Vec2::new(from, y + u * 0.42)));
            }
            let says = (lane + 1).to_string();
            if to - from > u * 1.2 {
                say(figure, role, Vec2::new((from + to) * 0.5, y), &says, u * 0.8, Anchor::Middle);
            }
            x = to;
        }
        let at = Vec2::new(size.x - look.margin(), y);
        let says = counted(nodes, "node", "nodes");
        write(figure, Role::Text, None, at, &says, u, Face::Bold, Anchor::End);
    };
    row(0, "packet", Role::Plane, moment.fill.visits, &[]);
    if hide {
        return;
    }
    let parts: Vec<u64> = walk.alone.iter().map(|cost| cost.node_visits).collect();
    // What it comes to one by one is known in the end.
    let alone = if moment.over {
        row(1, "one by one", Role::Value, all, &parts);
        format!("; one by one {}", walk.alone.iter().map(|cost| cost.prim_tests).sum::<u64>())
    } else {
        " so far".to_owned()
    };
    let skipped = if moment.skips > 0 { format!(" · {} skipped", moment.skips) } else { String::new() };
    let tests = moment.tested.len() as u64;
    let says = format!("{} of primitives{alone}{skipped}", counted(tests, "test", "tests"));
    let at = Vec2::new(look.margin(), y + u * 3.2);
    say(figure, Role::Quiet, at, &says, look.small(), Anchor::Start);
}
