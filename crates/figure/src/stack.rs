//! The stack in words: which nodes wait, and for which part of the ray.

use glam::Vec2;
use raystep_accel::Place;

use crate::look::{block, write};
use crate::{Anchor, Face, Figure, Look, Moment, Role, Walk, number};

/// What waits, the next one on top; when something waits behind it, with the words "next" and "later".
/// `here` puts the current place above them, as "now".
pub fn stack(walk: &Walk<'_>, moment: &Moment, here: bool, size: Vec2, look: &Look) -> Figure {
    let mut figure = Figure::new(size);
    let remark = if moment.stack.len() > 1 { "opened from the top" } else { "" };
    let top = look.heading(&mut figure, "Stack", remark);

    let now = moment.here.filter(|place| here && matches!(place, Place::Node(_)));
    let now = now.map(|place| (place, moment.entered.near, moment.entered.far, Role::Here, "now"));
    let waiting = moment.stack.iter().rev().enumerate().map(|(index, waiting)| {
        let word = match index {
            _ if moment.stack.len() < 2 && !here => "",
            0 => "next",
            _ => "later",
        };
        (Place::Node(waiting.node), waiting.near, waiting.far, Role::Waiting, word)
    });
    let rows: Vec<_> = now.into_iter().chain(waiting).collect();
    if rows.is_empty() {
        let at = Vec2::new(look.margin(), top + look.line() * 0.5);
        let says = if walk.structure.node_count() > 0 { "Nothing waits." } else { "This walk needs no stack." };
        write(&mut figure, Role::Quiet, None, at, says, look.text, Face::Regular, Anchor::Start);
        return figure;
    }

    // All rows that fit; of more, the last line says how many.
    let (height, gap) = (look.text * 2.3, look.text * 0.45);
    let fit = (((size.y - top) / (height + gap)) as usize).max(1);
    let shown = if rows.len() > fit { fit.saturating_sub(1).max(1) } else { rows.len() };
    for (index, (place, near, far, role, word)) in rows.iter().take(shown).enumerate() {
        let corner = Vec2::new(look.margin(), top + index as f32 * (height + gap));
        let extent = Vec2::new(size.x - 2.0 * look.margin(), height);
        figure.add(*role, Some(*place), block(corner, extent, look.text * 0.4));
        let middle = corner.y + height / 2.0;
        let (left, right) = (corner.x + look.text * 0.9, corner.x + extent.x - look.text * 0.9);
        let interval = format!("[{}, {}]", number(*near), number(*far));
        let mut put = |role, x, text: &str, face, anchor| {
            write(&mut figure, role, Some(*place), Vec2::new(x, middle), text, look.text, face, anchor);
        };
        put(*role, left, &place.to_string(), Face::Bold, Anchor::Start);
        let word_room = if word.is_empty() { 0.0 } else { look.text * 3.6 };
        put(Role::Text, right - word_room, &interval, Face::Mono, Anchor::End);
        put(Role::Text, right, word, Face::Regular, Anchor::End);
    }
    if shown < rows.len() {
        let at = Vec2::new(look.margin(), top + shown as f32 * (height + gap) + look.line() * 0.5);
        let says = format!("and {} more below", rows.len() - shown);
        write(&mut figure, Role::Quiet, None, at, &says, look.text, Face::Regular, Anchor::Start);
    }
    figure
}
