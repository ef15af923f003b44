//! What is heard of a walk inside an instance.

use crate::{Observer, Visit};

/// Passes on what happens inside an instance. Whether its hit is a better one, and whether the walk is over,
/// only the walk outside can say.
pub(super) struct Below<'a, W> {
    pub(super) watch: &'a mut W,
}

impl<W: Observer<Visit>> Observer<Visit> for Below<'_, W> {
    #[inline]
    fn on(&mut self, event: Visit) {
        if !matches!(event, Visit::Better { .. } | Visit::End { .. }) {
            self.watch.on(event);
        }
    }
}
