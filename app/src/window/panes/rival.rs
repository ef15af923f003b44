//! The strip over the second picture: what it shows, and how it keeps in step.

use egui::{Align, ComboBox, Layout, PopupCloseBehavior, Rect, RichText, Ui, vec2};
use raystep_accel::Rule;
use raystep_figure::{Face, Role};

use super::page::{Asked, Page};
use crate::shown::beside::{Beside, Pace, Rivals};
use crate::shown::kind_name::kind_name;
use crate::shown::state::State;
use crate::window::look::controls;
use crate::window::look::fonts::font;
use crate::window::look::visuals::ink;

/// Whether a strip has no room for how it keeps in step: that then stands over the first picture.
pub(super) fn narrow(rect: Rect) -> bool {
    rect.width() < 272.0
}

/// How it keeps in step, at the right end of the strip over the first picture; says where that begins.
pub(super) fn pace_apart(ui: &mut Ui, page: Page<'_>, rect: Rect, asked: &mut Vec<Asked>) -> f32 {
    let inner = rect.shrink2(vec2(12.0, 3.0));
    let builder = egui::UiBuilder::new().max_rect(inner).layout(Layout::right_to_left(Align::Center));
    let mut child = ui.new_child(builder.scope_id(egui::Id::unique("pace strip")));
    asked.extend(pace(&mut child, page.state.pace, 84.0).map(Asked::Pace));
    child.min_rect().left()
}

/// Shows the strip; what is chosen is asked for.
pub(super) fn choice(ui: &mut Ui, page: Page<'_>, rect: Rect, asked: &mut Vec<Asked>) {
    let inner = rect.shrink2(vec2(12.0, 3.0));
    // The strip is the same one wherever it stands: a drop-down that is open stays open.
    let builder = egui::UiBuilder::new().max_rect(inner).layout(Layout::right_to_left(Align::Center));
    let mut child = ui.new_child(builder.scope_id(egui::Id::unique("rivals strip")));
    let state = page.state;
    if matches!(state.beside, Beside::Abreast(_)) {
        child.label(RichText::new("all at the same t").color(ink(page.theme, Role::Quiet)));
    } else if !narrow(rect) {
        asked.extend(pace(&mut child, state.pace, 112.0).map(Asked::Pace));
    }
    let flat = state.playback().is_some_and(|playback| playback.play.scene.flat);
    child.with_layout(Layout::left_to_right(Align::Center), |ui| match state.beside {
        Beside::Structure(kind) if flat => asked.extend(several(ui, state, Rivals::of([kind])).map(Asked::Abreast)),
        Beside::Abreast(rivals) => {
            ui.label(RichText::new("Beside it").font(font(Face::Bold, 13.5)));
            asked.extend(several(ui, state, rivals).map(Asked::Abreast));
        }
        Beside::Structure(kind) => asked.extend(structures(ui, state, kind).map(Asked::Compare)),
        Beside::Mistake(_) => {
            ui.add(egui::Label::new(RichText::new(title(state)).font(font(Face::Bold, 13.5))).truncate());
        }
        Beside::Nothing => {}
    });
}

/// What the second picture shows, in words: a structure, or the mistake that is made in it.
pub(super) fn title(state: &State) -> &'static str {
    match state.beside {
        Beside::Structure(kind) => kind_name(kind),
        Beside::Mistake(index) => {
            let mistakes = state.playback().map_or(&[][..], |playback| &playback.mistakes);
            mistakes.get(index).map_or("", |mistake| mistake.title())
        }
        Beside::Nothing | Beside::Abreast(_) => "",
    }
}

/// The structures that this one can be compared with.
pub(super) fn structures(ui: &mut Ui, state: &State, now: &'static str) -> Option<&'static str> {
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

/// Up to three structures that this one can be compared with.
fn several(ui: &mut Ui, state: &State, now: Rivals) -> Option<Rivals> {
    let mut chosen = None;
    let own = state.playback().map_or("", |playback| playback.rule.kind());
    let names: Vec<&str> = now.kinds().map(kind_name).collect();
    let text = RichText::new(names.join(", ")).font(font(Face::Bold, 13.5));
    let combo =
        ComboBox::from_id_salt("rivals").width(112.0_f32.min(ui.available_width())).selected_text(text).truncate();
    let combo = combo.close_behavior(PopupCloseBehavior::CloseOnClickOutside).show_ui(ui, |ui| {
        for kind in Rule::KINDS.into_iter().filter(|kind| *kind != own) {
            let mut on = now.has(kind);
            let room = on || now.count() < Rivals::MOST;
            let only = on && now.count() == 1;
            let check = ui.add_enabled_ui(room && !only, |ui| controls::tick(ui, &mut on, kind_name(kind))).inner;
            if check.on_disabled_hover_text("From one to three stand beside it").changed() {
                chosen = Some(if on { now.with(kind) } else { now.without(kind) });
            }
        }
    });
    controls::name(&combo.response, "Compare with up to three");
    chosen
}

/// In step by event, or by t.
fn pace(ui: &mut Ui, now: Pace, width: f32) -> Option<Pace> {
    let mut chosen = None;
    let names = [(Pace::Event, "step by step"), (Pace::T, "at the same t")];
    let shown = names.iter().find(|(pace, _)| *pace == now).map_or("", |(_, name)| name);
    let combo = ComboBox::from_id_salt("pace").width(width).selected_text(shown).show_ui(ui, |ui| {
        for (pace, name) in names {
            if ui.selectable_label(pace == now, name).clicked() {
                chosen = Some(pace);
            }
        }
    });
    controls::name(&combo.response, "Keep in step");
    chosen
}
