//! The page of keys and of what the mouse does, in two columns that fit the window.

use egui::{Grid, RichText, ScrollArea, Ui};
use raystep_figure::{Face, Role, Theme};

use crate::shown::command::{Command, Entry, QUARTERS};
use crate::window::look::controls;
use crate::window::look::fonts::font;
use crate::window::look::visuals::ink;

/// Some commands under a heading.
type Group = (&'static str, &'static [Command]);

/// The left column, then the right one. The nine speeds and the four answers share a line each.
const COLUMNS: [&[Group]; 2] = [
    &[
        (
            "The walk",
            &[
                Command::Play,
                Command::Speed(QUARTERS),
                Command::Next,
                Command::Previous,
                Command::NextCoarse,
                Command::PreviousCoarse,
                Command::First,
                Command::Last,
            ],
        ),
        ("Questions", &[Command::Predict, Command::Answer(0), Command::Skip]),
        (
            "Slides",
            &[
                Command::NextSlide,
                Command::PreviousSlide,
                Command::NextRay,
                Command::PreviousRay,
                Command::OtherStage,
                Command::Restore,
                Command::Undo,
                Command::Redo,
            ],
        ),
        (
            "The picture",
            &[
                Command::Compare,
                Command::Break,
                Command::Heat,
                Command::Frame,
                Command::ResetCamera,
                Command::Deeper,
                Command::Shallower,
                Command::WholeRay,
                Command::ResetScene,
                Command::Export,
                Command::Copy,
            ],
        ),
    ],
    &[(
        "The window",
        &[
            Command::ByHand,
            Command::Present,
            Command::Speaker,
            Command::FullScreen,
            Command::Open,
            Command::Cancel,
            Command::Palette,
            Command::Link,
            Command::ZoomIn,
            Command::ZoomOut,
            Command::ZoomReset,
            Command::Help,
        ],
    )],
];

/// What differs before a class.
const CLASS: &[Group] = &[
    (
        "The talk",
        &[Command::Onward, Command::Backward, Command::NextSlide, Command::PreviousSlide, Command::Type(b'0')],
    ),
    ("Questions", &[Command::Answer(0), Command::Skip]),
    ("The class's page", &[Command::Panes, Command::Black, Command::White, Command::Freeze]),
    ("In the hand", &[Command::Pointer, Command::Pen]),
    ("The speaker", &[Command::Speaker, Command::Notes, Command::Present]),
];

/// What the mouse does.
const MOUSE: &[(&str, &str)] = &[
    ("Hover", "lights up the same place in every view"),
    ("Click", "to the next time: place, line, sign"),
    ("Shift click", "to the time before"),
    ("Double click", "puts a node of the tree on top"),
    ("Ray's ends", "move the ray"),
    ("A shape, a plane", "in the hand: by a drag, or Tab and arrows"),
    ("Shift drag", "shoots a ray of your own"),
    ("Drag", "turns the view, or shifts a flat one"),
    ("Right drag", "shifts the view, as does the middle"),
    ("Wheel", "comes nearer; stretches the ruler of t"),
];

/// Shows the page of the study, or what differs before a class; says whether it shall close.
pub(super) fn page(ui: &Ui, theme: &Theme, class: &mut bool) -> bool {
    let modal = controls::modal(ui, "help").show(ui.ctx(), |ui| {
        ui.set_width(COLUMN * 2.0 + 28.0);
        ui.horizontal(|ui| {
            ui.label(RichText::new(Command::Help.name()).font(font(Face::Bold, 20.0)));
            ui.add_space(16.0);
            for (name, of_class) in [("In the study", false), ("Before a class", true)] {
                if ui.selectable_label(*class == of_class, name).clicked() {
                    *class = of_class;
                }
            }
        });
        let height = (ui.ctx().content_rect().height() - 130.0).max(200.0);
        let area = ScrollArea::vertical().min_scrolled_height(height).max_height(height).auto_shrink([false, true]);
        area.show(ui, |ui| {
            if *class {
                column(ui, CLASS, true, theme);
                ui.add_space(8.0);
                ui.label(
                    "All other keys are those of the study; digits are slides, not speeds, and letters no answers.",
                );
                return;
            }
            ui.horizontal_top(|ui| {
                ui.spacing_mut().item_spacing.x = 28.0;
                for (index, groups) in COLUMNS.into_iter().enumerate() {
                    ui.vertical(|ui| {
                        ui.set_width(COLUMN);
                        column(ui, groups, false, theme);
                        if index == 1 {
                            let rows = MOUSE.iter().map(|(left, right)| (*left, *right));
                            group(ui, "The mouse", rows, theme);
                        }
                    });
                }
            });
        });
        ui.add_space(4.0);
        ui.button("Close").clicked()
    });
    modal.should_close() || modal.inner
}

/// The width of a column.
const COLUMN: f32 = 410.0;

fn column(ui: &mut Ui, groups: &[Group], class: bool, theme: &Theme) {
    for (heading, commands) in groups {
        let rows: Vec<(String, &str)> =
            commands.iter().filter_map(|command| Some(row(command.entry()?, class))).collect();
        group(ui, heading, rows.iter().map(|(keys, name)| (keys.as_str(), *name)), theme);
    }
}

/// A command's keys and name, in the study or before a class.
fn row(entry: &Entry, class: bool) -> (String, &'static str) {
    // A plus between two keys would run into the signs beside it.
    let keys = if class { entry.presenting.join("  ") } else { entry.keys_text().to_owned() };
    let keys = keys.replace("Ctrl+", "Ctrl ").replace("Shift+", "Shift ");
    match entry.command {
        Command::Speed(_) => ("1 … 9".to_owned(), "Speed of playing"),
        Command::Answer(_) if class => ("Alt A … D".to_owned(), "Answer the open question"),
        Command::Answer(_) => ("A B C D".to_owned(), "Answer the open question"),
        Command::Type(_) => ("3 3 Enter".to_owned(), "Slide 33; as well 5/33"),
        Command::Cancel => (keys, "Cancel, close, let go of a field"),
        _ => (keys, entry.name),
    }
}

fn group<'a>(ui: &mut Ui, heading: &str, rows: impl Iterator<Item = (&'a str, &'a str)>, theme: &Theme) {
    ui.add_space(6.0);
    ui.label(RichText::new(heading).font(font(Face::Bold, 13.0)).color(ink(theme, Role::Quiet)));
    Grid::new(heading).num_columns(2).min_col_width(112.0).min_row_height(18.0).spacing([16.0, 4.0]).show(ui, |ui| {
        for (left, right) in rows {
            ui.label(RichText::new(left).font(font(Face::Mono, 12.5)).color(ink(theme, Role::Here)));
            ui.label(RichText::new(right).font(font(Face::Regular, 13.5)));
            ui.end_row();
        }
    });
}

#[cfg(test)]
mod tests {
    use raystep_figure::text_width;

    use super::*;
    use crate::shown::command::ENTRIES;

    #[test]
    fn what_the_mouse_does_is_not_cut_off() {
        for (left, right) in MOUSE {
            let first = text_width(left, Face::Mono, 12.5).max(112.0);
            let wide = first + 16.0 + text_width(right, Face::Regular, 13.5);
            assert!(wide <= COLUMN, "{right}: {wide}");
        }
    }

    #[test]
    fn every_key_stands_on_its_page_once() {
        let study = COLUMNS.iter().flat_map(|groups| groups.iter()).flat_map(|(_, all)| *all).collect::<Vec<_>>();
        let class = CLASS.iter().flat_map(|(_, all)| *all).collect::<Vec<_>>();
        let shown = |command| match command {
            Command::Speed(_) => Command::Speed(QUARTERS),
            Command::Answer(_) => Command::Answer(0),
            Command::Type(_) => Command::Type(b'0'),
            other => other,
        };
        for entry in ENTRIES {
            let times = |page: &[&Command]| page.iter().filter(|command| ***command == shown(entry.command)).count();
            if !entry.keys.is_empty() {
                assert_eq!(times(&study), 1, "{} in the study", entry.name);
            } else if !entry.presenting.is_empty() {
                assert_eq!(times(&class), 1, "{} before a class", entry.name);
            }
            // Where the keys differ both pages say so, unless there is nothing to say.
            if entry.keys != entry.presenting && !entry.presenting.is_empty() {
                assert_eq!(times(&class), 1, "{} before a class", entry.name);
            }
        }
    }
}
