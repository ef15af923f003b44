//! Figures set into a larger one.

use glam::Vec2;
use raystep_figure::{Figure, Ink, Role};

/// A rectangle of the page.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Area {
    pub(crate) min: Vec2,
    pub(crate) max: Vec2,
}

impl Area {
    pub(crate) fn new(left: f32, top: f32, right: f32, bottom: f32) -> Area {
        Area { min: Vec2::new(left, top), max: Vec2::new(right, bottom) }
    }

    pub(crate) fn size(&self) -> Vec2 {
        (self.max - self.min).max(Vec2::ONE)
    }

    /// Smaller by this much on every side.
    pub(crate) fn inset(&self, by: f32) -> Area {
        Area { min: self.min + by, max: self.max - by }
    }

    /// Cut at `height` below its upper edge: what lies above and what lies below.
    pub(crate) fn split_top(&self, height: f32) -> (Area, Area) {
        let y = (self.min.y + height).min(self.max.y);
        (Area { max: Vec2::new(self.max.x, y), ..*self }, Area { min: Vec2::new(self.min.x, y), ..*self })
    }

    /// Its ground, in the look of a role.
    pub(crate) fn fill(&self, figure: &mut Figure, role: Role) {
        figure.add(role, None, Ink::Rect { min: self.min, max: self.max, round: 0.0 });
    }
}

/// Adds the marks of `part` with their origin at `at`.
pub fn set_in(figure: &mut Figure, part: Figure, at: Vec2) {
    for mut mark in part.marks {
        shift(&mut mark.ink, at);
        figure.marks.push(mark);
    }
}

fn shift(ink: &mut Ink, by: Vec2) {
    match ink {
        Ink::Line { points } | Ink::Area { points } => points.iter_mut().for_each(|point| *point += by),
        Ink::Rect { min, max, .. } | Ink::Image { min, max, .. } => {
            *min += by;
            *max += by;
        }
        Ink::Circle { center, .. } => *center += by,
        Ink::Arrowhead { tip, .. } => *tip += by,
        Ink::Formula { at, .. } | Ink::Text { at, .. } => *at += by,
    }
}

/// Makes everything larger by a factor.
pub fn enlarge(figure: &mut Figure, by: f32) {
    figure.size *= by;
    for mark in &mut figure.marks {
        match &mut mark.ink {
            Ink::Line { points } | Ink::Area { points } => points.iter_mut().for_each(|point| *point *= by),
            Ink::Rect { min, max, round } => {
                *min *= by;
                *max *= by;
                *round *= by;
            }
            Ink::Image { min, max, .. } => {
                *min *= by;
                *max *= by;
            }
            Ink::Circle { center, radius } => {
                *center *= by;
                *radius *= by;
            }
            Ink::Arrowhead { tip, length, .. } => {
                *tip *= by;
                *length *= by;
            }
            Ink::Formula { at, size, .. } | Ink::Text { at, size, .. } => {
                *at *= by;
                *size *= by;
            }
        }
    }
}
