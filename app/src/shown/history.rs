//! What was done, so that it can be undone.

use super::view::View;

/// The most changes that are kept.
const MOST: usize = 200;

/// A view, and whether nobody has stood there yet: then it opens where its slide does.
pub(crate) type Stood = (View, bool);

/// Earlier and later views.
#[derive(Clone, Debug, Default)]
pub(crate) struct History {
    past: Vec<Stood>,
    future: Vec<Stood>,
}

impl History {
    /// Remembers a view that is about to change; once is enough.
    pub(crate) fn keep(&mut self, (view, opens): (&View, bool)) {
        self.future.clear();
        if self.past.last().is_some_and(|(last, _)| last.same_page(view)) {
            return;
        }
        if self.past.len() == MOST {
            self.past.remove(0);
        }
        self.past.push((view.clone(), opens));
    }

    /// Nothing has changed after all: the view kept last, if it is this one. Whether it was.
    pub(crate) fn forget(&mut self, view: &View) -> bool {
        self.past.pop_if(|(last, _)| last.same_page(view)).is_some()
    }

    /// The view before the last change; `now` can be brought back by [`History::redo`].
    pub(crate) fn undo(&mut self, now: Stood) -> Option<Stood> {
        let before = self.past.pop()?;
        self.future.push(now);
        Some(before)
    }

    /// The view before a change that is under way, which is forgotten.
    pub(crate) fn take_back(&mut self) -> Option<View> {
        self.past.pop().map(|(view, _)| view)
    }

    /// The view after the change last taken back.
    pub(crate) fn redo(&mut self, now: Stood) -> Option<Stood> {
        let after = self.future.pop()?;
        self.past.push(now);
        Some(after)
    }

    /// Whether there is something to undo, and to redo.
    pub(crate) fn available(&self) -> (bool, bool) {
        (!self.past.is_empty(), !self.future.is_empty())
    }
}
