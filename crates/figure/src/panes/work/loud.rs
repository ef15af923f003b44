//! The one loud number of the work so far, and what it counts.

use glam::Vec2;

use crate::page::{Anchor, Figure, Look, wrapped, write};
use crate::theme::{Face, Role, text_width};
use crate::words::whole;

/// The number's letters, in those of the pane, and how small they may become beside what it counts.
const LARGEST: f32 = 2.6;
const SIZES: [f32; 4] = [1.0, 0.9, 0.8, 0.7];

/// From line to line, in letters.
const LINE: f32 = 1.6;

/// Writes a number below `top` with what it counts behind it, or under it where the pane is too narrow; says where that
/// ends.
pub(super) fn loud(figure: &mut Figure, count: u64, says: &str, top: f32, look: &Look) -> f32 {
    let (left, u, digits) = (look.margin(), look.text, whole(count));
    let gap = u * 0.6;
    let wide = |size: f32, small: f32| {
        text_width(&digits, Face::Bold, u * LARGEST * size) + gap + text_width(says, Face::Regular, u * small)
    };
    let room = figure.size.x - 2.0 * left;
    let beside =
        SIZES.iter().map(|size| (*size, 1.1 * size.max(0.85))).find(|(size, small)| wide(*size, *small) <= room);
    let (size, small) = beside.unwrap_or((1.0, 1.1));
    let large = u * LARGEST * size;
    let base = Vec2::new(left, top + large * 0.5);
    write(figure, Role::Missed, None, base, &digits, large, Face::Bold, Anchor::Start);
    if beside.is_some() {
        let after = base + Vec2::new(text_width(&digits, Face::Bold, large) + gap, large * 0.14);
        write(figure, Role::Text, None, after, says, u * small, Face::Regular, Anchor::Start);
        return top + large;
    }
    let size = (u * 1.1).min(room / text_width(says, Face::Regular, 1.0).max(0.01));
    let under = Vec2::new(left, top + large + u * 0.7);
    write(figure, Role::Text, None, under, says, size, Face::Regular, Anchor::Start);
    under.y + u * 0.7
}

/// Writes what else was done in lines below `top`: in smaller letters where the pane is low.
pub(super) fn rest(figure: &mut Figure, parts: &[String], top: f32, look: &Look) {
    let (left, room) = (look.margin(), figure.size.y - top - look.text * 0.4);
    let width = figure.size.x - 2.0 * left;
    // The last line needs its letters alone.
    let fits = |u: &f32| (wrapped(parts, width, *u).len() as f32 - 1.0) * u * LINE + u <= room;
    let u = SIZES.iter().map(|size| look.text * size).find(fits).unwrap_or(look.text * SIZES[SIZES.len() - 1]);
    for (line, says) in wrapped(parts, width, u).iter().enumerate() {
        let y = top + u * (0.4 + LINE * line as f32);
        write(figure, Role::Quiet, None, Vec2::new(left, y), says, u, Face::Regular, Anchor::Start);
    }
}
