//! A place that a link leads to.

use super::{Landing, State};
use crate::shown::view::View;

impl State {
    /// Opens a view where its slide opens.
    pub fn arrive_at(&mut self, view: View) {
        self.wished = view.stage;
        self.want(view, Landing::Opening);
    }
}
