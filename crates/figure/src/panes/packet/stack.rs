//! The stack of a packet: which nodes wait, and for whom.

use glam::Vec2;
use raystep_accel::{Lanes, NodeId, Place};

use super::lanes::{cell, strip, strip_width};
use crate::moments::{PacketMoment, PacketWalk};
use crate::page::{Anchor, Figure, Look, block, write};
use crate::theme::{Face, Role};
use crate::words::number;

/// One row.
struct Row {
    node: NodeId,
    role: Role,
    lanes: Lanes,
    word: String,
}

/// What was just taken from the stack, and below it what waits, the next one on top.
pub(crate) fn stack_of_packet(
    walk: &PacketWalk<'_>,
    moment: &PacketMoment,
    hide: bool,
    size: Vec2,
    look: &Look,
) -> Figure {
    let mut figure = Figure::new(size);
    let remark = if moment.stack.len() > 1 { "opened from the top" } else { "" };
    let top = look.heading(&mut figure, "Stack", remark);
    let u = look.text;
    let mut rows = Vec::new();
    if let Some((node, waited, _)) = moment.taken {
        let role = if moment.here.is_some() { Role::Here } else { Role::Dropped };
        rows.push(Row { node, role, lanes: waited, word: "just taken".to_owned() });
    }
    for (index, &(node, lanes)) in moment.stack.iter().rev().enumerate() {
        let word = match index {
            _ if moment.stack.len() == 1 => "waits",
            0 => "next",
            _ => "later",
        };
        rows.push(Row { node, role: Role::Waiting, lanes, word: word.to_owned() });
    }
    if rows.is_empty() {
        let at = Vec2::new(look.margin(), top + look.line() * 0.5);
        write(&mut figure, Role::Quiet, None, at, "Nothing waits.", u, Face::Regular, Anchor::Start);
        return figure;
    }
    let mut y = top;
    for (index, Row { node, role, lanes, word }) in rows.iter().enumerate() {
        // Those who do not need it any more say why, where there is room for it and for all rows.
        let left_out = if index == 0 && !hide { left_out(moment, *node) } else { Vec::new() };
        let reasons = 1.5 * left_out.len() as f32;
        let fits = top + u * (2.75 * rows.len() as f32 + reasons) <= size.y;
        let left_out = if fits { left_out } else { Vec::new() };
        let height = u * (2.3 + if fits { reasons } else { 0.0 });
        let more = rows.len() - index;
        if y + height > size.y && index > 0 {
            let says = format!("and {more} more below");
            let at = Vec2::new(look.margin(), (y + look.line() * 0.5).min(size.y - u * 0.6));
            write(&mut figure, Role::Quiet, None, at, &says, u, Face::Regular, Anchor::Start);
            break;
        }
        let (corner, wide) = (Vec2::new(look.margin(), y), size.x - 2.0 * look.margin());
        let place = Some(Place::Node(*node));
        figure.add(*role, place, block(corner, Vec2::new(wide, height), u * 0.4));
        let (middle, left) = (y + u * 1.15, corner.x + u * 0.9);
        write(
            &mut figure,
            *role,
            place,
            Vec2::new(left, middle),
            &format!("node {node}"),
            u,
            Face::Bold,
            Anchor::Start,
        );
        let right = corner.x + wide - u * 0.9;
        let letters = u * 0.85;
        let room = strip_width(*lanes, walk.rays.len(), letters);
        let at = Vec2::new((right - u * 6.0 - room).max(left + u * 4.2), middle);
        strip(&mut figure, place, *lanes, walk.rays.len(), at, letters);
        write(&mut figure, Role::Text, None, Vec2::new(right, middle), word, u, Face::Regular, Anchor::End);
        for (row, (lane, says)) in left_out.into_iter().enumerate() {
            let y = middle + u * 1.5 * (row as f32 + 1.0);
            let at = Vec2::new(left + cell(letters) * 0.5, y);
            super::lanes::numbered(&mut figure, Role::Dropped, None, lane, at, letters);
            let at = Vec2::new(left + cell(letters) + u * 0.4, y);
            write(&mut figure, Role::Hit, None, at, &says, u * 0.95, Face::Regular, Anchor::Start);
        }
        y += height + u * 0.45;
    }
    figure
}

/// Of what was just taken from the stack, the rays that have a nearer hit.
fn left_out(moment: &PacketMoment, node: NodeId) -> Vec<(usize, String)> {
    let Some((taken, waited, opened)) = moment.taken else { return Vec::new() };
    if taken != node {
        return Vec::new();
    }
    let opened = if moment.here.is_some() { opened } else { Lanes::none(waited.width()) };
    let says = |lane: usize| {
        let hit = moment.best.get(lane).copied().flatten()?;
        let part = moment.part(node, lane)?;
        Some((lane, format!("hit at {} < {}, where its part begins", number(hit.t), number(part.near))))
    };
    waited.iter().filter(|lane| !opened.has(*lane)).filter_map(says).collect()
}
