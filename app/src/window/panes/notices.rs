//! Short messages at the foot of the window.

use egui::{Align2, Area, Frame, Id, Order, RichText, Ui, vec2};
use raystep_figure::{Role, Theme};

use crate::window::look::visuals::{fill, ink, line};

/// For how many seconds a message stays.
const STAYS: f64 = 6.0;

/// The messages that are shown.
#[derive(Default)]
pub(super) struct Toasts {
    shown: Vec<(String, f64)>,
}

impl Toasts {
    /// Shows a message from now on.
    pub(super) fn say(&mut self, ui: &Ui, message: impl Into<String>) {
        let until = ui.ctx().time() + STAYS;
        let message = message.into();
        self.shown.retain(|(other, _)| *other != message);
        self.shown.push((message, until));
        self.shown.truncate(4);
    }

    /// Draws the messages that are not over yet.
    pub(super) fn show(&mut self, ui: &Ui, theme: &Theme) {
        let now = ui.ctx().time();
        self.shown.retain(|(_, until)| *until > now);
        if self.shown.is_empty() {
            return;
        }
        ui.ctx().request_repaint_after_secs(0.5);
        let area =
            Area::new(Id::unique("toasts")).order(Order::Foreground).anchor(Align2::CENTER_BOTTOM, vec2(0.0, -92.0));
        area.interactable(false).show(ui.ctx(), |ui| {
            ui.set_max_width(620.0);
            for (message, _) in &self.shown {
                let frame = Frame::new().fill(fill(theme, Role::Panel)).stroke(line(theme, Role::Here));
                frame.corner_radius(7.0).inner_margin(12.0).show(ui, |ui| {
                    ui.label(RichText::new(message).color(ink(theme, Role::Text)));
                });
            }
        });
    }
}
