//! The steps of a test in words, one below the other.

use glam::Vec2;

use super::Tried;
use crate::page::{Anchor, Figure, Look, block, write};
use crate::theme::fonts::elided;
use crate::theme::{Face, Role};
use crate::words::{Fact, VolumeName};

/// What the test has computed so far; of many steps the last that there is room for. What answers an open question is
/// not among them.
pub(crate) fn steps(tried: &Tried<'_>, size: Vec2, look: &Look) -> Figure {
    let mut figure = Figure::new(size);
    let top = look.heading(&mut figure, "The test so far", "") + look.margin() * 0.4;
    let line = look.line() * 1.9;
    let fit = ((size.y - top) / line) as usize;
    let steps = tried.done.get(1..).unwrap_or_default();
    let first = steps.len().saturating_sub(fit.max(1));
    let width = size.x - 2.0 * look.margin();
    for (index, trial) in steps.iter().enumerate().skip(first) {
        let y = top + line * ((index - first) as f32 + 0.5);
        let now = index + 1 == steps.len();
        if now {
            let corner = Vec2::new(look.margin() * 0.5, y - line * 0.5);
            let room = Vec2::new(size.x - look.margin(), line);
            figure.add(Role::Ground, Some(trial.place()), block(corner, room, look.text * 0.2));
        }
        let (small, place) = (look.small(), Some(trial.place()));
        let short = format!("{}  {}", index + 1, trial.short(VolumeName::BOX));
        let at = Vec2::new(look.margin(), y - line * 0.23);
        let role = if now { Role::Here } else { Role::Text };
        write(&mut figure, role, place, at, &short, look.text, Face::Medium, Anchor::Start);
        let says = elided(&trial.sentence(VolumeName::BOX), Face::Regular, small, width);
        let at = Vec2::new(look.margin(), y + line * 0.23);
        write(&mut figure, Role::Quiet, place, at, &says, small, Face::Regular, Anchor::Start);
    }
    if steps.is_empty() {
        let at = Vec2::new(look.margin(), top + look.line() * 0.5);
        write(&mut figure, Role::Quiet, None, at, "Nothing is computed yet.", look.text, Face::Regular, Anchor::Start);
    }
    figure
}
