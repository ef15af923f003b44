//! The presenter's page: title, space, the ruler, the question or what is said, and the stack in words.

use egui::{Align2, Frame, Rect, RichText, Sense, Ui, pos2, vec2};
use raystep_accel::Place;
use raystep_figure::{Face, Look, Role, Theme, sentence, stack_height};
use raystep_lesson::Medium;

use super::columns::bytes;
use super::figure::figure;
use super::lesson::offers;
use super::page::{Asked, Kept, Page};
use super::stage;
use crate::shown::command::Command;
use crate::shown::pictures::{Pane, Pictures};
use crate::shown::playback::Posed;
use crate::shown::reel::{beginning, said as said_by};
use crate::shown::words::{label, question_text, reason};
use crate::window::look::fonts::font;
use crate::window::look::formulas::Formulas;
use crate::window::look::markdown::plain;
use crate::window::look::painter::caption;
use crate::window::look::prose::Prose;
use crate::window::look::visuals::{fill, ink};

/// Shows the page in the whole window; says which place the pointer is on.
pub(crate) fn page(ui: &mut Ui, page: Page<'_>, kept: &mut Kept, asked: &mut Vec<Asked>) -> Option<Place> {
    ui.painter().rect_filled(ui.max_rect(), 0.0, fill(page.theme, Role::Page));
    kept.notices.strip(ui, page.theme);
    let rect = ui.available_rect_before_wrap();
    // Everything follows from the height: body text is a twenty-eighth of it or larger.
    let body = (rect.height() / 27.0).clamp(16.0, 64.0).min(rect.width() / 44.0);
    let margin = body * 1.4;
    let inner = rect.shrink2(vec2(margin, margin * 0.7));
    let title_height = body * 2.0;
    heading(ui, page, Rect::from_min_size(inner.min, vec2(inner.width(), title_height)), body);

    let foot = body * 1.5;
    let look = Look { text: body * 0.78, titles: false };
    let bytes = bytes(page.state);
    let ruler = match &kept.pictures {
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

    let mut under = stage::stage(ui, page, kept, space, false, body / 19.0, asked);
    if ruler > 0.0 {
        let pane = if bytes { Pane::Bytes } else { Pane::RulerLine };
        under = figure(ui, page, kept, pane, line, &look, asked).or(under);
    }
    under = side_page(ui, page, kept, words, body, asked).or(under);
    let foot = Rect::from_min_max(pos2(inner.left(), inner.bottom() - foot), inner.max);
    if let Some(pictures) = &kept.pictures
        && footer(ui, page, pictures, foot, body)
    {
        asked.push(Asked::Command(Command::Present));
    }
    under
}

fn heading(ui: &Ui, page: Page<'_>, rect: Rect, body: f32) {
    let Some(slide) = page.state.slide() else { return };
    let at = rect.left_center();
    caption(ui.painter(), at, Align2::LEFT_CENTER, &slide.title, Face::Bold, body * 1.35, Role::Text, page.theme);
    let section = format!("{} · {}", slide.section_title(), slide.numbers_text());
    caption(
        ui.painter(),
        rect.right_center(),
        Align2::RIGHT_CENTER,
        &section,
        Face::Regular,
        body * 0.68,
        Role::Quiet,
        page.theme,
    );
}

/// Shows what has been done so far, and the way back; says whether that was taken.
fn footer(ui: &mut Ui, page: Page<'_>, pictures: &Pictures, rect: Rect, body: f32) -> bool {
    let (playback, step) = (&pictures.playback, page.state.view.step);
    let tally = pictures.tally();
    let says = format!("step {step} of {} · {tally}", playback.steps().last());
    caption(
        ui.painter(),
        rect.left_center(),
        Align2::LEFT_CENTER,
        &says,
        Face::Regular,
        body * 0.68,
        Role::Quiet,
        page.theme,
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
        page.theme,
    );
    back.clicked()
}

/// The question or what the beat says, then the stack.
fn side_page(
    ui: &mut Ui,
    page: Page<'_>,
    kept: &mut Kept,
    rect: Rect,
    body: f32,
    asked: &mut Vec<Asked>,
) -> Option<Place> {
    let has_stack = kept.pictures.as_ref().is_some_and(|pictures| pictures.has(Pane::StackHere));
    let mut child = ui.new_child(egui::UiBuilder::new().max_rect(rect));
    child.set_clip_rect(rect.expand(4.0));
    let words = egui::ScrollArea::vertical()
        .id_salt("presented")
        .show(&mut child, |ui| said(ui, page, &mut kept.formulas, body));
    asked.extend(words.inner.map(Asked::Command));
    // The stack has what the words leave, up to four rows.
    let look = Look { text: body * 0.62, titles: false };
    let stack = (rect.height() - words.content_size.y - body * 0.4).min(stack_height(4, &look));
    if !has_stack || stack < stack_height(1, &look) {
        return None;
    }
    let stack = Rect::from_min_max(pos2(rect.left(), rect.bottom() - stack), rect.max);
    figure(ui, page, kept, Pane::StackHere, stack, &look, asked)
}

fn said(ui: &mut Ui, page: Page<'_>, formulas: &mut Formulas, body: f32) -> Option<Command> {
    let Page { state, theme, .. } = page;
    let prose = Prose { theme, size: body, role: Role::Text, face: Face::Regular };
    if let Some(posed) = state.question() {
        let strong = Prose { face: Face::Medium, size: body * 1.1, ..prose };
        strong.show(ui, formulas, &question_text(state, posed));
        ui.add_space(body * 0.4);
        let wrong = state.answered.filter(|answered| answered.beat == posed.beat && !answered.right);
        let asked = big_answers(ui, theme, posed, wrong.map(|answered| answered.choice), body);
        if let Some(answered) = wrong {
            ui.add_space(body * 0.3);
            let reason = reason(state, posed, &posed.choices[answered.choice]);
            Prose { role: Role::Wrong, ..prose }.show(ui, formulas, &reason);
        }
        return asked;
    }
    if let Some((posed, answered)) = state.settled() {
        let text = format!("**{}**", label(&posed.choices[answered.choice]));
        Prose { role: Role::Hit, size: body * 1.1, ..prose }.show(ui, formulas, &text);
    }
    let event = state.playback().and_then(|playback| playback.event(state.view.step));
    let opening = state.slide().map_or("", |slide| beginning(slide.plays));
    match state.beat().filter(|(_, step)| *step == state.view.step) {
        Some((beat, step)) => {
            ui.label(RichText::new(&beat.title).font(font(Face::Medium, body * 1.1)).color(ink(theme, Role::Text)));
            if let Some(playback) = state.playback() {
                prose.show(ui, formulas, &said_by(beat, &playback.play, step, Medium::Window));
            }
            return offers(ui, state, body * 0.8);
        }
        None => {
            let says = state.playback().zip(event);
            let says = says.map(|(playback, event)| sentence(&event, playback.reel().volume()));
            let says = says.unwrap_or_else(|| opening.to_owned());
            Prose { size: body * 1.05, ..prose }.show(ui, formulas, &says);
        }
    }
    None
}

/// The answers in large letters.
fn big_answers(ui: &mut Ui, theme: &Theme, posed: &Posed, wrong: Option<usize>, body: f32) -> Option<Command> {
    let mut asked = None;
    for (index, choice) in posed.choices.iter().enumerate() {
        let letter = char::from(b'A' + index.min(25) as u8);
        let role = if wrong == Some(index) { Role::Wrong } else { Role::Here };
        let name = plain(&label(choice));
        let text =
            RichText::new(format!("{letter}   {name}")).font(font(Face::Medium, body)).color(ink(theme, Role::Text));
        let button = egui::Button::new(text)
            .fill(fill(theme, Role::Panel))
            .stroke(egui::Stroke::new(2.0, ink(theme, role)))
            .corner_radius(body * 0.3)
            .min_size(vec2(ui.available_width(), body * 1.65));
        if Frame::new().show(ui, |ui| ui.add(button)).inner.clicked() {
            asked = Some(Command::Answer(index as u8));
        }
    }
    asked
}
