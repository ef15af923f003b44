//! A drawing on a page: marks in points, y downwards, origin at the upper left.

use std::sync::Arc;

use glam::Vec2;
use raystep_accel::Place;

use crate::theme::{Face, Role};

/// A drawing of some size. Marks are drawn in order, later ones on top.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figure {
    /// Width and height in points.
    pub size: Vec2,
    /// What is drawn.
    pub marks: Vec<Mark>,
}

/// Ink with a meaning and, where it is about one, a place.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// The drawn shape.
    pub ink: Ink,
    /// What it means.
    pub role: Role,
    /// What it is about: marks of the same place light up together.
    pub place: Option<Place>,
}

/// A drawn shape, in points.
#[derive(Clone, Debug, PartialEq)]
pub enum Ink {
    /// A line through points.
    Line {
        /// The points, at least two.
        points: Vec<Vec2>,
    },
    /// A closed polygon; concave ones too.
    Area {
        /// The corners, at least three.
        points: Vec<Vec2>,
    },
    /// A rectangle.
    Rect {
        /// Upper left corner.
        min: Vec2,
        /// Lower right corner.
        max: Vec2,
        /// Radius of its corners.
        round: f32,
    },
    /// Pixels, stretched over a rectangle.
    Image {
        /// Upper left corner.
        min: Vec2,
        /// Lower right corner.
        max: Vec2,
        /// The pixels.
        image: Image,
    },
    /// A circle.
    Circle {
        /// Its centre.
        center: Vec2,
        /// Its radius.
        radius: f32,
    },
    /// A filled arrow head.
    Arrowhead {
        /// Its tip.
        tip: Vec2,
        /// Where it points, length one.
        along: Vec2,
        /// Its length.
        length: f32,
    },
    /// A formula in TeX, in the colour of its role's text.
    Formula {
        /// Its left end, on the line that letters stand on.
        at: Vec2,
        /// The formula, without dollar signs.
        tex: String,
        /// Size of its letters in points.
        size: f32,
    },
    /// One line of text.
    Text {
        /// Where it is anchored, on the vertical middle of its small letters.
        at: Vec2,
        /// The text.
        text: String,
        /// Size of the face in points.
        size: f32,
        /// The face.
        face: Face,
        /// Which end of the text lies at `at`.
        anchor: Anchor,
        /// Whether it stands on a rounded box (a label in a picture), drawn as [`Theme::label`](crate::theme::Theme::label) says.
        boxed: bool,
    },
}

/// Pixels, rows from above, each red, green, blue and (straight) alpha.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// Pixels in a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Four bytes for each pixel.
    pub rgba: Arc<[u8]>,
}

/// Which part of a text lies at its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Anchor {
    /// Its left end.
    Start,
    /// Its middle.
    Middle,
    /// Its right end.
    End,
}

impl Mark {
    /// The same mark elsewhere on the page.
    pub(crate) fn moved(mut self, by: Vec2) -> Mark {
        match &mut self.ink {
            Ink::Line { points } | Ink::Area { points } => points.iter_mut().for_each(|point| *point += by),
            Ink::Rect { min, max, .. } | Ink::Image { min, max, .. } => (*min, *max) = (*min + by, *max + by),
            Ink::Circle { center, .. } => *center += by,
            Ink::Arrowhead { tip: at, .. } | Ink::Formula { at, .. } | Ink::Text { at, .. } => *at += by,
        }
        self
    }
}

impl Figure {
    /// The same drawing `by` times as large, letters and heads of arrows too.
    pub fn scaled(mut self, by: f32) -> Figure {
        self.size *= by;
        for mark in &mut self.marks {
            match &mut mark.ink {
                Ink::Line { points } | Ink::Area { points } => points.iter_mut().for_each(|point| *point *= by),
                Ink::Rect { min, max, round } => (*min, *max, *round) = (*min * by, *max * by, *round * by),
                Ink::Circle { center, radius } => (*center, *radius) = (*center * by, *radius * by),
                Ink::Arrowhead { tip, length, .. } => (*tip, *length) = (*tip * by, *length * by),
                Ink::Text { at, size, .. } | Ink::Formula { at, size, .. } => (*at, *size) = (*at * by, *size * by),
                Ink::Image { min, max, .. } => (*min, *max) = (*min * by, *max * by),
            }
        }
        self
    }

    /// An empty drawing.
    pub fn new(size: Vec2) -> Figure {
        Figure { size, marks: Vec::new() }
    }

    /// The middle of what a place looks like here: of the smallest box, disc or text that is about it.
    pub fn middle_of(&self, place: Place) -> Option<Vec2> {
        let of_place = self.marks.iter().filter(|mark| mark.place == Some(place));
        let middles = of_place.filter_map(|mark| match mark.ink {
            Ink::Rect { min, max, .. } => Some(((min + max) * 0.5, (max - min).element_product().abs())),
            Ink::Circle { center, radius } => Some((center, 4.0 * radius * radius)),
            Ink::Text { at, .. } => Some((at, f32::MAX)),
            _ => None,
        });
        middles.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(middle, _)| middle)
    }

    /// Adds a mark on top.
    pub fn add(&mut self, role: Role, place: Option<Place>, ink: Ink) {
        self.marks.push(Mark { ink, role, place });
    }
}
