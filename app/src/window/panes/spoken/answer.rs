//! An answer of the presenter's page: its letter in a box, and once the question is answered a sign for right or wrong.

use std::sync::Arc;

use egui::{Align2, Galley, Pos2, Rect, Sense, Stroke, StrokeKind, Ui, pos2, vec2};
use raystep_figure::{Face, Role, Theme};

use crate::window::look::fonts::font;
use crate::window::look::visuals::{fill, ink};

/// What is known of an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Mark {
    /// It can be given.
    Open,
    /// It was given, and is wrong.
    Wrong,
    /// It is right, and the question is over.
    Right,
    /// It was not given, and the question is over.
    Closed,
}

/// The least height, the room for the letter and for the sign, in letters of the page.
const LEAST: f32 = 1.75;
const KEY: f32 = 2.1;
const SIGN: f32 = 1.5;

/// Answers that stand beside each other are at least so wide, in letters of the page.
const NARROW: f32 = 8.0;

/// How high an answer is in a column of this width, whose letters have this size.
pub(super) fn height(ui: &Ui, name: &str, theme: &Theme, body: f32, width: f32) -> f32 {
    (text(ui, name, theme, body, width).size().y + body * 0.5).max(body * LEAST)
}

fn text(ui: &Ui, name: &str, theme: &Theme, body: f32, width: f32) -> Arc<Galley> {
    let room = width - body * (KEY + SIGN);
    ui.painter().layout(name.to_owned(), font(Face::Regular, body), ink(theme, Role::Text), room)
}

/// How many answers stand beside each other in a column of this width: all of them, or two, where each has but one line.
pub(super) fn across(ui: &Ui, names: &[String], theme: &Theme, body: f32, width: f32) -> usize {
    let fits = |across: &usize| {
        let wide = share(width, *across, body * 0.55);
        wide > body * NARROW && names.iter().all(|name| text(ui, name, theme, body, wide).rows.len() <= 1)
    };
    [names.len().max(1), 2].into_iter().find(fits).unwrap_or(1)
}

/// The width of each of so many.
pub(super) fn share(width: f32, across: usize, gap: f32) -> f32 {
    (width - gap * across.saturating_sub(1) as f32) / across.max(1) as f32
}

/// Shows an answer of this width; says whether it was given.
pub(super) fn show(ui: &mut Ui, index: usize, name: &str, mark: Mark, theme: &Theme, body: f32, width: f32) -> bool {
    let size = vec2(width, height(ui, name, theme, body, width));
    let open = matches!(mark, Mark::Open | Mark::Wrong);
    let (rect, response) = ui.allocate_exact_size(size, if open { Sense::click() } else { Sense::hover() });
    let letter = char::from(b'A' + index.min(25) as u8);
    let says = match mark {
        Mark::Right => format!("Answer {letter}, right: {name}"),
        Mark::Wrong => format!("Answer {letter}, wrong: {name}"),
        Mark::Open | Mark::Closed => format!("Answer {letter}: {name}"),
    };
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, open, &says));
    let role = match mark {
        Mark::Open => Role::Here,
        Mark::Wrong => Role::Wrong,
        Mark::Right => Role::Hit,
        Mark::Closed => Role::Quiet,
    };
    let color = ink(theme, role);
    let painter = ui.painter();
    let lit = response.hovered() && open || response.has_focus();
    let ground = fill(theme, if lit { Role::Ground } else { Role::Panel });
    let thick = body * if matches!(mark, Mark::Right | Mark::Wrong) || lit { 0.12 } else { 0.06 };
    painter.rect(rect, body * 0.3, ground, Stroke::new(thick, color), StrokeKind::Inside);
    let key = Rect::from_center_size(pos2(rect.left() + body * KEY * 0.5, rect.center().y), vec2(body, body) * 1.2);
    painter.rect_filled(key, body * 0.2, color);
    let page = fill(theme, Role::Page);
    painter.text(key.center(), Align2::CENTER_CENTER, letter, font(Face::Bold, body * 0.85), page);
    let galley = text(ui, name, theme, body, width);
    let at = pos2(rect.left() + body * KEY, rect.center().y - galley.size().y * 0.5);
    ui.painter().galley(at, galley, ink(theme, Role::Text));
    sign(ui, mark, pos2(rect.right() - body * SIGN * 0.55, rect.center().y), body, Stroke::new(body * 0.16, color));
    response.clicked()
}

/// A tick or a cross.
fn sign(ui: &Ui, mark: Mark, at: Pos2, body: f32, stroke: Stroke) {
    let place = |x: f32, y: f32| at + vec2(x, y) * body;
    match mark {
        Mark::Right => {
            let points = vec![place(-0.4, 0.0), place(-0.12, 0.32), place(0.42, -0.36)];
            ui.painter().line(points, stroke);
        }
        Mark::Wrong => {
            ui.painter().line_segment([place(-0.32, -0.32), place(0.32, 0.32)], stroke);
            ui.painter().line_segment([place(-0.32, 0.32), place(0.32, -0.32)], stroke);
        }
        Mark::Open | Mark::Closed => {}
    }
}
