//! The cut that a builder weighs, taken in the hand: it is tried wherever the pointer or the arrows move it, and the
//! build stays as it is.

use egui::{CursorIcon, Key, PointerButton, Pos2, Rect, Response, Ui, pos2};
use raystep_accel::Axis;
use raystep_figure::{CutLine, Look, Theme};

use super::hold::Hold;
use super::knob::{GRIP, arrows, knob};
use super::page::Asked;
use super::space::glam_size;
use crate::shown::pictures::Pictures;

/// Shows that the line of the cut can be taken, and lets it be moved.
pub(super) fn hold(
    ui: &Ui,
    response: &Response,
    rect: Rect,
    look: &Look,
    pictures: &Pictures,
    theme: &Theme,
    hold: &mut Option<Hold>,
    asked: &mut Vec<Asked>,
) {
    if response.drag_stopped() && *hold == Some(Hold::Cut) {
        *hold = None;
    }
    let Some(line) = pictures.cut_line(glam_size(rect), look) else { return };
    let held = *hold == Some(Hold::Cut);
    let near = |pointer: Pos2| away(rect, &line, pointer) <= GRIP * 0.8;
    if held || response.hover_pos().is_some_and(near) {
        let cursor = if line.cut.axis == Axis::Y { CursorIcon::ResizeVertical } else { CursorIcon::ResizeHorizontal };
        ui.ctx().set_cursor_icon(cursor);
    }
    let press = ui.input(|input| input.pointer.press_origin());
    if response.drag_started_by(PointerButton::Primary) && press.is_some_and(near) {
        *hold = Some(Hold::Cut);
        asked.push(Asked::Keep);
    }
    let to = |point: Pos2| {
        let point = point - rect.min;
        let cut = pictures.cut_to(glam_size(rect), look, glam::Vec2::new(point.x, point.y));
        cut.filter(|cut| *cut != line.cut).map(Asked::Try)
    };
    if response.dragged() && *hold == Some(Hold::Cut) {
        asked.extend(response.interact_pointer_pos().and_then(to));
    }
    keys(ui, response, rect, &line, theme, to, asked);
}

/// The same by keyboard: the line can have the focus, and the arrows along its axis move it.
fn keys(
    ui: &Ui,
    response: &Response,
    rect: Rect,
    line: &CutLine,
    theme: &Theme,
    to: impl Fn(Pos2) -> Option<Asked>,
    asked: &mut Vec<Asked>,
) {
    let [from, end] = ends(rect, line);
    let grip = from + (end - from) * 0.5;
    let name = format!("Cut of node {} across {}", line.cut.node, line.cut.axis);
    let Some(knob) = knob(ui, response.id.with("cut"), grip, &name, theme) else { return };
    let keys = match line.cut.axis {
        Axis::Y => [(Key::ArrowUp, -1.0), (Key::ArrowDown, 1.0)],
        _ => [(Key::ArrowLeft, -1.0), (Key::ArrowRight, 1.0)],
    };
    for (key, first, fine) in arrows(ui, knob.id) {
        let Some((_, sign)) = keys.into_iter().find(|(known, _)| *known == key) else { continue };
        // A list is cut between two of its primitives; a plane moves by some points, or by one.
        let step = if line.step > 6.0 || !fine { line.step } else { 1.0 };
        let by = step * sign;
        let point = if line.cut.axis == Axis::Y { pos2(from.x, from.y + by) } else { pos2(from.x + by, from.y) };
        if let Some(tried) = to(point) {
            asked.extend(first.then_some(Asked::Keep));
            asked.push(tried);
        }
    }
}

fn ends(rect: Rect, line: &CutLine) -> [Pos2; 2] {
    [line.from, line.to].map(|end| rect.min + egui::vec2(end.x, end.y))
}

/// How far the pointer is from the line.
fn away(rect: Rect, line: &CutLine, pointer: Pos2) -> f32 {
    let [from, to] = ends(rect, line);
    let along = to - from;
    let share = ((pointer - from).dot(along) / along.length_sq().max(1e-6)).clamp(0.0, 1.0);
    pointer.distance(from + along * share)
}
