//! Who takes part, as a strip of numbered cells: one a ray.

use glam::Vec2;
use raystep_accel::{Lanes, Place};

use crate::page::{Anchor, Figure, Ink, Look, Mark, line, write};
use crate::panes::lanes::{ROW, small_strip, strip_room};
use crate::panes::{ListingLine, listing};
use crate::theme::{Face, Role, text_width};
use crate::words::Fact;

/// How wide a cell with a ray's number is, in letters of this size.
pub(super) fn cell(letters: f32) -> f32 {
    letters * 1.75
}

/// A ray's number in a cell: solid if it takes part, dotted if not. `at` is its middle.
pub(super) fn numbered(figure: &mut Figure, role: Role, place: Option<Place>, lane: usize, at: Vec2, letters: f32) {
    let text = (lane + 1).to_string();
    // Two digits in the room of one.
    let size = if text.len() > 1 { letters * 0.78 } else { letters };
    let ink = Ink::Text { at, text, size, face: Face::Medium, anchor: Anchor::Middle, boxed: true };
    figure.add(role, place, ink);
}

/// A strip of numbered cells from `at` on, the middle of its left edge. Returns where it ends.
pub(super) fn strip(
    figure: &mut Figure,
    place: Option<Place>,
    lanes: Lanes,
    there: usize,
    at: Vec2,
    letters: f32,
) -> f32 {
    // Of many the cells alone: numbers would not be read.
    if there > ROW {
        let room = strip_room(lanes, letters * 0.7);
        small_strip(figure, place, lanes, at - Vec2::new(0.0, room.y * 0.5), letters * 0.7);
        return at.x + room.x;
    }
    let wide = cell(letters);
    for lane in 0..there {
        let role = if lanes.has(lane) { Role::Lane } else { Role::Dropped };
        numbered(figure, role, place, lane, at + Vec2::new(wide * (lane as f32 + 0.5), 0.0), letters);
    }
    at.x + wide * there as f32
}

/// How wide such a strip is.
pub(super) fn strip_width(lanes: Lanes, there: usize, letters: f32) -> f32 {
    if there > ROW { strip_room(lanes, letters * 0.7).x } else { cell(letters) * there as f32 }
}

/// A sample of the line that a ray is drawn with.
pub(super) fn sample(figure: &mut Figure, role: Role, at: Vec2, width: f32) {
    figure.add(role, None, line(at, at + Vec2::new(width, 0.0)));
}

/// The listing, with a strip of those who take part at the end of the current line.
pub(crate) fn listing_of_packet(
    lines: &[ListingLine<'_>],
    fact: Option<&dyn Fact>,
    lanes: Option<Lanes>,
    there: usize,
    flat: bool,
    size: Vec2,
    look: &Look,
) -> Figure {
    let mut figure = listing("Walk", lines, fact, flat, size, look);
    let current = figure.marks.iter().find_map(|mark| match mark.ink {
        Ink::Rect { min, max, .. } if mark.role == Role::Ground => Some((min, max)),
        _ => None,
    });
    let (Some((min, max)), Some(lanes)) = (current, lanes) else { return figure };
    // Beside the line or beside its numbers, wherever there is room.
    let letters = look.text * 0.95;
    let width = strip_width(lanes, there, letters);
    let end_of_row = |y: f32| {
        let end = |mark: &Mark| match &mark.ink {
            Ink::Text { at, text, size, face, anchor: Anchor::Start, .. } if (at.y - y).abs() < look.line() * 0.4 => {
                at.x + text_width(text, *face, *size)
            }
            _ => 0.0,
        };
        figure.marks.iter().map(end).fold(0.0, f32::max)
    };
    let rows = ((max.y - min.y) / look.line()).round().max(1.0) as usize;
    let middle = |row: usize| min.y + look.line() * (row as f32 + 0.5);
    let left = max.x - width - look.text * 0.5;
    let row = (0..rows).find(|row| end_of_row(middle(*row)) < left - look.text * 0.5);
    if let Some(row) = row {
        strip(&mut figure, None, lanes, there, Vec2::new(left, middle(row)), letters);
    }
    figure
}

/// A line of plain text from `at` on.
pub(super) fn say(figure: &mut Figure, role: Role, at: Vec2, text: &str, size: f32, anchor: Anchor) {
    write(figure, role, None, at, text, size, Face::Regular, anchor);
}
