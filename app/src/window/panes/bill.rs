//! What a walk has cost so far, under its picture, and what one that makes a mistake comes to.

use egui::{Align2, Rect, Ui, vec2};
use raystep_accel::{Cost, Event, Hit, Structure, Verdict, Visit};
use raystep_figure::{Face, Role, counted, number, tested, text_width};
use raystep_lesson::{PacketTape, Tape};

use super::page::Page;
use crate::shown::beside::Beside;
use crate::shown::playback::Playback;
use crate::shown::state::State;
use crate::window::look::painter::caption;

/// What a walk has cost so far, under its picture.
pub(super) fn bill(ui: &Ui, page: Page<'_>, rect: Rect, playback: &Playback, cost: Option<Cost>, scale: f32) {
    let Some(cost) = cost else { return };
    let structure = &*playback.play.structure;
    let (tests, of) = tested(structure, &playback.play.scene.prims, &cost);
    // Without a mailbox a primitive may be tested twice.
    let mut says = vec![format!("{}, of {of}", counted(tests, "test", "tests"))];
    match (cost.node_visits, cost.cell_steps) {
        (0, 0) => {}
        (0, cells) => {
            says.push(counted(cells, "cell", "cells"));
        }
        (nodes, _) => {
            says.push(counted(nodes, "node", "nodes"));
        }
    }
    let beside = playback.kind != Beside::Nothing;
    let step = if beside { page.state.beside_step(playback) } else { page.state.view.step };
    let over = step == playback.steps().last();
    if page.state.question().is_some() && beside {
        says = vec!["waits for your answer".to_owned()];
    } else if !over {
        says.push("not finished".to_owned());
    }
    if structure.node_count() > 0 || structure.grid().is_some() {
        says.push(format!("built in {} ms", number(playback.seconds * 1000.0)));
    }
    // What has no room beside the other picture's is left out, the last first.
    let (indent, size) = (14.0 * scale, 12.5 * scale);
    let wide = |says: &[String]| text_width(&says.join(" · "), Face::Regular, size);
    while says.len() > 1 && wide(&says) > rect.width() - 2.0 * indent {
        says.pop();
    }
    let at = rect.left_bottom() + vec2(indent, -16.0 * scale);
    let says = says.join(" · ");
    caption(ui.painter(), at, Align2::LEFT_CENTER, &says, Face::Regular, size, Role::Quiet, page.theme);
    if let Some((verdict, role)) = verdict(page.state, playback).filter(|_| over) {
        let size = 13.5 * scale;
        let room = rect.width() - 2.0 * indent;
        let wide = |text: &str| text_width(text, Face::Bold, size).max(1.0);
        // What is too long for a line takes two.
        let half = verdict.rfind(';').or_else(|| verdict.rfind(':')).filter(|_| wide(&verdict) > room);
        let (first, second) = verdict.split_at(half.map_or(0, |at| at + 1));
        for (row, line) in [second.trim(), first].into_iter().filter(|line| !line.is_empty()).enumerate() {
            let size = size * (room / wide(line)).min(1.0);
            let at = at - vec2(0.0, (20.0 + 18.0 * row as f32) * scale);
            caption(ui.painter(), at, Align2::LEFT_CENTER, line, Face::Bold, size, role, page.theme);
        }
    }
}

/// What a mistaken walk comes to in the end, against the right one.
pub(super) fn verdict(state: &State, beside: &Playback) -> Option<(String, Role)> {
    let Beside::Mistake(_) = beside.kind else { return None };
    let right = state.playback()?;
    let said = |hit: Option<Hit>| match hit {
        Some(hit) => format!("primitive {} at t = {}", hit.prim.0, number(hit.t)),
        None => "no hit".to_owned(),
    };
    if let (Tape::Packet(right), Tape::Packet(beside)) = (&right.play.tape, &beside.play.tape) {
        return Some(packets_verdict(right, beside));
    }
    let verdicts = (box_verdict(right), box_verdict(beside));
    let (answer, wrong) = (right.answer()?, beside.answer()?);
    let last = |playback: &Playback| playback.cost(playback.steps().last());
    Some(match verdicts {
        (Some(met), Some(claimed)) if met != claimed => {
            let words = |met| if met { "met" } else { "missed" };
            (format!("Wrong: it says {}; the box is {}.", words(claimed), words(met)), Role::Wrong)
        }
        _ if answer != wrong => (format!("Wrong: {}; right is {}.", said(wrong), said(answer)), Role::Wrong),
        _ if last(right) == last(beside) => {
            ("No difference on this ray: the same answer after the same work.".to_owned(), Role::Text)
        }
        _ => ("The same answer, with other work.".to_owned(), Role::Text),
    })
}

/// What a packet comes to that goes wrong: which of its rays have another answer.
fn packets_verdict(right: &PacketTape, beside: &PacketTape) -> (String, Role) {
    let differs = |(lane, (a, b)): (usize, _)| (a != b).then(|| (lane + 1).to_string());
    let pairs = right.found.iter().zip(&beside.found);
    let wrong: Vec<String> = pairs.enumerate().filter_map(differs).collect();
    match wrong.as_slice() {
        [] if right.events == beside.events => {
            ("No difference for these rays: the same answers after the same work.".to_owned(), Role::Text)
        }
        [] => ("The same answers, with other work.".to_owned(), Role::Text),
        [one] => (format!("Wrong: ray {one} has another answer."), Role::Wrong),
        [most @ .., last] => (format!("Wrong: rays {} and {last} have other answers.", most.join(", ")), Role::Wrong),
    }
}

/// Whether the last volume that was tested was met, where a walk tests nothing else.
fn box_verdict(playback: &Playback) -> Option<bool> {
    let Structure::Slab(_) = &*playback.play.structure else { return None };
    let steps = 1..=playback.steps().last();
    steps.rev().find_map(|step| match playback.event(step) {
        Some(Event::Walk(Visit::Volume { verdict, .. })) => Some(verdict == Verdict::Hit),
        _ => None,
    })
}
