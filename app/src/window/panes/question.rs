//! The question box: asked before the step that answers it, answered by button, key or a click on the place.

use egui::{Button, Frame, Margin, RichText, Stroke, Ui, vec2};
use raystep_figure::{Face, Role, Theme};
use raystep_lesson::Choice;

use crate::shown::command::Command;
use crate::shown::playback::Posed;
use crate::shown::state::State;
use crate::shown::words::{label, question_text, reason};
use crate::window::look::fonts::font;
use crate::window::look::formulas::Formulas;
use crate::window::look::markdown::plain;
use crate::window::look::prose::{LEADING, Prose};
use crate::window::look::visuals::{fill, ink, tinted};

/// Shows the open question, or what became of the one just answered. Says which command was asked for.
pub(super) fn show(ui: &mut Ui, state: &State, theme: &Theme, formulas: &mut Formulas) -> Option<Command> {
    if let Some((posed, answered)) = state.settled() {
        let choice = &posed.choices[answered.choice];
        boxed(ui, theme, Role::Hit, |ui| {
            ui.label(RichText::new("Correct").font(font(Face::Bold, 13.0)).color(ink(theme, Role::Hit)));
            let text = format!("{} **{}**", question_text(state, posed), label(choice));
            Prose { theme, size: 14.5, role: Role::Text, face: Face::Regular, leading: LEADING }
                .show(ui, formulas, &text);
        });
        return None;
    }
    let posed = state.question()?;
    let wrong = state.answered.filter(|answered| answered.beat == posed.beat && !answered.right);
    let mut asked = None;
    boxed(ui, theme, Role::Here, |ui| {
        ui.label(RichText::new("Before you step").font(font(Face::Bold, 12.5)).color(ink(theme, Role::Here)));
        let question = Prose { theme, size: 16.0, role: Role::Text, face: Face::Medium, leading: LEADING };
        question.show(ui, formulas, &question_text(state, posed));
        asked = answers(ui, posed, wrong.map(|answered| answered.choice), theme);
        if let Some(answered) = wrong {
            let choice = &posed.choices[answered.choice];
            ui.label(RichText::new("Not this").font(font(Face::Bold, 12.5)).color(ink(theme, Role::Wrong)));
            let reason = reason(state, posed, choice);
            Prose { theme, size: 14.0, role: Role::Text, face: Face::Regular, leading: LEADING }
                .show(ui, formulas, &reason);
        }
        let clickable = posed.choices.iter().any(|choice| choice.place.is_some());
        let hint = if clickable { "or click it in the picture · Enter or → skips" } else { "Enter or → skips" };
        ui.label(RichText::new(hint).small().color(ink(theme, Role::Quiet)));
    });
    asked
}

/// One button for each answer, two in a row where they fit.
fn answers(ui: &mut Ui, posed: &Posed, wrong: Option<usize>, theme: &Theme) -> Option<Command> {
    let mut asked = None;
    let gap = 10.0;
    let longest = posed.choices.iter().map(|choice| raystep_figure::text_width(&label(choice), Face::Medium, 15.0));
    let longest = longest.fold(0.0, f32::max) + 46.0;
    let columns = if longest * 2.0 + gap <= ui.available_width() { 2 } else { 1 };
    let width = (ui.available_width() - gap * (columns as f32 - 1.0)) / columns as f32;
    for (row, choices) in posed.choices.chunks(columns).enumerate() {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = gap;
            for (column, choice) in choices.iter().enumerate() {
                let index = row * columns + column;
                if answer(ui, choice, index, wrong == Some(index), width, theme).clicked() {
                    asked = Some(Command::Answer(index as u8));
                }
            }
        });
    }
    asked
}

fn answer(ui: &mut Ui, choice: &Choice, index: usize, wrong: bool, width: f32, theme: &Theme) -> egui::Response {
    let letter = char::from(b'A' + index.min(25) as u8);
    let role = if wrong { Role::Wrong } else { Role::Here };
    let name = plain(&label(choice));
    let text = RichText::new(&name).font(font(Face::Medium, 15.0)).color(ink(theme, Role::Text));
    let key = RichText::new(letter).font(font(Face::Mono, 12.5)).color(ink(theme, Role::Quiet));
    let button = Button::new(text)
        .right_text(key)
        .fill(fill(theme, Role::Panel))
        .stroke(Stroke::new(1.5, ink(theme, role)))
        .corner_radius(6.0)
        .min_size(vec2(width, 40.0));
    // A long answer runs on in a second line.
    let response = ui
        .scope(|ui| {
            ui.set_max_width(width);
            ui.add(button.wrap())
        })
        .inner;
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, format!("Answer {letter}: {name}")));
    response
}

/// A rounded box in a role's colour.
fn boxed(ui: &mut Ui, theme: &Theme, role: Role, add: impl FnOnce(&mut Ui)) {
    let ground = if role == Role::Here { tinted(theme) } else { fill(theme, Role::Panel) };
    let frame = Frame::new()
        .fill(ground)
        .stroke(Stroke::new(1.4, ink(theme, role)))
        .corner_radius(9.0)
        .inner_margin(Margin::symmetric(16, 14));
    frame.show(ui, |ui| {
        ui.set_width(ui.available_width());
        ui.spacing_mut().item_spacing.y = 9.0;
        add(ui);
    });
}
