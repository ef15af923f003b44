//! The palette: every command and every slide, found by a few letters.

use egui::{Id, Key, Modal, Modifiers, RichText, ScrollArea, TextEdit, Ui};
use raystep_figure::{Role, Theme};
use raystep_lesson::Library;

use crate::shown::command::{Command, ENTRIES};
use crate::window::look::visuals::ink;

/// What is typed and which line is chosen.
#[derive(Default)]
pub(super) struct Palette {
    typed: String,
    chosen: usize,
}

/// What was chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Choice {
    Command(Command),
    Slide(usize),
}

impl Palette {
    /// Shows the palette; says whether it shall close, and what was chosen.
    pub(super) fn show(&mut self, ui: &Ui, library: &Library, theme: &Theme) -> (bool, Option<Choice>) {
        let mut chosen = None;
        let modal = Modal::new(Id::unique("palette")).show(ui.ctx(), |ui| {
            ui.set_width(460.0);
            let (up, down, enter) = ui.input_mut(|input| {
                let mut take = |key| input.consume_key(Modifiers::NONE, key);
                (take(Key::ArrowUp), take(Key::ArrowDown), take(Key::Enter))
            });
            let field =
                TextEdit::singleline(&mut self.typed).hint_text("Find a command or slide").desired_width(f32::INFINITY);
            let response = ui.add(field);
            response.request_focus();
            if response.changed() {
                self.chosen = 0;
            }
            let found = found(library, &self.typed);
            if up {
                self.chosen = self.chosen.saturating_sub(1);
            }
            if down {
                self.chosen += 1;
            }
            self.chosen = self.chosen.min(found.len().saturating_sub(1));
            if enter {
                chosen = found.get(self.chosen).map(|(choice, ..)| *choice);
            }
            ScrollArea::vertical().max_height(380.0).auto_shrink(false).show(ui, |ui| {
                for (index, (choice, name, keys)) in found.iter().enumerate() {
                    let button = egui::Button::selectable(index == self.chosen, name.as_str())
                        .shortcut_text(RichText::new(keys).color(ink(theme, Role::Quiet)))
                        .min_size(egui::vec2(ui.available_width(), 26.0));
                    let response = ui.add(button);
                    if index == self.chosen && (up || down) {
                        response.scroll_to_me(None);
                    }
                    if response.clicked() {
                        chosen = Some(*choice);
                    }
                }
                if found.is_empty() {
                    ui.label(RichText::new("Nothing of that name.").color(ink(theme, Role::Quiet)));
                }
            });
        });
        (modal.should_close() || chosen.is_some(), chosen)
    }
}

/// Commands and slides whose names contain all the words typed, best first.
fn found(library: &Library, typed: &str) -> Vec<(Choice, String, String)> {
    let commands = ENTRIES.iter().filter(|entry| entry.command != Command::Palette);
    let commands =
        commands.map(|entry| (Choice::Command(entry.command), entry.name.to_owned(), entry.keys_text().to_owned()));
    let slides = library.slides.iter().enumerate();
    let slides = slides.map(|(index, slide)| (Choice::Slide(index), slide.title.clone(), slide.numbers_text()));
    let typed = typed.to_lowercase();
    let fits = |(_, name, more): &(Choice, String, String)| {
        let text = format!("{name} {more}").to_lowercase();
        typed.split_whitespace().all(|word| text.contains(word))
    };
    let mut found: Vec<_> = slides.chain(commands).filter(fits).collect();
    found.sort_by_key(|(_, name, _)| !name.to_lowercase().starts_with(&typed));
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_few_letters_find_a_command() {
        let library = Library::default();
        assert_eq!(found(&library, "undo")[0].0, Choice::Command(Command::Undo));
        assert_eq!(found(&library, "step next")[0].0, Choice::Command(Command::Next));
        assert!(found(&library, "no such thing").is_empty());
    }
}
