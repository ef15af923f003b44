//! What of a page is drawn on.

use glam::Vec2;
use raystep_figure::{Figure, Ink, Mark, Role};

use crate::formula::extent;
use crate::label::{label_box, span};
use crate::plate::set_in;

/// The corners of what is drawn, upper left and lower right, within the page; nothing where nothing is.
pub fn drawn(figure: &Figure) -> Option<[Vec2; 2]> {
    let all = figure.marks.iter().filter(|mark| !is_ground(mark)).map(corners);
    let all = all.map(|[min, max]| [min.max(Vec2::ZERO), max.min(figure.size)]);
    all.filter(|[min, max]| min.cmple(*max).all()).reduce(around)
}

/// The smallest rectangle around two.
pub fn around(a: [Vec2; 2], b: [Vec2; 2]) -> [Vec2; 2] {
    [a[0].min(b[0]), a[1].max(b[1])]
}

/// The part of a figure between two corners, as a figure of its own.
pub fn part(figure: Figure, [min, max]: [Vec2; 2]) -> Figure {
    let mut part = Figure::new(max - min);
    set_in(&mut part, figure, -min);
    part
}

fn is_ground(mark: &Mark) -> bool {
    matches!(mark.role, Role::Page | Role::Panel)
}

/// The corners of a mark, without the width of its line.
fn corners(mark: &Mark) -> [Vec2; 2] {
    let of = |points: &[Vec2]| {
        let first = [Vec2::INFINITY, Vec2::NEG_INFINITY];
        points.iter().fold(first, |all, point| around(all, [*point, *point]))
    };
    match &mark.ink {
        Ink::Line { points } | Ink::Area { points } => of(points),
        Ink::Rect { min, max, .. } | Ink::Image { min, max, .. } => of(&[*min, *max]),
        Ink::Circle { center, radius } => [*center - *radius, *center + *radius],
        Ink::Arrowhead { tip, length, .. } => [*tip - *length, *tip + *length],
        Ink::Formula { at, tex, size } => {
            let room = extent(tex, *size);
            [*at - Vec2::Y * room.height, *at + Vec2::new(room.width, room.depth)]
        }
        Ink::Text { at, text, size, face, anchor, .. } => {
            let (left, width) = span(*at, text, *face, *size, *anchor);
            let (min, max) = label_box(left, at.y, width, *size);
            [min, max]
        }
    }
}
