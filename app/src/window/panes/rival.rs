//! The strip over the second picture: what it shows, and how it keeps in step.

use egui::{Align, ComboBox, Layout, Rect, RichText, Ui, vec2};
use raystep_accel::Rule;
use raystep_figure::Face;

use super::page::{Asked, Page};
use crate::shown::beside::{Beside, Pace};
use crate::shown::kind_name::kind_name;
use crate::shown::state::State;
use crate::window::look::controls;
use crate::window::look::fonts::font;

/// Shows the strip; what is chosen is asked for.
pub(super) fn choice(ui: &mut Ui, page: Page<'_>, rect: Rect, asked: &mut Vec<Asked>) {
    let inner = rect.shrink2(vec2(12.0, 3.0));
    let mut child = ui.new_child(egui::UiBuilder::new().max_rect(inner).layout(Layout::right_to_left(Align::Center)));
    let state = page.state;
    asked.extend(pace(&mut child, state.pace).map(Asked::Pace));
    child.with_layout(Layout::left_to_right(Align::Center), |ui| match state.beside {
        Beside::Structure(kind) => asked.extend(structures(ui, state, kind).map(Asked::Compare)),
        Beside::Mistake(index) => {
            let mistakes = state.playback().map_or(&[][..], |playback| &playback.mistakes);
            let title = mistakes.get(index).map_or("", |mistake| mistake.title());
            ui.add(egui::Label::new(RichText::new(title).font(font(Face::Bold, 13.5))).truncate());
        }
        Beside::Nothing => {}
    });
}

/// The structures that this one can be compared with.
fn structures(ui: &mut Ui, state: &State, now: &'static str) -> Option<&'static str> {
    let mut chosen = None;
    let own = state.playback().map_or("", |playback| playback.rule.kind());
    let text = RichText::new(kind_name(now)).font(font(Face::Bold, 13.5));
    let combo = ComboBox::from_id_salt("rival").width(112.0).selected_text(text).show_ui(ui, |ui| {
        for kind in Rule::KINDS.into_iter().filter(|kind| *kind != own && *kind != "slab") {
            if ui.selectable_label(kind == now, kind_name(kind)).clicked() {
                chosen = Some(kind);
            }
        }
    });
    controls::name(&combo.response, "Compare with");
    chosen
}

/// In step by event, or by t.
fn pace(ui: &mut Ui, now: Pace) -> Option<Pace> {
    let mut chosen = None;
    let names = [(Pace::Event, "step by step"), (Pace::T, "at the same t")];
    let shown = names.iter().find(|(pace, _)| *pace == now).map_or("", |(_, name)| name);
    let combo = ComboBox::from_id_salt("pace").width(112.0).selected_text(shown).show_ui(ui, |ui| {
        for (pace, name) in names {
            if ui.selectable_label(pace == now, name).clicked() {
                chosen = Some(pace);
            }
        }
    });
    controls::name(&combo.response, "Keep in step");
    chosen
}
