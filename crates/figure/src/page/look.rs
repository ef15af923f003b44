//! How large a pane is set, and the few shapes that all panes share.

use glam::Vec2;
use raystep_accel::Place;

use crate::page::{Anchor, Figure, Ink};
use crate::theme::fonts::has_glyph;
use crate::theme::{Face, Role, text_width};

/// What the window, the presenter's page and a printed plate set differently.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    /// Size of body text in points; everything else in a pane follows from it.
    pub text: f32,
    /// Whether a pane carries its own heading.
    pub titles: bool,
    /// The smallest letters that can be read: what cannot be set so large is shown in part. 0 where one may come nearer.
    pub least: f32,
}

impl Look {
    /// A pane of the window.
    pub const WINDOW: Look = Look { text: 13.0, titles: true, least: 0.0 };

    /// Height of a line of text.
    pub(crate) fn line(&self) -> f32 {
        (self.text * 1.7).round()
    }

    /// Small print: axis numbers, second thoughts.
    pub(crate) fn small(&self) -> f32 {
        self.text * 0.9
    }

    /// Room at the edges of a pane.
    pub(crate) fn margin(&self) -> f32 {
        (self.text * 0.8).round()
    }

    /// Draws the heading, with a remark behind it, and returns where the pane's own drawing begins.
    pub(crate) fn heading(&self, figure: &mut Figure, title: &str, remark: &str) -> f32 {
        if !self.titles {
            return self.margin() * 0.5;
        }
        let y = self.margin() + self.text * 0.6;
        let left = self.margin();
        write(figure, Role::Quiet, None, Vec2::new(left, y), title, self.text * 0.95, Face::Bold, Anchor::Start);
        let x = self.behind(title);
        // A remark that has no room is left out: what stands beside is not covered.
        if !remark.is_empty() && self.has_room(figure, title, remark) {
            write(figure, Role::Quiet, None, Vec2::new(x, y), remark, self.small(), Face::Regular, Anchor::Start);
        }
        y + self.text * 1.0
    }

    /// Whether a remark fits behind a heading.
    pub(crate) fn has_room(&self, figure: &Figure, title: &str, remark: &str) -> bool {
        let end = self.behind(title) + text_width(remark, Face::Regular, self.small());
        end <= figure.size.x || figure.size.x == 0.0
    }

    /// Where a remark behind a heading begins.
    fn behind(&self, title: &str) -> f32 {
        self.margin() + text_width(title, Face::Bold, self.text * 0.95) + self.text
    }

    /// A pane with nothing to draw says why.
    pub(crate) fn nothing(&self, figure: &mut Figure, title: &str, says: &str) {
        let at = Vec2::new(self.margin(), self.heading(figure, title, "") + self.line() * 0.5);
        write(figure, Role::Quiet, None, at, says, self.text, Face::Regular, Anchor::Start);
    }
}

/// A pane that says why it shows nothing.
pub fn nothing(title: &str, says: &str, size: Vec2, look: &Look) -> Figure {
    let mut figure = Figure::new(size);
    look.nothing(&mut figure, title, says);
    figure
}

/// Adds one line of text, if there is any.
pub(crate) fn write(
    figure: &mut Figure,
    role: Role,
    place: Option<Place>,
    at: Vec2,
    text: &str,
    size: f32,
    face: Face,
    anchor: Anchor,
) {
    if text.is_empty() {
        return;
    }
    figure.add(
        role,
        place,
        Ink::Text { at, text: text.to_owned(), size, face: legible(text, face), anchor, boxed: false },
    );
}

/// The face, or one that has all letters of the text: of small raised ones, as in 10⁻⁷, a face for numbers lacks some, and
/// those of 10¹² it sets as far apart as large ones.
fn legible(text: &str, face: Face) -> Face {
    let instead = match face {
        Face::Mono => Face::Regular,
        Face::MonoMedium => Face::Medium,
        face => face,
    };
    let raised = |letter: char| "⁰¹²³⁴⁵⁶⁷⁸⁹".contains(letter);
    let power = text.match_indices("10").any(|(at, ten)| text[at + ten.len()..].starts_with(raised));
    if !power && text.chars().all(|letter| has_glyph(letter, face)) { face } else { instead }
}

/// A straight line.
pub(crate) fn line(from: Vec2, to: Vec2) -> Ink {
    Ink::Line { points: vec![from, to] }
}

/// A rectangle with corners `min` and `min + size`.
pub(crate) fn block(min: Vec2, size: Vec2, round: f32) -> Ink {
    Ink::Rect { min, max: min + size, round }
}

/// The parts with dots between them, broken into lines.
pub(crate) fn wrapped(parts: &[String], width: f32, size: f32) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for part in parts {
        match lines.last_mut() {
            Some(line) if text_width(&format!("{line} · {part}"), Face::Regular, size) <= width => {
                line.push_str(" · ");
                line.push_str(part);
            }
            _ => lines.push(part.clone()),
        }
    }
    lines
}
