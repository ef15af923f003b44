//! Coordinates of a flat scene: an axis below and one to the left, with round numbers.

use glam::{Vec2, Vec3};
use raystep_accel::Aabb;

use super::lens::Lens;
use super::spot::{Spot, letters};
use crate::page::{Anchor, Figure, Ink, Ticks, line, write};
use crate::theme::{Face, Role};
use crate::words::number;
use crate::world::{Form, Space};

/// Where the names of the axes stand that a flat space asks for.
pub(super) fn names(around: &Aabb, lens: &Lens, figure: &Figure) -> Vec<Spot> {
    let Some([left, right, bottom, top]) = sides(around, lens, figure) else { return Vec::new() };
    let u = letters(figure.size);
    let at = [Vec2::new(right + u * 0.8, bottom + u * 1.2), Vec2::new(left - u * 0.9, top - u * 0.8)];
    at.map(|at| Spot::around(at, Vec2::splat(u * 0.6))).to_vec()
}

/// The sides of the axes on the page: however the picture is shifted, they stay in it, with their arrows. Nothing where
/// there is no room for them.
fn sides(around: &Aabb, lens: &Lens, figure: &Figure) -> Option<[f32; 4]> {
    let (low, high) = (corner(lens, around, around.min)?, corner(lens, around, around.max)?);
    let u = letters(figure.size);
    let (left, bottom) = (low.x.max(u * 3.0), low.y.min(figure.size.y - u * 2.0));
    let (right, top) = (high.x.min(figure.size.x - u * 1.2), high.y.max(u * 1.6));
    let room = right - left >= u * 4.0 && bottom - top >= u * 4.0;
    room.then_some([left, right, bottom, top])
}

/// Draws the axes that a flat space asks for. Where labels stand on an axis, they take the place of its numbers; a number
/// that a line runs through has a plate.
pub(super) fn draw(space: &Space, lens: &Lens, figure: &mut Figure) {
    let around = space.marks.iter().filter(|_| space.flat).find_map(|mark| match mark.form {
        Form::Axes(around) => Some(around),
        _ => None,
    });
    let Some(around) = around else { return };
    let labels: Vec<Spot> = figure.marks.iter().filter_map(|mark| Spot::of_label(&mark.ink)).collect();
    let lines: Vec<(Vec2, Vec2)> = figure.marks.iter().flat_map(|mark| edges(&mark.ink)).collect();
    let (Some(low), Some(high)) = (corner(lens, &around, around.min), corner(lens, &around, around.max)) else {
        return;
    };
    let u = letters(figure.size);
    let Some([left, right, bottom, top]) = sides(&around, lens, figure) else { return };
    let origin = Vec2::new(left, bottom);
    let along = |from: f32, to: f32, low: f32, high: f32, at: f32| low + (high - low) * (at - from) / (to - from);
    let x = |at| along(low.x, high.x, around.min.x, around.max.x, at);
    let y = |at| along(low.y, high.y, around.min.y, around.max.y, at);
    let axes = [
        ("x", Vec2::X, Ticks { low: x(left), high: x(right), left, right }),
        ("y", Vec2::NEG_Y, Ticks { low: y(bottom), high: y(top), left: bottom, right: top }),
    ];
    for (name, way, ticks) in axes {
        let out = Vec2::new(-way.y.abs(), way.x.abs());
        let place =
            |value: f32| if way.x == 0.0 { Vec2::new(left, ticks.x(value)) } else { Vec2::new(ticks.x(value), bottom) };
        let end = place(ticks.high) + way * u * 0.6;
        figure.add(Role::Edge, None, line(origin, end));
        figure.add(Role::Edge, None, Ink::Arrowhead { tip: end + way * u * 0.4, along: way, length: u * 0.7 });
        let anchor = if way.x == 0.0 { Anchor::End } else { Anchor::Middle };
        let beside = |at: Vec2| at + out * if way.x == 0.0 { u * 0.6 } else { u * 1.2 };
        let measure = Ticks { left: 0.0, right: (ticks.right - ticks.left).abs(), ..ticks };
        for value in measure.marks(u * 4.0) {
            let at = place(value);
            // No number under the tip of an arrow.
            if (end - at).length() < u {
                continue;
            }
            figure.add(Role::Edge, None, line(at, at + out * u * 0.35));
            let said = Spot::of_text(beside(at), &number(value), u * 0.92, Face::Regular, anchor);
            if labels.iter().any(|label| label.shared(said) > 0.0) {
                continue;
            }
            let (at, text, size, face) = (beside(at), number(value), u * 0.92, Face::Regular);
            let boxed = lines.iter().any(|(from, to)| said.length_of(*from, *to) > 0.0);
            figure.add(Role::Quiet, None, Ink::Text { at, text, size, face, anchor, boxed });
        }
        write(figure, Role::Quiet, None, beside(end + way * u * 0.2), name, u, Face::Medium, anchor);
    }
}

/// The straight lines of a shape.
fn edges(ink: &Ink) -> Vec<(Vec2, Vec2)> {
    match ink {
        Ink::Line { points } => points.windows(2).map(|ends| (ends[0], ends[1])).collect(),
        Ink::Area { points } => points.iter().zip(points.iter().cycle().skip(1)).map(|(a, b)| (*a, *b)).collect(),
        Ink::Rect { min, max, .. } => {
            let (a, b) = (Vec2::new(max.x, min.y), Vec2::new(min.x, max.y));
            vec![(*min, a), (a, *max), (*max, b), (b, *min)]
        }
        _ => Vec::new(),
    }
}

fn corner(lens: &Lens, around: &Aabb, at: Vec3) -> Option<Vec2> {
    let seen = lens.point(at.with_z(0.0)).map(|(at, _)| at);
    seen.filter(|_| !around.is_empty())
}
