//! A rectangle of the page that something takes up.

use glam::Vec2;

use crate::page::{Anchor, Figure, Ink};
use crate::theme::{Face, text_width};

/// Room around a label's text, in sizes of its face, as `print` and the window draw its box.
pub(super) const ASIDE: f32 = 0.5;
pub(super) const HALF: f32 = 0.8;

/// Size of the letters in a picture of this size.
pub(super) fn letters(page: Vec2) -> f32 {
    (page.y / 42.0).clamp(11.0, 22.0)
}

/// How much of what is drawn a label would cover: the lengths of lines, and so much for each dot and each word.
pub(crate) fn covers(label: &Ink, figure: &Figure) -> f32 {
    let Some(spot) = Spot::of_label(label) else { return 0.0 };
    let covered = figure.marks.iter().map(|mark| match &mark.ink {
        Ink::Line { points } => points.windows(2).map(|ends| spot.length_of(ends[0], ends[1])).sum::<f32>(),
        Ink::Circle { center, radius } if spot.nearest(*center).distance(*center) < *radius => DOT,
        Ink::Text { at, text, size, face, anchor, .. } => {
            let word = Spot::of_text(*at, text, *size, *face, *anchor);
            if spot.shared(word) > 0.0 { WORD } else { 0.0 }
        }
        _ => 0.0,
    });
    covered.sum()
}

/// What it costs to cover a dot, and a word, in points of a line.
const DOT: f32 = 30.0;
const WORD: f32 = 200.0;

/// A rectangle of the page.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spot {
    pub(super) min: Vec2,
    pub(super) max: Vec2,
}

impl Spot {
    pub(super) fn around(center: Vec2, half: Vec2) -> Spot {
        Spot { min: center - half, max: center + half }
    }

    /// The rectangle around all points; nothing without any.
    pub(super) fn over(points: &[Vec2]) -> Option<Spot> {
        let around = |a: Spot, b: Spot| Spot { min: a.min.min(b.min), max: a.max.max(b.max) };
        points.iter().map(|point| Spot { min: *point, max: *point }).reduce(around)
    }

    /// Whether two rectangles are the same but for a point.
    pub(super) fn is_near(self, other: Spot) -> bool {
        (self.min - other.min).abs().max((self.max - other.max).abs()).max_element() < 1.0
    }

    /// What a line of text covers.
    pub(super) fn of_text(at: Vec2, text: &str, size: f32, face: Face, anchor: Anchor) -> Spot {
        let width = text_width(text, face, size);
        let middle = match anchor {
            Anchor::Start => at.x + width * 0.5,
            Anchor::Middle => at.x,
            Anchor::End => at.x - width * 0.5,
        };
        Spot::around(Vec2::new(middle, at.y), Vec2::new(width * 0.5, size * 0.5))
    }

    /// The box of a label; nothing if the ink is none.
    pub(super) fn of_label(ink: &Ink) -> Option<Spot> {
        let Ink::Text { at, text, size, face, anchor, boxed: true } = ink else { return None };
        let text = Spot::of_text(*at, text, *size, *face, *anchor);
        Some(Spot::around(text.center(), Vec2::new(text.half().x + size * ASIDE, size * HALF)))
    }

    pub(super) fn center(self) -> Vec2 {
        (self.min + self.max) * 0.5
    }

    pub(super) fn half(self) -> Vec2 {
        (self.max - self.min) * 0.5
    }

    /// The point of it that lies nearest to another.
    pub(super) fn nearest(self, at: Vec2) -> Vec2 {
        at.clamp(self.min, self.max)
    }

    /// The same rectangle where all of it lies in a picture of this size; nothing where none of it does, or no room is.
    pub(super) fn moved_into(self, size: Vec2) -> Option<Spot> {
        let (low, high) = (self.half() + 2.0, size - self.half() - 2.0);
        let seen = self.max.cmpgt(Vec2::ZERO).all() && self.min.cmplt(size).all();
        (seen && low.cmple(high).all()).then(|| Spot::around(self.center().clamp(low, high), self.half()))
    }

    /// The area that two rectangles share.
    pub(super) fn shared(self, other: Spot) -> f32 {
        let common = (self.max.min(other.max) - self.min.max(other.min)).max(Vec2::ZERO);
        common.x * common.y
    }

    /// Whether all of it lies in a convex polygon.
    pub(super) fn is_within(self, polygon: &[Vec2]) -> bool {
        let own = [self.min, Vec2::new(self.max.x, self.min.y), self.max, Vec2::new(self.min.x, self.max.y)];
        let next = polygon.iter().cycle().skip(1);
        let side = |(&from, &to): (&Vec2, &Vec2), p: Vec2| (to - from).perp_dot(p - from);
        let sides: Vec<f32> = polygon.iter().zip(next).flat_map(|edge| own.map(|p| side(edge, p))).collect();
        sides.iter().all(|side| *side >= 0.0) || sides.iter().all(|side| *side <= 0.0)
    }

    /// The length of a line inside the rectangle.
    pub(super) fn length_of(self, from: Vec2, to: Vec2) -> f32 {
        let along = to - from;
        let (mut enter, mut leave) = (0.0_f32, 1.0_f32);
        for axis in 0..2 {
            if along[axis] == 0.0 {
                if from[axis] < self.min[axis] || from[axis] > self.max[axis] {
                    return 0.0;
                }
                continue;
            }
            let (a, b) = ((self.min[axis] - from[axis]) / along[axis], (self.max[axis] - from[axis]) / along[axis]);
            enter = enter.max(a.min(b));
            leave = leave.min(a.max(b));
        }
        (leave - enter).max(0.0) * along.length()
    }
}
