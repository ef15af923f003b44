//! The palette: every command and every slide, found by a few letters.

use egui::{Id, Key, Modal, Modifiers, RichText, ScrollArea, TextEdit, Ui};
use raystep_figure::{Role, Theme};
use raystep_lesson::{Library, Slide};

use crate::shown::Link;
use crate::shown::command::{Command, ENTRIES};
use crate::window::look::visuals::ink;

/// What is typed and which line is chosen.
#[derive(Default)]
pub(super) struct Palette {
    typed: String,
    chosen: usize,
}

/// What was chosen.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Choice {
    Command(Command),
    Slide(usize),
    Link(Box<Link>),
}

impl Palette {
    /// Shows the palette; says whether it shall close, and what was chosen.
    pub(super) fn show(&mut self, ui: &Ui, library: &Library, theme: &Theme) -> (bool, Option<Choice>) {
        let mut chosen = None;
        let modal = Modal::new(Id::unique("palette")).show(ui.ctx(), |ui| {
            let room = ui.ctx().content_rect().size();
            ui.set_width((room.x * 0.5).clamp(360.0, 640.0));
            let (up, down, enter) = ui.input_mut(|input| {
                let mut take = |key| input.consume_key(Modifiers::NONE, key);
                (take(Key::ArrowUp), take(Key::ArrowDown), take(Key::Enter))
            });
            let field = TextEdit::singleline(&mut self.typed)
                .hint_text("Find a command or slide, or paste a link")
                .desired_width(f32::INFINITY);
            let response = ui.add(field);
            response.request_focus();
            if response.changed() {
                self.chosen = 0;
                // What was typed in one go stands there with the next frame.
                ui.ctx().request_repaint();
            }
            // A link that was pasted leads to its place, or says why it does not.
            let (found, wrong) = match link(library, &self.typed) {
                Some(Ok(found)) => (vec![found], None),
                Some(Err(why)) => (Vec::new(), Some(why)),
                None => (found(library, &self.typed), None),
            };
            if up {
                self.chosen = self.chosen.saturating_sub(1);
            }
            if down {
                self.chosen += 1;
            }
            self.chosen = self.chosen.min(found.len().saturating_sub(1));
            if enter {
                chosen = found.get(self.chosen).map(|(choice, ..)| choice.clone());
            }
            ScrollArea::vertical().max_height((room.y * 0.62).max(260.0)).auto_shrink(false).show(ui, |ui| {
                for (index, (choice, name, keys)) in found.iter().enumerate() {
                    let button = egui::Button::selectable(index == self.chosen, name.as_str())
                        .shortcut_text(RichText::new(keys).color(ink(theme, Role::Quiet)))
                        .min_size(egui::vec2(ui.available_width(), 26.0));
                    let response = ui.add(button);
                    if index == self.chosen && (up || down) {
                        response.scroll_to_me(None);
                    }
                    if response.clicked() {
                        chosen = Some(choice.clone());
                    }
                }
                if found.is_empty() {
                    let says = wrong.as_deref().unwrap_or("Nothing of that name.");
                    ui.label(RichText::new(says).color(ink(theme, Role::Quiet)));
                }
            });
        });
        (modal.should_close() || chosen.is_some(), chosen)
    }
}

/// What is typed, if it is a link: where it leads, or why it does not.
fn link(library: &Library, typed: &str) -> Option<Result<(Choice, String, String), String>> {
    if !typed.contains('?') || typed.trim() == "?" {
        return None;
    }
    let link = match typed.parse::<Link>() {
        Ok(link) => link,
        Err(why) => return Some(Err(format!("This link leads nowhere: {why}."))),
    };
    let (view, wrong) = link.view(library);
    let title = view.and_then(|view| library.slides.get(view.slide)).map(|slide| slide.title.clone());
    Some(match title.filter(|_| wrong.is_empty()) {
        Some(title) => {
            let step = link.step.map_or_else(String::new, |step| format!(", step {step}"));
            let name = format!("Go to {}: {title}{step}", link.slide);
            Ok((Choice::Link(Box::new(link)), name, String::new()))
        }
        None => Err(format!("This link leads nowhere: {}.", wrong.join("; "))),
    })
}

/// Commands and slides whose names contain all the words typed, best first.
fn found(library: &Library, typed: &str) -> Vec<(Choice, String, String)> {
    let commands = ENTRIES.iter().filter(|entry| entry.command != Command::Palette);
    let commands =
        commands.map(|entry| (Choice::Command(entry.command), entry.name.to_owned(), entry.keys_text().to_owned()));
    let slides = library.slides.iter().enumerate();
    let slides = slides.map(|(index, slide)| (Choice::Slide(index), slide.title.clone(), slide.numbers_text()));
    let typed = typed.trim().to_lowercase();
    let fits = |text: &str| {
        let text = text.to_lowercase();
        typed.split_whitespace().all(|word| text.contains(word))
    };
    // A slide is also found by its id, its section, its structures and its listing, and by what it says.
    let rank = |(choice, name, more): &(Choice, String, String)| {
        let slide = match choice {
            Choice::Slide(index) => library.slides.get(*index),
            Choice::Command(_) | Choice::Link(_) => None,
        };
        let about = slide.map(about).unwrap_or_default();
        match slide {
            Some(slide) if slide.id() == typed => Some(0),
            _ if name.to_lowercase().starts_with(&typed) => Some(1),
            _ if fits(&format!("{name} {more} {about}")) => Some(2),
            Some(slide) if fits(&said(slide)) => Some(3),
            _ => None,
        }
    };
    let mut found: Vec<_> = slides.chain(commands).filter_map(|entry| Some((rank(&entry)?, entry))).collect();
    found.sort_by_key(|(rank, _)| *rank);
    found.into_iter().map(|(_, entry)| entry).collect()
}

/// What a slide is found by besides its title and its numbers.
fn about(slide: &Slide) -> String {
    let section = slide.section_title();
    let plans = slide.stages.iter().map(|stage| {
        let set = stage.plan.settings.iter().map(|set| format!("{} {}", set.key.replace('_', " "), set.value));
        format!("{} {}", stage.plan.kind, set.collect::<Vec<_>>().join(" "))
    });
    let listing = slide.listing.replace('-', " ");
    format!("{} {section} {} {listing}", slide.id(), plans.collect::<Vec<_>>().join(" "))
}

/// Everything that a slide says.
fn said(slide: &Slide) -> String {
    let beats = slide.beats.iter().flat_map(|beat| {
        let texts = beat.paragraphs.iter().map(|paragraph| paragraph.text.as_str());
        [beat.title.as_str()].into_iter().chain(texts)
    });
    beats.collect::<Vec<_>>().join(" ")
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

    #[test]
    fn a_slide_is_found_by_id_section_and_structure() {
        let library = Library::embedded();
        let first = |typed: &str| match found(&library, typed).first() {
            Some((Choice::Slide(index), ..)) => library.slides[*index].id(),
            other => panic!("{typed}: {other:?}"),
        };
        for slide in &library.slides {
            assert_eq!(first(&slide.id()), slide.id());
        }
        for typed in ["kd", "bvh", "grid", "kd-trees", "5/3", "SAH", "kd walk", "mailbox", "overlap", "traversal"] {
            first(typed);
        }
    }
}
