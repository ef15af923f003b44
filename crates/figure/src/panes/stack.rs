//! The stack in words: which nodes wait, and for which part of the ray.

use glam::Vec2;
use raystep_accel::Place;

use crate::moments::{Build, GrowMoment, Moment, Walk};
use crate::page::{Anchor, Figure, Look, block, write};
use crate::theme::{Face, Role};
use crate::words::number;

/// One row of a stack.
struct Row {
    place: Place,
    role: Role,
    /// Its part of the ray.
    interval: String,
    /// When it is opened.
    word: &'static str,
}

/// What waits, the next one on top; when something waits behind it, with the words "next" and "later".
pub fn stack(walk: &Walk<'_>, moment: &Moment, size: Vec2, look: &Look) -> Figure {
    let interval = |near: f32, far: f32| format!("[{}, {}]", number(near), number(far));
    let waiting = moment.stack.iter().rev().enumerate().map(|(index, waiting)| Row {
        place: Place::Node(waiting.node),
        role: Role::Waiting,
        interval: interval(waiting.near, waiting.far),
        word: word(index, moment.stack.len()),
    });
    let rows: Vec<Row> = waiting.collect();
    let nothing = if walk.structure.node_count() > 0 { "Nothing waits." } else { "This walk needs no stack." };
    let remark = if moment.stack.len() > 1 { "opened from the top" } else { "" };
    draw("Stack", remark, &rows, nothing, size, look)
}

/// The nodes that a builder has yet to build, the next one on top; of one that joins sets, those that are left.
pub fn stack_of_build(build: &Build<'_>, moment: &GrowMoment, size: Vec2, look: &Look) -> Figure {
    let row = |place, role, word| Row { place, role, interval: String::new(), word };
    if build.joins() {
        let sets = moment.apart();
        let rows: Vec<Row> = sets.iter().map(|node| row(Place::Node(*node), Role::Seen, "")).collect();
        return draw(JOINED, "", &rows, nothing_apart(moment), size, look);
    }
    let many = moment.waiting.len();
    let waiting = moment.waiting.iter().rev().enumerate();
    let waiting = waiting.map(|(index, node)| row(Place::Node(*node), Role::Waiting, word(index, many)));
    let rows: Vec<Row> = waiting.collect();
    let remark = if many > 1 { "built from the top" } else { "" };
    draw("Still to be built", remark, &rows, "Nothing waits.", size, look)
}

/// What stands over the sets that are left to be joined.
pub(super) const JOINED: &str = "Still to be merged";

/// What is said where no two sets are left.
fn nothing_apart(moment: &GrowMoment) -> &'static str {
    if moment.tally.joined > 0 { "One set is left." } else { "The other sets are still to come." }
}

/// How high a row is, and the gap under it.
fn row(look: &Look) -> (f32, f32) {
    (look.text * 2.3, look.text * 0.45)
}

/// The same where all rows fit only if they stand closer.
fn close_row(look: &Look) -> (f32, f32) {
    (look.text * 1.55, look.text * 0.25)
}

/// How high a stack with so many rows is.
pub fn stack_height(rows: usize, look: &Look) -> f32 {
    let (height, gap) = row(look);
    look.heading(&mut Figure::default(), "", "") + (height + gap) * rows as f32 + gap
}

/// When the row with this place from the top is opened.
fn word(index: usize, many: usize) -> &'static str {
    match index {
        _ if many < 2 => "",
        0 => "next",
        _ => "later",
    }
}

fn draw(title: &str, remark: &str, rows: &[Row], nothing: &str, size: Vec2, look: &Look) -> Figure {
    let mut figure = Figure::new(size);
    // All rows that fit; of more, the last line says how many, or the heading where there is no line left.
    let top = look.heading(&mut Figure::default(), "", "");
    let fit = |(height, gap): (f32, f32)| (((size.y - top) / (height + gap)) as usize).max(1);
    let close = (fit(row(look)) + 1..=fit(close_row(look))).contains(&rows.len());
    let (height, gap) = if close { close_row(look) } else { row(look) };
    let fit = fit((height, gap));
    let shown = rows.len().min(fit);
    let more = format!("and {} more below", rows.len() - shown);
    let below = top + shown as f32 * (height + gap) + look.line() * 0.5;
    let in_heading = shown < rows.len() && below + look.text * 0.5 > size.y;
    look.heading(&mut figure, title, if in_heading { &more } else { remark });
    if rows.is_empty() {
        let at = Vec2::new(look.margin(), top + look.line() * 0.5);
        write(&mut figure, Role::Quiet, None, at, nothing, look.text, Face::Regular, Anchor::Start);
        return figure;
    }

    for (index, Row { place, role, interval, word }) in rows.iter().take(shown).enumerate() {
        let corner = Vec2::new(look.margin(), top + index as f32 * (height + gap));
        let extent = Vec2::new(size.x - 2.0 * look.margin(), height);
        figure.add(*role, Some(*place), block(corner, extent, look.text * 0.4));
        let middle = corner.y + height / 2.0;
        let (left, right) = (corner.x + look.text * 0.9, corner.x + extent.x - look.text * 0.9);
        let mut put = |role, x, text: &str, face, anchor| {
            write(&mut figure, role, Some(*place), Vec2::new(x, middle), text, look.text, face, anchor);
        };
        put(*role, left, &place.to_string(), Face::Bold, Anchor::Start);
        let word_room = if word.is_empty() { 0.0 } else { look.text * 3.6 };
        put(Role::Text, right - word_room, interval, Face::Mono, Anchor::End);
        put(Role::Text, right, word, Face::Regular, Anchor::End);
    }
    if shown < rows.len() && !in_heading {
        let at = Vec2::new(look.margin(), below);
        write(&mut figure, Role::Quiet, None, at, &more, look.text, Face::Regular, Anchor::Start);
    }
    figure
}
