//! The page of keys and of what the mouse does.

use egui::{Grid, RichText, ScrollArea, Ui};
use raystep_figure::{Face, Role, Theme};

use super::command::{Command, ENTRIES};
use super::controls;
use super::fonts::font;
use super::visuals::ink;

/// What the mouse does.
const MOUSE: &[(&str, &str)] = &[
    ("Hover", "lights up the same place in every view"),
    ("Click", "picks a node, a cell or a primitive and goes to where the walk meets it"),
    ("Drag the ray's ends", "moves the ray"),
    ("Shift + drag", "shoots a ray of your own"),
    ("Drag", "turns the view; in a flat scene it shifts it"),
    ("Right or middle drag", "shifts the view"),
    ("Wheel", "comes nearer"),
];

/// Shows the page; says whether it shall close.
pub(super) fn page(ui: &Ui, theme: &Theme) -> bool {
    let modal = controls::modal(ui, "help").show(ui.ctx(), |ui| {
        ui.set_width(620.0);
        ui.label(RichText::new(Command::Help.name()).font(font(Face::Bold, 20.0)));
        let height = (ui.ctx().content_rect().height() - 170.0).clamp(200.0, 640.0);
        ScrollArea::vertical().max_height(height).auto_shrink([false, true]).show(ui, |ui| {
            Grid::new("keys").num_columns(2).spacing([24.0, 6.0]).show(ui, |ui| {
                let row = |ui: &mut Ui, left: &str, right: &str| {
                    ui.label(RichText::new(left).font(font(Face::Mono, 12.5)).color(ink(theme, Role::Here)));
                    ui.label(right);
                    ui.end_row();
                };
                // The nine speeds and the four answers share a line each.
                let single = |entry: &&super::command::Entry| {
                    !entry.keys.is_empty() && !matches!(entry.command, Command::Speed(_) | Command::Answer(_))
                };
                for entry in ENTRIES.iter().filter(single) {
                    row(ui, &entry.keys_text(), entry.name);
                }
                row(ui, "1 … 9", "Speed of playing");
                row(ui, "A B C D", "Answer the open question");
                row(ui, "Esc", "Let go of a field, close what is open");
                for (left, right) in MOUSE {
                    row(ui, left, right);
                }
            });
        });
        ui.add_space(6.0);
        ui.button("Close").clicked()
    });
    modal.should_close() || modal.inner
}
