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
    /// How many stood there when the strip was drawn last: it is as high as they were then.
    drawn: usize,
}

struct Notice {
    says: String,
    /// Until when it stays, in seconds; nothing: until it is closed.
    until: Option<f64>,
}

impl Notices {
    /// Shows a message for a while.
    pub(crate) fn say(&mut self, context: &egui::Context, says: impl Into<String>) {
        let until = Some(context.time() + STAYS);
        self.add(says.into(), until);
    }

    /// Shows a message until it is closed: what went wrong is not over when nobody looked.
    pub(crate) fn keep(&mut self, says: impl Into<String>) {
        self.add(says.into(), None);
    }

    /// Takes back a message: what it tells of is mended.
    pub(crate) fn take_back(&mut self, says: &str) {
        self.shown.retain(|other| other.says != says);
    }

    fn add(&mut self, says: String, until: Option<f64>) {
        self.take_back(&says);
        self.shown.push(Notice { says, until });
        while self.shown.len() > MOST {
            // What would go by itself goes first.
            let first = self.shown.iter().position(|notice| notice.until.is_some()).unwrap_or(0);
            self.shown.remove(first);
        }
    }

    /// Shows the strip at the foot of `ui`, while there is anything to say.
    pub(super) fn strip(&mut self, ui: &mut Ui, theme: &Theme) {
        let now = ui.ctx().time();
        self.shown.retain(|notice| notice.until.is_none_or(|until| until > now));
        if std::mem::replace(&mut self.drawn, self.shown.len()) != self.shown.len() {
            ui.ctx().request_repaint();
        }
        if self.shown.is_empty() {
            return;
        }
        if self.shown.iter().any(|notice| notice.until.is_some()) {
            ui.ctx().request_repaint_after_secs(0.5);
        }
        let frame = Frame::new().fill(fill(theme, Role::Panel)).inner_margin(Margin::symmetric(22, 10));
        let panel = Panel::bottom("notices").frame(frame).resizable(false).max_size(ui.available_height() * 0.6);
        let mut closed = None;
        panel.show(ui, |ui| {
            for (index, notice) in self.shown.iter().enumerate() {
                // What stays until it is closed has the colour of what is wrong.
                let role = if notice.until.is_some() { Role::Here } else { Role::Wrong };
                let frame = Frame::new().stroke(line(theme, role)).corner_radius(6.0);
                frame.inner_margin(Margin::symmetric(10, 6)).show(ui, |ui| {
                    ui.with_layout(Layout::right_to_left(Align::TOP), |ui| {
                        if icon_button(ui, Icon::Close, "Close the message", "Close", false, 20.0).clicked() {
                            closed = Some(index);
                        }
                        ui.with_layout(Layout::top_down(Align::Min), |ui| {
                            ui.add(
                                Label::new(RichText::new(quoted(&notice.says)).color(ink(theme, Role::Text))).wrap(),
                            );
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

/// What a sentence quotes as code, in quotes: here all letters are alike.
fn quoted(says: &str) -> String {
    let mut quotes = ['“', '”'].into_iter().cycle();
    says.chars().map(|letter| if letter == '`' { quotes.next().unwrap_or(letter) } else { letter }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn code_stands_in_quotes() {
        assert_eq!(quoted("`theme` is no `x`: 1"), "“theme” is no “x”: 1");
    }

    #[test]
    fn what_went_wrong_stays_and_the_rest_makes_room() {
        let context = egui::Context::default();
        let check = |says: &[&str], shown: &[&str]| {
            let mut notices = Notices::default();
            for says in says {
                match says.strip_prefix('!') {
                    Some(wrong) => notices.keep(wrong),
                    None => notices.say(&context, *says),
                }
            }
            let now: Vec<&str> = notices.shown.iter().map(|notice| notice.says.as_str()).collect();
            assert_eq!(now, shown);
        };
        check(&["a", "b", "a"], &["b", "a"]);
        check(&["!w", "a", "b", "c", "d"], &["w", "b", "c", "d"]);
        check(&["!v", "!w", "!x", "!y", "!z"], &["w", "x", "y", "z"]);
        check(&["!v", "a", "!v"], &["a", "v"]);
    }
}
