//! The numbers of a board's meter, taken in the hand: dragged along their tracks, moved by the arrows, or typed.

use egui::{CursorIcon, DragValue, Key, PointerButton, Pos2, Rect, Response, Ui, WidgetInfo};
use raystep_figure::{Face, Knob, KnobLine, Look, Theme};

use super::hold::Hold;
use super::knob::{GRIP, arrows, knob};
use super::page::Asked;
use super::space::glam_size;
use crate::shown::pictures::Pictures;
use crate::window::look::controls::{Change, change};
use crate::window::look::fonts::font;
use crate::window::look::typed::{self, Allowed, Typed};

/// Lets the numbers of a figure be moved.
pub(super) fn hold(
    ui: &mut Ui,
    response: &Response,
    rect: Rect,
    look: &Look,
    pictures: &Pictures,
    theme: &Theme,
    hold: &mut Option<Hold>,
    asked: &mut Vec<Asked>,
) {
    if response.drag_stopped() && matches!(hold, Some(Hold::Number(_))) {
        *hold = None;
    }
    let lines = pictures.knobs(glam_size(rect), look);
    let on_page = |point: glam::Vec2| rect.min + egui::vec2(point.x, point.y);
    let near = |pointer: Pos2| {
        lines.iter().position(|line| {
            let track = Rect::from_two_pos(on_page(line.low), on_page(line.high));
            track.expand(GRIP * 0.9).contains(pointer)
        })
    };
    let held = match hold {
        Some(Hold::Number(index)) => Some(*index),
        _ => None,
    };
    if held.is_some() || response.hover_pos().and_then(near).is_some() {
        ui.ctx().set_cursor_icon(CursorIcon::ResizeHorizontal);
    }
    let to = |line: &KnobLine, pointer: Pos2| {
        let point = pointer - rect.min;
        let value = line.to(glam::Vec2::new(point.x, point.y));
        (value != line.knob.is).then(|| Asked::Number(line.knob.name.clone(), value))
    };
    let press = ui.input(|input| input.pointer.press_origin());
    if response.drag_started_by(PointerButton::Primary)
        && let Some(index) = press.and_then(near)
    {
        *hold = Some(Hold::Number(index));
        asked.push(Asked::Keep);
    }
    if response.dragged()
        && let Some(Hold::Number(index)) = hold
        && let (Some(line), Some(pointer)) = (lines.get(*index), response.interact_pointer_pos())
    {
        asked.extend(to(line, pointer));
    }
    // A click on the track takes the knob there.
    if response.clicked()
        && let Some(pointer) = response.interact_pointer_pos()
        && let Some(moved) = near(pointer).and_then(|index| to(&lines[index], pointer))
    {
        asked.extend([Asked::Keep, moved]);
    }
    for line in &lines {
        keys(ui, response, line, on_page(line.at()), theme, asked);
        by_keys(ui, line, line.digits.map(on_page), asked);
    }
}

/// The part of its track that an arrow moves a knob by, and with Shift.
const STEPS: [f64; 2] = [0.02, 0.002];

/// The same by keyboard: each knob can have the focus.
fn keys(ui: &Ui, response: &Response, line: &KnobLine, at: Pos2, theme: &Theme, asked: &mut Vec<Asked>) {
    let own = &line.knob;
    let id = response.id.with(("number", &own.name));
    let Some(knob) = knob(ui, id, at, &format!("{}: {}", own.name, Knob::digits(own.is)), theme) else { return };
    for (key, first, fine) in arrows(ui, knob.id) {
        let sign = if matches!(key, Key::ArrowRight | Key::ArrowUp) { 1.0 } else { -1.0 };
        let moved = own.at(own.part(own.is) + sign * STEPS[usize::from(fine)]);
        // What is whole moves by one at least.
        let value = if own.whole && moved == own.is { own.nearest(own.is + sign) } else { moved };
        if value != own.is {
            asked.extend(first.then_some(Asked::Keep));
            asked.push(Asked::Number(own.name.clone(), value));
        }
    }
}

/// The same typed: a click on the digits, and a drag over them.
fn by_keys(ui: &mut Ui, line: &KnobLine, digits: [Pos2; 2], asked: &mut Vec<Asked>) {
    let own = &line.knob;
    let mut value = own.is;
    let speed = if own.log { own.is.abs() * 0.01 } else { (own.to - own.from) * 0.002 };
    let field = DragValue::new(&mut value)
        .range(own.from..=own.to)
        .speed(speed)
        .custom_formatter(|value, _| Knob::digits(value));
    let allowed = Allowed { range: own.from..=own.to, digits: Knob::digits, whole: false };
    let Typed { response: field, wrong } = typed::field(ui, &own.name, &allowed, field, |ui, field| {
        let add = |ui: &mut Ui| {
            ui.style_mut().override_font_id = Some(font(Face::Mono, line.text));
            ui.put(Rect::from_two_pos(digits[0], digits[1]), field)
        };
        ui.scope(add).inner
    });
    field.widget_info(|| WidgetInfo::labeled(egui::Role::SpinButton, true, format!("{}, typed", own.name)));
    asked.extend(wrong.map(Asked::Say));
    let value = own.nearest(value);
    if let Some(change) = change(&field).filter(|_| value != own.is) {
        asked.extend((change == Change::Begins).then_some(Asked::Keep));
        asked.push(Asked::Number(own.name.clone(), value));
    }
}
