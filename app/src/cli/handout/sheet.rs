//! Sheets of paper that are filled from the top.

use glam::Vec2;
use raystep_figure::{Anchor, Face, Figure, Ink, Role};
use raystep_print::{Passage, Reading, prose, set_in};

use super::Printed;

/// A sheet in points: as high in proportion to its width as A4.
pub(super) const WIDTH: f32 = 1100.0;
pub(super) const HEIGHT: f32 = 1555.0;
/// The width of A4 in CSS pixels, 96 to the inch: 210 mm.
pub(super) const A4: f32 = 210.0 / 25.4 * 96.0;
/// Room at the left and the right, above and below.
const SIDE: f32 = 64.0;
const TOP: f32 = 56.0;
const BOTTOM: f32 = 92.0;
/// How wide what stands on it is.
pub(super) const INNER: f32 = WIDTH - 2.0 * SIDE;
/// Between two things on it.
const GAP: f32 = 30.0;

/// What is put on sheets, one thing below the other.
pub(super) struct Sheet<'a> {
    title: &'a str,
    about: &'a str,
    pages: Vec<Page>,
    /// How far the last of them is filled.
    filled: f32,
    /// Whether a question stands at its foot.
    asked: bool,
}

/// A sheet that is being filled.
pub(super) struct Page {
    figure: Figure,
    passages: Vec<Passage>,
    about: String,
    empty: bool,
}

/// Something that is put on a sheet in one piece, and how it is read aloud.
pub(super) struct Piece {
    pub(super) figure: Figure,
    pub(super) passages: Vec<Passage>,
    /// Whether it asks something: what comes next may answer it, and stands on the next sheet.
    pub(super) asks: bool,
}

impl<'a> Sheet<'a> {
    /// The first sheet, with its title.
    pub(super) fn new(title: &'a str, about: &'a str) -> Sheet<'a> {
        let mut sheet = Sheet { title, about, pages: Vec::new(), filled: 0.0, asked: false };
        sheet.turn();
        sheet
    }

    /// Begins another sheet.
    fn turn(&mut self) {
        let more = !self.pages.is_empty();
        let mut figure = Figure::new(Vec2::new(WIDTH, HEIGHT));
        let about = if more { format!("{} · {}, continued", self.about, self.title) } else { self.about.to_owned() };
        let mut y = TOP;
        let small = prose(&about, INNER, 15.0, Face::Regular, Role::Quiet);
        let height = small.size.y;
        set_in(&mut figure, small, Vec2::new(SIDE, y));
        y += height + 6.0;
        if !more {
            let large = prose(&format!("**{}**", self.title), INNER, 30.0, Face::Bold, Role::Text);
            let height = large.size.y;
            set_in(&mut figure, large, Vec2::new(SIDE, y));
            y += height + 4.0;
        }
        let says = if more { about.clone() } else { format!("{}. {}.", self.about, self.title) };
        let heading = Passage { marks: 0..figure.marks.len(), kind: Reading::Heading, says };
        self.pages.push(Page { figure, passages: vec![heading], about: self.about.to_owned(), empty: true });
        self.filled = y + GAP * 0.4;
    }

    /// Puts something below what is there, on a new sheet if there is no room.
    pub(super) fn add(&mut self, Piece { figure: part, passages, asks }: Piece) {
        let asked = std::mem::replace(&mut self.asked, asks);
        let full = asked || self.filled + part.size.y > HEIGHT - BOTTOM;
        if full && self.pages.last().is_some_and(|page| !page.empty) {
            self.turn();
        }
        let Some(page) = self.pages.last_mut() else { return };
        let height = part.size.y;
        let before = page.figure.marks.len();
        set_in(&mut page.figure, part, Vec2::new(SIDE, self.filled));
        page.passages.extend(passages.into_iter().map(|passage| {
            let marks = passage.marks.start + before..passage.marks.end + before;
            Passage { marks, ..passage }
        }));
        page.empty = false;
        self.filled += height + GAP;
    }

    pub(super) fn finish(self) -> Vec<Page> {
        self.pages
    }
}

impl Page {
    /// The page with its number at the foot.
    pub(super) fn numbered(mut self, number: usize, count: usize) -> Printed {
        let y = HEIGHT - BOTTOM * 0.45;
        let points = vec![Vec2::new(SIDE, y - 20.0), Vec2::new(WIDTH - SIDE, y - 20.0)];
        self.figure.add(Role::Edge, None, Ink::Line { points });
        let mut text = |x: f32, text: String, anchor| {
            let (at, face) = (Vec2::new(x, y), Face::Regular);
            self.figure.add(Role::Quiet, None, Ink::Text { at, text, size: 15.0, face, anchor, boxed: false });
        };
        text(SIDE, format!("Raystep · {}", self.about), Anchor::Start);
        text(WIDTH - SIDE, format!("{number} of {count}"), Anchor::End);
        Printed { figure: self.figure, passages: self.passages }
    }
}
