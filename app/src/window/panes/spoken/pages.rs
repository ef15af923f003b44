//! Which page of a long beat is shown: it is turned before one goes on, and begins anew with everything else that is said.

use crate::shown::command::Command;
use crate::shown::state::{Answered, State};

/// The page that is shown of what is said.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Pages {
    /// What it is said of.
    of: Option<Said>,
    at: usize,
    many: usize,
}

/// What is said at a time: of which slide and step, whether it is a question, and what was answered.
type Said = (usize, usize, bool, Option<Answered>);

fn said(state: &State) -> Said {
    (state.view.slide, state.view.step, state.question().is_some(), state.answered)
}

impl Pages {
    /// The page that is shown now of so many.
    pub(crate) fn at(&mut self, state: &State, many: usize) -> usize {
        let now = Some(said(state));
        if self.of != now {
            *self = Pages { of: now, at: 0, many };
        }
        self.many = many;
        self.at = self.at.min(many.saturating_sub(1));
        self.at
    }

    /// The page that is shown, and how many there are.
    pub(crate) fn now(&self) -> [usize; 2] {
        [self.at, self.many]
    }

    /// Turns a page where a command goes on or back; says whether there was one to turn.
    pub(crate) fn turn(&mut self, state: &State, command: Command) -> bool {
        if !state.present || state.lecture.cover.is_some() || self.of != Some(said(state)) {
            return false;
        }
        match command {
            Command::Next | Command::Onward if self.at + 1 < self.many => self.at += 1,
            Command::Previous | Command::Backward if self.at > 0 => self.at -= 1,
            _ => return false,
        }
        true
    }
}
