//! How much the walk has done so far, against testing everything.

mod build;
mod loud;

use std::collections::BTreeSet;

use glam::Vec2;
use raystep_accel::{Cost, PrimId, Primitives, Prims, Structure};

pub(crate) use build::weighed;
pub use build::work_of_build;

use crate::moments::{Moment, Walk};
use crate::page::{Anchor, Figure, Look, block, write};
use crate::theme::{Face, Role};
use crate::words::{VolumeName, counted};
use loud::{loud, rest};

/// Where only the box is tested, its test is the work.
fn tests_box_only(structure: &Structure) -> bool {
    matches!(structure, Structure::Slab(_))
}

/// How many tests a walk has cost, and of how many things: "12 primitives", "1 box".
pub fn tested(structure: &Structure, prims: &Prims, cost: &Cost) -> (u64, String) {
    let (tests, all, one, many) = of_all(structure, prims, cost);
    (tests, counted(all, one, many))
}

/// How many tests a walk has cost, and what that is a part of: "of 12 primitives tested". Without a mailbox some are
/// tested twice: "tests, of 3 of 12 primitives".
pub(crate) fn tests_of(walk: &Walk<'_>, moment: &Moment) -> (u64, String) {
    let (tests, all, one, many) = of_all(walk.structure, walk.prims, &moment.cost);
    let all = counted(all, one, many);
    let each: BTreeSet<PrimId> = moment.tested.iter().map(|test| test.prim).collect();
    let once = each.len() as u64;
    let again = !tests_box_only(walk.structure) && !matches!(walk.prims, Prims::Instances(_)) && once < tests;
    let says = if again { format!("tests, of {once} of {all}") } else { format!("of {all} tested") };
    (tests, says)
}

/// How many tests a walk has cost, how many things there are to be tested, and what one and many of them are called.
/// In instances the triangles of their models are tested, as often as they are placed.
fn of_all(structure: &Structure, prims: &Prims, cost: &Cost) -> (u64, u64, &'static str, &'static str) {
    let volume = VolumeName::of(structure);
    match prims {
        _ if tests_box_only(structure) => (cost.box_tests, 1, volume.one, volume.many),
        Prims::Instances(placed) => (cost.prim_tests, placed.triangles(), "triangle", "triangles"),
        _ => (cost.prim_tests, prims.len() as u64, "primitive", "primitives"),
    }
}

/// The primitives tested so far as a number and a bar, the rest of the work in words. `beside` names
/// another walk and how many it has tested, for a second bar.
pub fn work(walk: &Walk<'_>, moment: &Moment, beside: Option<(&str, u64)>, size: Vec2, look: &Look) -> Figure {
    let mut figure = Figure::new(size);
    let top = look.heading(&mut figure, "Work so far", "");
    let (left, u) = (look.margin(), look.text);
    let only_box = tests_box_only(walk.structure);
    let volume = VolumeName::of(walk.structure);
    let (_, all, ..) = of_all(walk.structure, walk.prims, &moment.cost);

    let (tests, says) = tests_of(walk, moment);
    let mut y = loud(&mut figure, tests, &says, top, look) + u * 0.6;

    // The same as a bar; with another walk beside it, a bar each.
    let bars = std::iter::once(("", tests)).chain(beside);
    let longest = beside.map_or(all, |(_, tests)| all.max(tests)).max(tests).max(1);
    for (name, tests) in bars {
        let height = u * 0.75;
        let width = size.x - 2.0 * left;
        if !name.is_empty() {
            let says = format!("{name}: {}", counted(tests, "test", "tests"));
            write(&mut figure, Role::Quiet, None, Vec2::new(left, y + u * 0.5), &says, u, Face::Regular, Anchor::Start);
            y += u * 1.4;
        }
        figure.add(Role::Panel, None, block(Vec2::new(left, y), Vec2::new(width, height), u * 0.2));
        if tests > 0 {
            let part = (width * tests as f32 / longest as f32).max(3.0);
            figure.add(Role::Missed, None, block(Vec2::new(left, y), Vec2::new(part, height), u * 0.2));
        }
        y += height + u * 0.8;
    }

    let done = if only_box { Vec::new() } else { sentence(moment, volume) };
    rest(&mut figure, &done, y, look);
    figure
}

/// What else was done: nodes, cells, planes, boxes. Only what happened.
fn sentence(moment: &Moment, volume: VolumeName) -> Vec<String> {
    let cost = &moment.cost;
    let (one_tested, many_tested) = (format!("{} tested", volume.one), format!("{} tested", volume.many));
    [
        (cost.node_visits, "node entered", "nodes entered"),
        (cost.cell_steps, "cell entered", "cells entered"),
        (cost.plane_tests, "plane tested", "planes tested"),
        (cost.box_tests, &*one_tested, &*many_tested),
        (cost.pushes, "pushed", "pushed"),
        (cost.drops, "dropped", "dropped"),
        (cost.skips, "test skipped", "tests skipped"),
    ]
    .into_iter()
    .filter(|(count, ..)| *count > 0)
    .map(|(count, one, many)| counted(count, one, many))
    .collect()
}
