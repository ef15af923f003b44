//! What a builder has done so far in numbers.

use glam::Vec2;
use raystep_accel::{Change, Primitives, Structure};

use super::loud::{loud, rest};
use crate::moments::{Build, GrowMoment};
use crate::page::{Anchor, Figure, Look, block, line, write};
use crate::theme::{Face, Role, text_width};
use crate::words::{VolumeName, counted};

/// The references stored so far as the one loud number, beside the primitives there are; the rest in words.
pub fn work_of_build(build: &Build<'_>, moment: &GrowMoment, size: Vec2, look: &Look) -> Figure {
    let mut figure = Figure::new(size);
    let top = look.heading(&mut figure, "Work so far", "");
    let (left, u) = (look.margin(), look.text);
    if build.change(moment).is_some() {
        changes(&mut figure, build, moment, top, look);
        return figure;
    }
    // What is inserted once the tree stands is not there yet.
    let all = build.prims.len() as u64 - build.only_inserted();
    let tally = &moment.tally;

    // Before anything is stored: how many primitives the box holds.
    let boxing = moment.resolution.is_none() && moment.nodes.is_empty();
    let (count, says) = if boxing {
        (tally.boxed, format!("of {} in the box", counted(all, "primitive", "primitives")))
    } else {
        (
            tally.stored,
            format!(
                "{} to {}",
                if tally.stored == 1 { "reference" } else { "references" },
                counted(all, "primitive", "primitives")
            ),
        )
    };
    let mut y = loud(&mut figure, count, &says, top, look) + u * 0.6;

    // Primitives as the upper bar, what refers to them as the lower.
    let width = size.x - 2.0 * left;
    let longest = count.max(all).max(1);
    let part = |count: u64| width * count as f32 / longest as f32;
    figure.add(Role::Panel, None, block(Vec2::new(left, y), Vec2::new(width, u * 0.75), u * 0.2));
    if count > 0 {
        figure.add(Role::Missed, None, block(Vec2::new(left, y), Vec2::new(part(count).max(3.0), u * 0.75), u * 0.2));
    }
    y += u * 1.55;
    if count > all {
        let at = Vec2::new(left + part(all), y - u * 1.75);
        figure.add(Role::Text, None, line(at, at + Vec2::new(0.0, u * 1.15)));
        // What the mark in the bar says, under it.
        let says = counted(all, "primitive", "primitives");
        let half = text_width(&says, Face::Regular, look.small()) / 2.0;
        let under = Vec2::new(at.x.clamp(left + half, (left + width - half).max(left + half)), y);
        write(&mut figure, Role::Quiet, None, under, &says, look.small(), Face::Regular, Anchor::Middle);
        y += u * 0.9;
    }

    rest(&mut figure, &words(build, moment), y, look);
    figure
}

/// The changes so far, each with the nodes that it touched and those that would be made if another tree were built anew.
fn changes(figure: &mut Figure, build: &Build<'_>, moment: &GrowMoment, top: f32, look: &Look) {
    let begun = build.begun(moment);
    let left = look.margin();
    let width = figure.size.x - 2.0 * left;
    // Each has a line and two bars; in a low pane the letters shrink with it.
    let u = look.text.min((figure.size.y - top) / (6.6 * begun.len().max(1) as f32)).min(width / 19.0);
    let rows: Vec<_> = begun.iter().map(|change| (change, build.touched(moment, change).len() as u64)).collect();
    let longest = rows
        .iter()
        .flat_map(|(change, touched)| [*touched, change.anew.as_ref().map_or(0, |(_, made)| *made)])
        .fold(1, u64::max);
    let mut y = top;
    let mut bar = |y: f32, role: Role, count: u64, says: &str| {
        write(figure, Role::Text, None, Vec2::new(left, y + u * 0.6), says, u, Face::Regular, Anchor::Start);
        let long = (width * count as f32 / longest as f32).max(3.0);
        figure.add(role, None, block(Vec2::new(left, y + u * 1.35), Vec2::new(long, u * 0.7), 0.0));
    };
    for (change, touched) in rows {
        let (verb, prim) = match change.change {
            Change::Insert(prim) => ("insert", prim),
            Change::Delete(prim) => ("delete", prim),
        };
        let says = if change.done {
            format!("{verb} {prim}: {}", counted(touched, "node looked at", "nodes looked at"))
        } else {
            format!("{verb} {prim}: it reaches out of the root's cell")
        };
        bar(y, Role::Plane, touched, &says);
        y += u * 2.9;
        if let Some((name, made)) = &change.anew {
            bar(y, Role::Missed, *made, &format!("{name} built anew: {}", counted(*made, "node made", "nodes made")));
            y += u * 2.9;
        }
        y += u * 0.8;
    }
}

/// What else was done. Only what happened.
fn words(build: &Build<'_>, moment: &GrowMoment) -> Vec<String> {
    let tally = &moment.tally;
    let (one, many) = match build.structure {
        Structure::Octree(_) => ("cell divided", "cells divided"),
        _ => ("taken", "taken"),
    };
    let rest = [
        (tally.taken, one, many),
        (tally.joined, "pair merged", "pairs merged"),
        (tally.leaves, "leaf", "leaves"),
        (moment.waiting.len() as u64, "node waits", "nodes wait"),
        (tally.pruned, "time its primitive does not reach it", "times its primitive does not reach it"),
    ];
    let rest = rest.into_iter().filter(|(count, ..)| *count > 0).map(|(count, one, many)| counted(count, one, many));
    weighed(build, moment).into_iter().chain(met(build, moment)).chain(rest).collect()
}

/// How many planes, or ways to share out, were weighed: `15 planes weighed`.
pub(crate) fn weighed(build: &Build<'_>, moment: &GrowMoment) -> Option<String> {
    let cut = VolumeName::of(build.structure).cut;
    let says = [format!("{cut} weighed"), format!("{cut}s weighed")];
    at_least(build, moment, "weigh", moment.tally.weighed, &says)
}

/// How many times a primitive's box met a cell: each pair is looked at once.
fn met(build: &Build<'_>, moment: &GrowMoment) -> Option<String> {
    let says = ["time a box meets a cell", "times a box meets a cell"].map(str::to_owned);
    at_least(build, moment, "rasterise", moment.tally.rasterised, &says)
}

/// A count of events of one name, of which only the first ones may be kept: so many `kept`, or more.
fn at_least(build: &Build<'_>, moment: &GrowMoment, name: &str, kept: u64, one_many: &[String; 2]) -> Option<String> {
    let [one, many] = one_many;
    let lost = build.lost.get(name).copied().unwrap_or(0);
    let ahead = build.events.get(moment.step..).unwrap_or_default();
    let (count, exact) = match ahead {
        [] => (kept + lost, true),
        // They are lost only after the last one that was kept.
        _ => (kept, lost == 0 || ahead.iter().any(|event| event.name() == name)),
    };
    let says = counted(count, one, many);
    (count > 0).then(|| if exact { says } else { format!("at least {says}") })
}
