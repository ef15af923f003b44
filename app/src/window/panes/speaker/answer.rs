//! The right answer to the question that is open, or that comes next on this slide, before anybody has given it.

use egui::{Align2, Frame, Margin, Rect, ScrollArea, Stroke, StrokeKind, Ui, UiBuilder, vec2};
use raystep_figure::{Face, Role};

use super::desk::Desk;
use crate::shown::playback::Posed;
use crate::shown::state::State;
use crate::shown::words::{label, question_text, reason};
use crate::window::look::markdown::plain;
use crate::window::look::painter::caption;
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
        ScrollArea::vertical().id_salt("answer").auto_shrink(false).show(ui, |ui| {
            ui.set_width(ui.available_width());
            let prose = Prose { theme, size: 14.5, role: Role::Text, face: Face::Regular, leading: 1.35 };
            let head = if open { "Right answer, only you see it" } else { "The next question's answer" };
            Prose { role, face: Face::Bold, size: 13.0, ..prose }.show(ui, &mut kept.formulas, head);
            if !open {
                Prose { role: Role::Quiet, ..prose }.show(ui, &mut kept.formulas, &question_text(state, posed));
            }
            let (place, _) = ui.allocate_exact_size(vec2(ui.available_width(), 30.0), egui::Sense::hover());
            let letter = char::from(b'A' + right.min(25) as u8);
            let says = format!("{letter}   {}", plain(&label(&posed.choices[right])));
            caption(ui.painter(), place.left_center(), Align2::LEFT_CENTER, &says, Face::Bold, 19.0, role, theme);
            for (index, choice) in posed.choices.iter().enumerate().filter(|(index, _)| *index != right) {
                let letter = char::from(b'A' + index.min(25) as u8);
                let text = format!("{letter}, {}: {}", label(choice), reason(state, posed, choice));
                Prose { role: Role::Wrong, ..prose }.show(ui, &mut kept.formulas, &text);
            }
        });
    });
}
