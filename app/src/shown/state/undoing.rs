//! Back to what was shown before, and to what the slide itself shows.

use super::{Landing, State, first_stage};
use crate::shown::beside::Beside;
use crate::shown::view::View;

impl State {
    /// Remembers the view before a change that undo shall take back in one.
    pub fn keep(&mut self) {
        self.anchor = None;
        // What was asked for last counts, also where its walk is not there yet.
        self.history.keep((self.wanted.as_ref().unwrap_or(&self.view), self.opens()));
    }

    /// Whether there is something to undo, and to redo.
    pub fn undoable(&self) -> (bool, bool) {
        self.history.available()
    }

    pub(super) fn restore(&mut self) {
        let View { slide, stage, .. } = *self.target();
        let own = View::of_slide(slide, first_stage(&self.library, slide, stage));
        if !own.same_walk(self.target()) {
            self.keep();
            self.want(own, Landing::Opening);
        } else if !self.view.looks_its_own() {
            self.keep();
            self.change_look(|view| *view = view.clone().looking_as(&own));
        }
        (self.view.tried, self.trial) = (None, None);
        self.beside = Beside::Nothing;
        self.heat = None;
    }

    /// Whether what is wanted is to open where its slide does, and does not stand there yet.
    fn opens(&self) -> bool {
        self.wanted.is_some() && self.landing == Landing::Opening
    }

    pub(super) fn undo(&mut self) {
        let now = (self.target().clone(), self.opens());
        if let Some((view, opens)) = self.history.undo(now) {
            self.want(view, if opens { Landing::Opening } else { Landing::Named });
        }
    }

    pub(super) fn redo(&mut self) {
        let now = (self.target().clone(), self.opens());
        if let Some((view, opens)) = self.history.redo(now) {
            self.want(view, if opens { Landing::Opening } else { Landing::Named });
        }
    }
}
