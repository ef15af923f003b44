//! Short messages, in a strip of their own at the foot of the lesson: they cover nothing.

use egui::{Align, Frame, Label, Layout, Margin, Panel, RichText, Ui};
use raystep_figure::{Role, Theme};

use crate::window::look::icons::{Icon, icon_button};
use crate::window::look::visuals::{fill, ink, line};

/// For how many seconds a message stays.
const STAYS: f64 = 6.0;

/// The most messages that are shown at a time.
const MOST: usize = 4;

/// The messages that are shown.
#[derive(Default)]
pub(crate) struct Notices {
    shown: Vec<Notice>,
}

struct Notice {
    says: String,
    /// Until when it stays; nothing: until it is closed.
    until: Option<f64>,
}

impl Notices {
    /// Shows a message for a while.
    pub(crate) fn say(&mut self, ui: &Ui, says: impl Into<String>) {
        let until = Some(ui.ctx().time() + STAYS);
        self.add(says.into(), until);
    }

    fn add(&mut self, says: String, until: Option<f64>) {
        self.shown.retain(|other| other.says != says);
        self.shown.push(Notice { says, until });
        let many = self.shown.len().saturating_sub(MOST);
        self.shown.drain(..many);
    }

    /// Shows the strip at the foot of `ui`, while there is anything to say.
    pub(super) fn strip(&mut self, ui: &mut Ui, theme: &Theme) {
        let now = ui.ctx().time();
        self.shown.retain(|notice| notice.until.is_none_or(|until| until > now));
        if self.shown.is_empty() {
            return;
        }
        ui.ctx().request_repaint_after_secs(0.5);
        let frame = Frame::new().fill(fill(theme, Role::Panel)).inner_margin(Margin::symmetric(22, 10));
        let panel = Panel::bottom("notices").frame(frame).resizable(false).max_size(ui.available_height() * 0.6);
        let mut closed = None;
        panel.show(ui, |ui| {
            for (index, notice) in self.shown.iter().enumerate() {
                let frame = Frame::new().stroke(line(theme, Role::Here)).corner_radius(6.0);
                frame.inner_margin(Margin::symmetric(10, 6)).show(ui, |ui| {
                    ui.with_layout(Layout::right_to_left(Align::TOP), |ui| {
                        if icon_button(ui, Icon::Close, "Close", "Close", false, 20.0).clicked() {
                            closed = Some(index);
                        }
                        ui.with_layout(Layout::top_down(Align::Min), |ui| {
                            ui.add(Label::new(RichText::new(&notice.says).color(ink(theme, Role::Text))).wrap());
                        });
                    });
                });
            }
        });
        if let Some(index) = closed {
            self.shown.remove(index);
        }
    }
}
