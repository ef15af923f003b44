//! Where a text lies on the page, and the rounded box that it may stand on.

use glam::Vec2;
use raystep_figure::{Anchor, Face, fonts};

/// Radius of the box's corners.
pub(crate) const ROUND: f32 = 4.0;

/// The rounded box around a label's text.
pub(crate) fn label_box(left: f32, middle: f32, width: f32, size: f32) -> (Vec2, Vec2) {
    let (aside, half) = (size * 0.5, size * 0.8);
    (Vec2::new(left - aside, middle - half), Vec2::new(left + width + aside, middle + half))
}

/// Where a text begins, and its width.
pub(crate) fn span(at: Vec2, text: &str, face: Face, size: f32, anchor: Anchor) -> (f32, f32) {
    let width = fonts::text_width(text, face, size);
    let left = match anchor {
        Anchor::Start => at.x,
        Anchor::Middle => at.x - width * 0.5,
        Anchor::End => at.x - width,
    };
    (left, width)
}
