//! The right answer to the question that is open, or that comes next on this slide, before anybody has given it.

use egui::{Frame, Margin, Rect, ScrollArea, Stroke, StrokeKind, Ui, UiBuilder};
use raystep_figure::{Face, Role};

use super::desk::{Desk, more_below};
use crate::shown::playback::Posed;
use crate::shown::state::State;
use crate::shown::words::{label, question_text, reason};
use crate::window::look::prose::Prose;
use crate::window::look::visuals::{fill, ink};
use crate::window::panes::page::Kept;

/// The question that is open or was just answered, else the next one.
fn coming(state: &State) -> Option<(&Posed, bool)> {
    let open = state.question().or(state.settled().map(|(posed, _)| posed));
    let next = || {
        let posed = state.made().filter(|_| state.predict)?.posed.iter();
        posed.filter(|posed| posed.before >= state.view.step).min_by_key(|posed| posed.before)
    };
    open.map(|posed| (posed, true)).or_else(|| Some((next()?, false)))
}

/// Letters in parts of the usual ones: the first with which all has room.
const SCALES: [f32; 4] = [1.0, 0.92, 0.84, 0.78];

pub(super) fn card(ui: &mut Ui, desk: &Desk<'_>, kept: &mut Kept, rect: Rect) {
    let theme = desk.wall.theme;
    let state = desk.wall.state;
    let Some((posed, open)) = coming(state).filter(|_| rect.height() > 50.0) else { return };
    let Some(right) = posed.choices.iter().position(|choice| choice.right) else { return };
    let role = if open { Role::Hit } else { Role::Quiet };
    ui.painter().rect(rect, 8.0, fill(theme, Role::Panel), Stroke::new(1.5, ink(theme, role)), StrokeKind::Inside);
    let mut child = ui.new_child(UiBuilder::new().max_rect(rect));
    child.set_clip_rect(rect);
    Frame::new().inner_margin(Margin::symmetric(16, 10)).show(&mut child, |ui| {
        let prose = Prose { theme, size: 14.5, role: Role::Text, face: Face::Regular, leading: 1.35 };
        let head = if open { "Right answer, only you see it" } else { "The next question's answer" };
        let letter = |index: usize| char::from(b'A' + index.min(25) as u8);
        let answer = format!("{}   {}", letter(right), label(&posed.choices[right]));
        let question = question_text(state, posed);
        let wrong = posed.choices.iter().enumerate().filter(|(index, _)| *index != right);
        let wrong: Vec<String> = wrong
            .map(|(index, choice)| format!("{}, {}: {}", letter(index), label(choice), reason(state, posed, choice)))
            .collect();
        // The answer comes first, whole; what has no room below it is scrolled to.
        let parts = |scale: f32| {
            let set = |role: Role, face: Face, size: f32| Prose { role, face, size: size * scale, ..prose };
            let mut parts = vec![(set(role, Face::Bold, 13.0), head), (set(role, Face::Bold, 19.0), answer.as_str())];
            parts.extend((!open).then_some((set(Role::Quiet, Face::Regular, 14.5), question.as_str())));
            parts.extend(wrong.iter().map(|wrong| (set(Role::Wrong, Face::Regular, 14.5), wrong.as_str())));
            parts
        };
        let (wide, room) = (ui.available_width(), ui.available_height());
        let gap = ui.spacing().item_spacing.y;
        let high = |kept: &mut Kept, scale: f32| {
            let heights =
                parts(scale).into_iter().map(|(set, text)| set.height(ui, &mut kept.formulas, text, wide) + gap);
            heights.sum::<f32>() - gap
        };
        let scale = SCALES.into_iter().find(|scale| high(kept, *scale) <= room).unwrap_or(SCALES[SCALES.len() - 1]);
        let scrolled = ScrollArea::vertical().id_salt("answer").auto_shrink(false).show(ui, |ui| {
            ui.set_width(ui.available_width());
            for (set, text) in parts(scale) {
                set.show(ui, &mut kept.formulas, text);
            }
        });
        more_below(ui, desk, &scrolled, Role::Panel);
    });
}
