//! A small bar at the first page: to go on where the window stood the last time.

use egui::{Button, Frame, Margin, Panel, RichText, Ui};
use raystep_figure::{Face, Role, Theme};

use crate::window::look::fonts::font;
use crate::window::look::icons::{Icon, icon_button};
use crate::window::look::visuals::{ink, tinted};

/// What was chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Chosen {
    /// To go on.
    GoOn,
    /// To begin here.
    Begin,
}

/// Shows the bar above the page; says what was chosen.
pub(crate) fn bar(ui: &mut Ui, place: &str, theme: &Theme) -> Option<Chosen> {
    let frame = Frame::new().fill(tinted(theme)).inner_margin(Margin::symmetric(16, 5));
    let panel = Panel::top("go on").frame(frame).resizable(false);
    panel
        .show(ui, |ui| {
            let mut chosen = None;
            ui.horizontal(|ui| {
                let text = RichText::new(format!("Go on at {place}?")).font(font(Face::Medium, 14.5));
                ui.add(egui::Label::new(text.color(ink(theme, Role::Text))).truncate());
                let button = Button::new("Go on").right_text(RichText::new("Enter").font(font(Face::Mono, 12.0)));
                if ui.add(button).clicked() {
                    chosen = Some(Chosen::GoOn);
                }
                if icon_button(ui, Icon::Close, "Begin here", "Begin here", false, 22.0).clicked() {
                    chosen = Some(Chosen::Begin);
                }
            });
            chosen
        })
        .inner
}
