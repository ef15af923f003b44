//! The presenter's page: title, space, the ruler, the question or what is said, and the stack in words.

use egui::{Align2, Frame, Rect, RichText, Sense, Ui, pos2, vec2};
use raystep_accel::Place;
use raystep_figure::{Face, Look, Role, sentence, stack_height, told};

use super::app::App;
use super::columns::{bytes, figure};
use super::command::Command;
use super::fonts::font;
use super::painter::caption;
use super::pictures::Pane;
use super::prose::Prose;
use super::question;
use super::stage_pane;
use super::visuals::{fill, ink};
use crate::reel::beginning;

/// Shows the page in the whole window.
pub(super) fn page(app: &mut App, ui: &mut Ui) {
    let rect = ui.max_rect();
    ui.painter().rect_filled(rect, 0.0, fill(app.theme, Role::Page));
    // Everything follows from the height: body text is a twenty-eighth of it or larger.
    let body = (rect.height() / 27.0).clamp(16.0, 64.0).min(rect.width() / 44.0);
    let margin = body * 1.4;
    let inner = rect.shrink2(vec2(margin, margin * 0.7));
    let title_height = body * 2.0;
    heading(app, ui, Rect::from_min_size(inner.min, vec2(inner.width(), title_height)), body);

    let foot = body * 1.5;
    let look = Look { text: body * 0.78, titles: false };
    let bytes = bytes(app);
    let ruler = match &app.pictures {
        _ if bytes => body * 7.4,
        Some(pictures) => pictures.ruler_line_height(&look),
        None => 0.0,
    };
    let side = (inner.width() * 0.3).max(body * 11.0);
    let top = inner.top() + title_height;
    let bottom = inner.bottom() - foot - ruler;
    let space = Rect::from_min_max(pos2(inner.left(), top), pos2(inner.right() - side - body, bottom));
    let words = Rect::from_min_max(pos2(inner.right() - side, top + body * 0.4), pos2(inner.right(), bottom));
    let line = Rect::from_min_max(pos2(inner.left(), bottom), pos2(inner.right(), bottom + ruler));

    let mut under = stage_pane::stage(app, ui, space, false, body / 19.0);
    if ruler > 0.0 {
        under = figure(app, ui, if bytes { Pane::Bytes } else { Pane::RulerLine }, line, &look).or(under);
    }
    under = side_page(app, ui, words, body).or(under);
    footer(app, ui, Rect::from_min_max(pos2(inner.left(), inner.bottom() - foot), inner.max), body);
    app.hover(ui, under);
}

fn heading(app: &App, ui: &Ui, rect: Rect, body: f32) {
    let Some(slide) = app.state.slide() else { return };
    let at = rect.left_center();
    caption(ui.painter(), at, Align2::LEFT_CENTER, &slide.title, Face::Bold, body * 1.35, Role::Text, app.theme);
    let section = format!("{} · {}", slide.section_title(), slide.numbers_text());
    caption(
        ui.painter(),
        rect.right_center(),
        Align2::RIGHT_CENTER,
        &section,
        Face::Regular,
        body * 0.68,
        Role::Quiet,
        app.theme,
    );
}

fn footer(app: &mut App, ui: &mut Ui, rect: Rect, body: f32) {
    let Some(pictures) = &app.pictures else { return };
    let (playback, step) = (&pictures.playback, app.state.view.step);
    let tally = playback.reel().still(&pictures.instant).tally();
    let says = format!("step {step} of {} · {tally}", playback.steps().last());
    caption(
        ui.painter(),
        rect.left_center(),
        Align2::LEFT_CENTER,
        &says,
        Face::Regular,
        body * 0.68,
        Role::Quiet,
        app.theme,
    );
    let back = ui.allocate_rect(Rect::from_min_max(rect.right_top() - vec2(body * 9.0, 0.0), rect.max), Sense::click());
    back.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, "Back to the study page"));
    let role = if back.hovered() { Role::Here } else { Role::Quiet };
    caption(
        ui.painter(),
        rect.right_center(),
        Align2::RIGHT_CENTER,
        "F5 back to study",
        Face::Regular,
        body * 0.55,
        role,
        app.theme,
    );
    if back.clicked() {
        app.state.apply(Command::Present);
    }
}

/// The question or what the beat says, then the stack.
fn side_page(app: &mut App, ui: &mut Ui, rect: Rect, body: f32) -> Option<Place> {
    let has_stack = app.pictures.as_ref().is_some_and(|pictures| pictures.has(Pane::StackHere));
    let mut child = ui.new_child(egui::UiBuilder::new().max_rect(rect));
    child.set_clip_rect(rect.expand(4.0));
    let words = egui::ScrollArea::vertical().id_salt("presented").show(&mut child, |ui| said(app, ui, body));
    if let Some(command) = words.inner {
        app.run(ui, command);
    }
    // The stack has what the words leave, up to four rows.
    let look = Look { text: body * 0.62, titles: false };
    let stack = (rect.height() - words.content_size.y - body * 0.4).min(stack_height(4, &look));
    if !has_stack || stack < stack_height(1, &look) {
        return None;
    }
    figure(app, ui, Pane::StackHere, Rect::from_min_max(pos2(rect.left(), rect.bottom() - stack), rect.max), &look)
}

fn said(app: &mut App, ui: &mut Ui, body: f32) -> Option<Command> {
    let state = &app.state;
    let prose = Prose { theme: app.theme, size: body, role: Role::Text, face: Face::Regular };
    if let Some(posed) = state.question() {
        let strong = Prose { face: Face::Medium, size: body * 1.1, ..prose };
        strong.show(ui, &mut app.formulas, &question::question_text(state, posed));
        ui.add_space(body * 0.4);
        let wrong = state.answered.filter(|answered| answered.beat == posed.beat && !answered.right);
        let asked = big_answers(app, ui, posed, wrong.map(|answered| answered.choice), body);
        if let Some(answered) = wrong {
            ui.add_space(body * 0.3);
            let reason = question::reason(state, posed, &posed.choices[answered.choice]);
            Prose { role: Role::Wrong, ..prose }.show(ui, &mut app.formulas, &reason);
        }
        return asked;
    }
    if let Some((posed, answered)) = state.settled() {
        let text = format!("**{}**", question::label(&posed.choices[answered.choice]));
        Prose { role: Role::Hit, size: body * 1.1, ..prose }.show(ui, &mut app.formulas, &text);
    }
    let event = state.playback().and_then(|playback| playback.event(state.view.step));
    let opening = state.slide().map_or("", |slide| beginning(slide.plays));
    match state.beat().filter(|(_, step)| *step == state.view.step) {
        Some((beat, _)) => {
            ui.label(RichText::new(&beat.title).font(font(Face::Medium, body * 1.1)).color(ink(app.theme, Role::Text)));
            if let Some(event) = event {
                prose.show(ui, &mut app.formulas, &told(&beat.text(&event, state.view.stage), &event));
            }
        }
        None => {
            let says = state.playback().zip(event);
            let says = says.map(|(playback, event)| sentence(&event, playback.reel().volume()));
            let says = says.unwrap_or_else(|| opening.to_owned());
            Prose { size: body * 1.05, ..prose }.show(ui, &mut app.formulas, &says);
        }
    }
    None
}

/// The answers in large letters.
fn big_answers(
    app: &App,
    ui: &mut Ui,
    posed: &super::playback::Posed,
    wrong: Option<usize>,
    body: f32,
) -> Option<Command> {
    let mut asked = None;
    for (index, choice) in posed.choices.iter().enumerate() {
        let letter = char::from(b'A' + index.min(25) as u8);
        let role = if wrong == Some(index) { Role::Wrong } else { Role::Here };
        let name = super::markdown::plain(&question::label(choice));
        let text = RichText::new(format!("{letter}   {name}"))
            .font(font(Face::Medium, body))
            .color(ink(app.theme, Role::Text));
        let button = egui::Button::new(text)
            .fill(fill(app.theme, Role::Panel))
            .stroke(egui::Stroke::new(2.0, ink(app.theme, role)))
            .corner_radius(body * 0.3)
            .min_size(vec2(ui.available_width(), body * 1.65));
        if Frame::new().show(ui, |ui| ui.add(button)).inner.clicked() {
            asked = Some(Command::Answer(index as u8));
        }
    }
    asked
}
