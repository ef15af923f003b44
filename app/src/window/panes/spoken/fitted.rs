//! How wide the column of words is, and how large they are: so that all fits that is said on a walk.

use std::sync::Arc;

use egui::{Ui, Vec2};
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
    /// The part of the height that a picture has which needs the whole width, where the words stand below it; 0 where
    /// they stand beside it.
    pub(crate) above: f32,
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
    Column { part: 0.30, size: 1.0, leading: LEADING, tall: false, above: 0.0 },
    Column { part: 0.30, size: 0.92, leading: LEADING, tall: false, above: 0.0 },
    Column { part: 0.34, size: 0.92, leading: 1.4, tall: false, above: 0.0 },
    Column { part: 0.36, size: 0.86, leading: 1.35, tall: false, above: 0.0 },
    Column { part: 0.38, size: FLOOR, leading: 1.35, tall: false, above: 0.0 },
    Column { part: 0.43, size: FLOOR, leading: 1.3, tall: false, above: 0.0 },
    Column { part: 0.38, size: 0.86, leading: 1.35, tall: true, above: 0.0 },
    Column { part: 0.43, size: FLOOR, leading: 1.35, tall: true, above: 0.0 },
    Column { part: 0.48, size: FLOOR, leading: 1.28, tall: true, above: 0.0 },
];

/// What is tried below a picture: sizes of letters with their leading.
const BELOW: [[f32; 2]; 3] = [[1.0, 1.45], [0.9, 1.35], [FLOOR, 1.28]];

/// Below a picture words have a multiple of this part of the height, so that a few letters more move nothing; and the
/// least part that a picture has above them.
const SHARE: f32 = 0.02;
const LEAST_ABOVE: f32 = 0.35;

/// A picture that is seen less well than this may have its words on two pages; how much such pages are worth.
const WELL: f32 = 0.74;
const PAGED: f32 = 0.85;

/// The smallest letters in parts of the page's: a thirty-fourth of its height.
const FLOOR: f32 = 27.0 / 33.9;

/// A column with what it was fitted to.
#[derive(Clone, Debug)]
pub(crate) struct Fitted {
    /// The walk or the build, and its slide.
    playback: Arc<Playback>,
    slide: usize,
    /// Whether questions are asked.
    predict: bool,
    /// The room of the widest column, and the size of letters.
    room: [u32; 3],
    /// What it came to.
    pub(crate) column: Column,
}

/// What a column is fitted to.
pub(crate) struct Room<'a> {
    /// The size of letters.
    pub(crate) body: f32,
    /// The room that a column has for its words.
    pub(crate) words: &'a dyn Fn(Column) -> Vec2,
    /// How well the picture is seen beside or above it, where that matters.
    pub(crate) worth: &'a dyn Fn(Column) -> Option<f32>,
}

impl Fitted {
    /// The best column in which all fits that is said on this walk or build: it stays while that is shown.
    pub(crate) fn of(
        kept: Option<Fitted>,
        ui: &Ui,
        state: &State,
        formulas: &mut Formulas,
        theme: &Theme,
        room: &Room<'_>,
    ) -> Option<Fitted> {
        let playback = state.playback()?.clone();
        let (predict, slide) = (state.predict, state.view.slide);
        let last = COLUMNS[COLUMNS.len() - 1];
        let widest = (room.words)(last);
        let key = [widest.x, widest.y, room.body * 16.0].map(|side| side as u32);
        let same = |kept: &Fitted| (kept.slide, kept.predict, kept.room) == (slide, predict, key);
        let kept = kept.filter(same);
        if let Some(kept) = kept.as_ref().filter(|kept| Arc::ptr_eq(&kept.playback, &playback)) {
            return Some(kept.clone());
        }
        let all = Speech::all(state);
        let mut words = Words { ui, formulas, theme, room, all };
        let column = match (room.worth)(last) {
            // What is filled in later moves nothing, as long as it fits.
            Some(_) => match kept.map(|kept| kept.column).filter(|column| words.fits(*column)) {
                Some(column) => column,
                None => words.around_picture(),
            },
            None => COLUMNS.into_iter().find(|column| words.fits(*column)).unwrap_or(last),
        };
        Some(Fitted { playback, slide, predict, room: key, column })
    }
}

/// All that is said, to be fitted.
struct Words<'a> {
    ui: &'a Ui,
    formulas: &'a mut Formulas,
    theme: &'a Theme,
    room: &'a Room<'a>,
    all: Vec<Speech>,
}

impl Words<'_> {
    /// How high the longest of it is.
    fn height(&mut self, column: Column, width: f32) -> f32 {
        let prose = column.set(self.theme, self.room.body);
        self.all.iter().map(|speech| speech.height(self.ui, self.formulas, &prose, width)).fold(0.0, f32::max)
    }

    fn fits(&mut self, column: Column) -> bool {
        let room = (self.room.words)(column);
        self.height(column, room.x) <= room.y
    }

    /// Whether each of it fits on two pages.
    fn fits_paged(&mut self, column: Column) -> bool {
        let (room, prose) = ((self.room.words)(column), column.set(self.theme, self.room.body));
        let Words { ui, formulas, all, .. } = self;
        all.iter().all(|speech| {
            let pages = speech.clone().pages(ui, formulas, &prose, room);
            pages.len() <= 2 && pages.iter().all(|page| page.height(ui, formulas, &prose, room.x) <= room.y)
        })
    }

    /// The words below a picture: as much room as they need, in a part of the whole.
    fn below(&mut self, [size, leading]: [f32; 2]) -> Column {
        let column = Column { part: 1.0, size, leading, tall: false, above: LEAST_ABOVE };
        let room = (self.room.words)(column);
        // The words and their margins have what the picture leaves.
        let whole = ((self.room.words)(Column { above: 0.0, ..column }).y - room.y) / LEAST_ABOVE;
        let margin = whole * (1.0 - LEAST_ABOVE) - room.y;
        let above = 1.0 - (self.height(column, room.x) + margin) / whole.max(1.0);
        Column { above: (above / SHARE).floor() * SHARE, ..column }
    }

    /// Beside or below a picture, so that it is seen as well as may be.
    fn around_picture(&mut self) -> Column {
        let Room { worth, .. } = *self.room;
        let worth = |column: Column| worth(column).unwrap_or(0.0);
        // Large words count, too.
        let value = |column: Column| worth(column) * (0.5 + 0.5 * column.size);
        let best = |values: Vec<(f32, Column)>| values.into_iter().reduce(|a, b| if b.0 > a.0 * 1.02 { b } else { a });
        let beside = COLUMNS.into_iter().filter(|column| !column.tall);
        let whole: Vec<Column> = beside.clone().filter(|column| self.fits(*column)).collect();
        let below: Vec<Column> = BELOW.into_iter().map(|set| self.below(set)).collect();
        let below = below.into_iter().filter(|column| column.above >= LEAST_ABOVE);
        let whole = best(whole.into_iter().chain(below).map(|column| (value(column), column)).collect());
        if let Some((_, column)) = whole.filter(|(_, column)| worth(*column) >= WELL) {
            return column;
        }
        let shares = [0.5, 0.56, 0.62, 0.68, 0.74, 0.8];
        let set =
            |[size, leading]: [f32; 2]| shares.map(|above| Column { part: 1.0, size, leading, tall: false, above });
        let tried: Vec<Column> = beside.chain(BELOW.into_iter().flat_map(set)).collect();
        let paged = tried.into_iter().filter(|column| self.fits_paged(*column)).collect::<Vec<_>>();
        let paged = best(paged.into_iter().map(|column| (value(column) * PAGED, column)).collect());
        let better = whole.into_iter().chain(paged).reduce(|a, b| if b.0 > a.0 { b } else { a });
        better.map_or(COLUMNS[COLUMNS.len() - 1], |(_, column)| column)
    }
}
