//! A place that a link leads to.

use raystep_lesson::Column;

use super::{Landing, State};
use crate::shown::beside::{Beside, Pace, Rivals};
use crate::shown::view::View;

impl State {
    /// Opens a view where its slide opens.
    pub fn arrive_at(&mut self, view: View) {
        self.wished = view.stage;
        self.want(view, Landing::Opening);
    }

    /// What stands beside it, how that keeps in step, and what a heat map counts in its place; whatever stood there
    /// before.
    pub fn accompany(&mut self, beside: Beside, pace: Pace, heat: Option<Column>) {
        (self.beside, self.pace, self.heat) = (beside, pace, heat);
        match beside {
            Beside::Structure(kind) => self.rivals = Rivals::of([kind]),
            Beside::Abreast(rivals) => self.rivals = rivals,
            Beside::Nothing | Beside::Mistake(_) => {}
        }
    }
}
