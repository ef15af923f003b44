//! What was done, so that it can be undone.

use super::view::View;

/// The most changes that are kept.
const MOST: usize = 200;

/// Earlier and later views.
#[derive(Clone, Debug, Default)]
pub(crate) struct History {
    past: Vec<View>,
    future: Vec<View>,
}

impl History {
    /// Remembers a view that is about to change; once is enough.
    pub(crate) fn keep(&mut self, view: &View) {
        self.future.clear();
        if self.past.last().is_some_and(|last| last.same_page(view)) {
            return;
        }
        if self.past.len() == MOST {
            self.past.remove(0);
        }
        self.past.push(view.clone());
    }

    /// Nothing has changed after all.
    pub(crate) fn forget(&mut self, view: &View) {
        self.past.pop_if(|last| last.same_page(view));
    }

    /// The view before the last change; `now` can be brought back by [`History::redo`].
    pub(crate) fn undo(&mut self, now: &View) -> Option<View> {
        let before = self.past.pop()?;
        self.future.push(now.clone());
        Some(before)
    }

    /// The view before a change that is under way, which is forgotten.
    pub(crate) fn take_back(&mut self) -> Option<View> {
        self.past.pop()
    }

    /// The view after the change last taken back.
    pub(crate) fn redo(&mut self, now: &View) -> Option<View> {
        let after = self.future.pop()?;
        self.past.push(now.clone());
        Some(after)
    }

    /// Whether there is something to undo, and to redo.
    pub(crate) fn available(&self) -> (bool, bool) {
        (!self.past.is_empty(), !self.future.is_empty())
    }
}
