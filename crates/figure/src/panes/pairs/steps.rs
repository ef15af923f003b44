//! The steps of a test in words, one below the other.

use glam::Vec2;

use crate::page::{Anchor, Figure, Look, block, write};
use crate::theme::fonts::broken;
use crate::theme::{Face, Role};
use crate::words::{Fact, VolumeName};

/// What was computed so far, each step with its number; of many the last that there is room for. What answers an open
/// question is not among them.
pub(crate) fn steps(title: &str, steps: &[(usize, &dyn Fact)], size: Vec2, look: &Look) -> Figure {
    let mut figure = Figure::new(size);
    // Whole points: rows of the same height stand in the same places, whichever comes first.
    let top = (look.heading(&mut figure, title, "") + look.margin() * 0.4).round();
    let (line, small, width) = (look.line(), look.small(), size.x - 2.0 * look.margin());
    let said: Vec<Vec<String>> =
        steps.iter().map(|(_, step)| broken(&step.sentence(VolumeName::BOX), Face::Regular, small, width)).collect();
    let high = |said: &Vec<String>| (line * (1.15 + 0.8 * said.len() as f32)).round();
    // From the last one up, as many as there is room for.
    let mut room = size.y - top;
    let fitting = said.iter().rev().take_while(|said| {
        room -= high(said);
        room >= 0.0
    });
    let first = steps.len() - fitting.count().max(1).min(steps.len());
    let mut y = top;
    for (index, ((number, step), said)) in steps.iter().zip(&said).enumerate().skip(first) {
        let now = index + 1 == steps.len();
        if now {
            let corner = Vec2::new(look.margin() * 0.5, y);
            let room = Vec2::new(size.x - look.margin(), high(said));
            figure.add(Role::Ground, None, block(corner, room, look.text * 0.2));
        }
        let short = format!("{number}  {}", step.short(VolumeName::BOX));
        let at = Vec2::new(look.margin(), y + line * 0.55);
        let role = if now { Role::Here } else { Role::Text };
        write(&mut figure, role, None, at, &short, look.text, Face::Medium, Anchor::Start);
        for (row, words) in said.iter().enumerate() {
            let at = Vec2::new(look.margin(), y + line * (1.4 + 0.8 * row as f32));
            write(&mut figure, Role::Quiet, None, at, words, small, Face::Regular, Anchor::Start);
        }
        y += high(said);
    }
    if steps.is_empty() {
        let at = Vec2::new(look.margin(), top + look.line() * 0.5);
        write(&mut figure, Role::Quiet, None, at, "Nothing is computed yet.", look.text, Face::Regular, Anchor::Start);
    }
    figure
}
