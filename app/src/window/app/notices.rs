//! What is said to the user.

use egui::Ui;
use raystep_lesson::{Library, Problem};

use super::App;
use crate::files;
use crate::window::panes::Notices;

impl App {
    /// Says something for a while.
    pub(super) fn say(&mut self, ui: &Ui, sentence: impl Into<String>) {
        self.notices().say(ui.ctx(), sentence);
    }

    /// Where sentences for the user stand: on the speaker's window, while that is open.
    fn notices(&mut self) -> &mut Notices {
        match self.state.present && self.state.lecture.speaker {
            true => &mut self.speaker.kept().notices,
            false => &mut self.kept.notices,
        }
    }

    /// Says what went wrong, until somebody closes it, and on the standard error.
    pub(super) fn complain(&mut self, sentence: impl Into<String>) {
        let sentence = sentence.into();
        files::say(&sentence);
        self.notices().keep(sentence);
    }

    /// Says what is wrong in the lessons, until they are read again.
    pub(super) fn tell_problems(&mut self, library: &Library) {
        if let Some(old) = self.problems.take() {
            self.kept.notices.take_back(&old);
        }
        let Some(first) =
            library.problems.iter().find(|problem| self.is_of_slide(problem)).or(library.problems.first())
        else {
            return;
        };
        let more = match library.problems.len() - 1 {
            0 => String::new(),
            more => format!(" And {more} more: raystep check names them."),
        };
        let sentence = format!("{first}.{more}");
        self.kept.notices.keep(sentence.clone());
        self.problems = Some(sentence);
    }

    /// Whether a problem is one of the slide that is shown, or on its way.
    fn is_of_slide(&self, problem: &Problem) -> bool {
        self.state.library.slides.get(self.state.target().slide).is_some_and(|slide| slide.file == problem.file)
    }

    /// Says why a slide cannot be made, unless that very thing was said of its file already, with its place.
    pub(super) fn tell_unmade(&mut self, wrong: String) {
        let told = |problem: &Problem| self.is_of_slide(problem) && problem.message == wrong;
        if !self.state.library.problems.iter().any(told) {
            self.complain(wrong);
        }
    }
}
