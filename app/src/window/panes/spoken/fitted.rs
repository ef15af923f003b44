//! How wide the column of words is, and how large they are: so that all fits that is said on a walk.

use std::sync::Arc;

use egui::Ui;
use raystep_figure::{Face, Role, Theme};

use super::speech::Speech;
use crate::shown::playback::Playback;
use crate::shown::state::State;
use crate::window::look::formulas::Formulas;
use crate::window::look::prose::{LEADING, Prose};

/// How wide the column of words is, and how large they are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Column {
    /// Its part of the page's width.
    pub(crate) part: f32,
    /// The size of its letters in parts of the page's.
    pub(crate) size: f32,
    /// From line to line, in parts of that size.
    pub(crate) leading: f32,
    /// Whether it reaches down beside the panes below space, which then are as narrow as that.
    pub(crate) tall: bool,
    /// Whether it is no column, but stands below a picture that needs the whole width.
    pub(crate) below: bool,
}

impl Column {
    /// The one that is tried first.
    pub(crate) const USUAL: Column = COLUMNS[0];

    /// How its words are set, where letters of the page have this size.
    pub(crate) fn set(self, theme: &Theme, body: f32) -> Prose<'_> {
        Prose { theme, size: body * self.size, role: Role::Text, face: Face::Regular, leading: self.leading }
    }
}

/// What is tried, the best first: letters of less than a thirty-fourth of the page's height are never tried.
const COLUMNS: [Column; 9] = [
    Column { part: 0.30, size: 1.0, leading: LEADING, tall: false, below: false },
    Column { part: 0.30, size: 0.92, leading: LEADING, tall: false, below: false },
    Column { part: 0.34, size: 0.92, leading: 1.4, tall: false, below: false },
    Column { part: 0.36, size: 0.86, leading: 1.35, tall: false, below: false },
    Column { part: 0.38, size: FLOOR, leading: 1.35, tall: false, below: false },
    Column { part: 0.43, size: FLOOR, leading: 1.3, tall: false, below: false },
    Column { part: 0.38, size: 0.86, leading: 1.35, tall: true, below: false },
    Column { part: 0.43, size: FLOOR, leading: 1.35, tall: true, below: false },
    Column { part: 0.48, size: FLOOR, leading: 1.28, tall: true, below: false },
];

/// What is tried below a picture that needs the whole width.
const BELOW: [Column; 3] = [
    Column { part: 1.0, size: 1.0, leading: LEADING, tall: false, below: true },
    Column { part: 1.0, size: 0.9, leading: 1.35, tall: false, below: true },
    Column { part: 1.0, size: FLOOR, leading: 1.28, tall: false, below: true },
];

/// The smallest letters in parts of the page's: a thirty-fourth of its height.
const FLOOR: f32 = 27.0 / 33.9;

/// A column with what it was fitted to.
#[derive(Clone, Debug)]
pub(crate) struct Fitted {
    /// The walk or the build.
    playback: Arc<Playback>,
    /// Whether questions are asked.
    predict: bool,
    /// The room of the widest column, and the size of letters.
    room: [u32; 3],
    /// What it came to.
    pub(crate) column: Column,
}

impl Fitted {
    /// The best column in which all fits that is said on this walk or build: it stays while that is shown. `room` is
    /// what a column has, and `body` the size of letters; `below` a picture that needs the whole width.
    pub(crate) fn of(
        kept: Option<Fitted>,
        ui: &Ui,
        state: &State,
        formulas: &mut Formulas,
        theme: &Theme,
        room: impl Fn(Column) -> egui::Vec2,
        body: f32,
        below: bool,
    ) -> Option<Fitted> {
        let playback = state.playback()?.clone();
        let predict = state.predict;
        let columns = if below { &BELOW[..] } else { &COLUMNS[..] };
        let last = columns[columns.len() - 1];
        let key = [room(last).x, room(last).y, body * 16.0].map(|side| side as u32);
        let same =
            |kept: &Fitted| Arc::ptr_eq(&kept.playback, &playback) && (kept.predict, kept.room) == (predict, key);
        if let Some(kept) = kept.filter(same) {
            return Some(kept);
        }
        let all = Speech::all(state);
        let mut fits = |column: &&Column| {
            let room = room(**column);
            all.iter().all(|speech| speech.height(ui, formulas, &column.set(theme, body), room.x) <= room.y)
        };
        let column = *columns.iter().find(&mut fits).unwrap_or(&last);
        Some(Fitted { playback, predict, room: key, column })
    }
}
