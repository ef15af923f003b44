//! A small picture in a corner of a large one.

use glam::{Vec2, Vec3};

use super::lens::Lens;
use super::{Camera, crop};
use crate::page::{Anchor, Figure, Ink};
use crate::theme::{Face, Role, text_width};

/// Distance from the corner, in points.
const CORNER: f32 = 12.0;

/// Height of a small picture's title at its foot, in points.
pub(super) const FOOT: f32 = 20.0;

/// A small picture that is not so many times as large repeats what the large one shows.
const NEARER: f32 = 1.5;

/// How large a small picture is in one of this size; nothing where there is no room for it.
pub fn inset_size(page: Vec2) -> Option<Vec2> {
    let fits = page.x >= 420.0 && page.y >= 330.0;
    fits.then(|| Vec2::new((page.x * 0.3).clamp(170.0, 300.0), (page.y * 0.34).clamp(130.0, 240.0)))
}

/// Whether a small picture shows more of a point than the large one does, or that lies outside of the large one: each is a
/// camera and the size of its picture.
pub fn is_nearer(at: Vec3, small: (&Camera, Vec2), large: (&Camera, Vec2)) -> bool {
    let [near, whole] = [small, large].map(|(camera, size)| Lens::new(camera, size));
    let seen = whole.point(at).is_some_and(|(at, _)| at.cmpge(Vec2::ZERO).all() && at.cmple(large.1).all());
    !seen || near.scale_at(at) >= NEARER * whole.scale_at(at)
}

/// Where a small picture of this size stands in a large one: in the upper corner that holds less.
pub fn inset_at(figure: &Figure, size: Vec2) -> Vec2 {
    let right = Vec2::new(figure.size.x - size.x - CORNER, CORNER);
    let crowded = |at: &Vec2| covered(figure, *at, *at + size);
    [right, Vec2::splat(CORNER)].into_iter().min_by_key(crowded).unwrap_or(right)
}

/// Sets a small picture into a large one, with its title at its foot.
pub fn set_inset(figure: &mut Figure, at: Vec2, mut part: Figure, title: &str) {
    let size = part.size;
    crop(&mut part, 0.0);
    let frame = Ink::Rect { min: at, max: at + size, round: 4.0 };
    figure.add(Role::Page, None, frame.clone());
    figure.marks.extend(part.marks.into_iter().map(|mark| mark.moved(at)));
    figure.add(Role::Edge, None, frame);
    let wide = text_width(title, Face::Medium, 12.0);
    let (min, max) = (at + Vec2::new(1.0, size.y - FOOT), at + Vec2::new(wide + 14.0, size.y - 1.0));
    figure.add(Role::Page, None, Ink::Rect { min, max, round: 3.0 });
    let text = Ink::Text {
        at: at + Vec2::new(8.0, size.y - 11.0),
        text: title.to_owned(),
        size: 12.0,
        face: Face::Medium,
        anchor: Anchor::Start,
        boxed: false,
    };
    figure.add(Role::Quiet, None, text);
}

/// How much would be covered by a rectangle: labels count most.
fn covered(figure: &Figure, min: Vec2, max: Vec2) -> usize {
    let inside = |point: Vec2| point.cmpge(min).all() && point.cmple(max).all();
    let on_line = |from: Vec2, to: Vec2| (0..=16).filter(|i| inside(from.lerp(to, *i as f32 / 16.0))).count();
    let each = figure.marks.iter().map(|mark| match &mark.ink {
        Ink::Text { at, size, text, .. } => {
            let half = Vec2::new(text_width(text, Face::Medium, *size) * 0.5, *size);
            if (*at + half).cmpge(min).all() && (*at - half).cmple(max).all() { 1000 } else { 0 }
        }
        Ink::Circle { center, .. } if inside(*center) => 100,
        Ink::Line { points } => points.windows(2).map(|ends| on_line(ends[0], ends[1])).sum(),
        _ => 0,
    });
    each.sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_small_picture_is_nearer_where_it_shows_more() {
        let seen_from = |distance: f32| Camera::Solid {
            eye: Vec3::NEG_Y * distance,
            target: Vec3::ZERO,
            up: Vec3::Z,
            fov_degrees: 40.0,
        };
        let (small, large) = (Vec2::new(300.0, 240.0), Vec2::new(1000.0, 720.0));
        let nearer = |at, distance| is_nearer(at, (&seen_from(distance), small), (&seen_from(10.0), large));
        // A third as high, it must be seen from less than a third as far to be as large.
        assert!(nearer(Vec3::ZERO, 2.0) && !nearer(Vec3::ZERO, 3.0));
        // What lies beside the large picture is seen nowhere else.
        assert!(nearer(Vec3::X * 20.0, 3.0));
    }
}
