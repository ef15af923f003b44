//! The geometry of ink: its outline, its inside, its hatching and how far a pointer is from it.

use egui::epaint::{PathShape, RectShape};
use egui::{Color32, CornerRadius, Pos2, Rect, Shape, Stroke, StrokeKind, vec2};
use glam::Vec2;
use raystep_figure::{Anchor, Face, Ink, text_width};

/// How near to a line the pointer must be, in points.
const NEAR: f32 = 5.0;
/// Distance between two hatching lines, in points.
const HATCH: f32 = 6.0;

fn shift(origin: Pos2, at: Vec2) -> Pos2 {
    origin + vec2(at.x, at.y)
}

/// The outline as a polyline, closed for shapes.
pub(crate) fn path(ink: &Ink, origin: Pos2) -> Vec<Pos2> {
    let mut points = corners(ink);
    if !matches!(ink, Ink::Line { .. })
        && let Some(&first) = points.first()
    {
        points.push(first);
    }
    points.into_iter().map(|at| shift(origin, at)).collect()
}

/// The corners of an outline, without repeating the first.
fn corners(ink: &Ink) -> Vec<Vec2> {
    match ink {
        Ink::Line { points } | Ink::Area { points } => points.clone(),
        Ink::Rect { min, max, round } if *round <= 0.5 => {
            vec![*min, Vec2::new(max.x, min.y), *max, Vec2::new(min.x, max.y)]
        }
        Ink::Rect { min, max, round } => {
            let round = round.min((max.x - min.x) * 0.5).min((max.y - min.y) * 0.5);
            let corner = |center: Vec2, from: u32| {
                (0..=4).map(move |i| {
                    let angle = (from as f32 + i as f32 / 4.0) * std::f32::consts::FRAC_PI_2;
                    center + Vec2::new(angle.cos(), angle.sin()) * round
                })
            };
            let (inner_min, inner_max) = (*min + round, *max - round);
            corner(inner_max, 0)
                .chain(corner(Vec2::new(inner_min.x, inner_max.y), 1))
                .chain(corner(inner_min, 2))
                .chain(corner(Vec2::new(inner_max.x, inner_min.y), 3))
                .collect()
        }
        Ink::Circle { center, radius } => {
            let sides = (radius.sqrt() * 10.0).clamp(12.0, 96.0) as u32;
            let turn = std::f32::consts::TAU / sides as f32;
            (0..sides).map(|i| *center + Vec2::from_angle(turn * i as f32) * *radius).collect()
        }
        Ink::Arrowhead { tip, along, length } => {
            let (back, side) = (*tip - *along * *length, along.perp() * (*length * 0.42));
            vec![*tip, back + side, back - side]
        }
        Ink::Text { .. } | Ink::Formula { .. } | Ink::Image { .. } => Vec::new(),
    }
}

/// The inside.
pub(crate) fn filled(ink: &Ink, origin: Pos2, color: Color32) -> Vec<Shape> {
    match ink {
        Ink::Circle { center, radius } => vec![Shape::circle_filled(shift(origin, *center), *radius, color)],
        Ink::Rect { min, max, round } => {
            let rect = Rect::from_min_max(shift(origin, *min), shift(origin, *max));
            vec![RectShape::filled(rect, CornerRadius::same(*round as u8), color).into()]
        }
        Ink::Area { points } if !is_convex(points) => triangles(points)
            .into_iter()
            .map(|[a, b, c]| {
                let corners = [a, b, c].map(|at| shift(origin, at)).to_vec();
                Shape::convex_polygon(corners, color, Stroke::NONE)
            })
            .collect(),
        ink => {
            let corners = corners(ink).into_iter().map(|at| shift(origin, at)).collect();
            vec![Shape::convex_polygon(corners, color, Stroke::NONE)]
        }
    }
}

/// The outline in one uninterrupted line.
pub(crate) fn stroked(ink: &Ink, origin: Pos2, stroke: Stroke) -> Shape {
    match ink {
        Ink::Circle { center, radius } => Shape::circle_stroke(shift(origin, *center), *radius, stroke),
        Ink::Rect { min, max, round } => {
            let rect = Rect::from_min_max(shift(origin, *min), shift(origin, *max));
            RectShape::stroke(rect, CornerRadius::same(*round as u8), stroke, StrokeKind::Middle).into()
        }
        Ink::Line { points } => {
            let points = points.iter().map(|&at| shift(origin, at)).collect();
            Shape::Path(PathShape::line(points, stroke))
        }
        ink => {
            let points = corners(ink).into_iter().map(|at| shift(origin, at)).collect();
            Shape::Path(PathShape::closed_line(points, stroke))
        }
    }
}

/// Slanting lines clipped to the inside.
pub(crate) fn hatching(ink: &Ink, origin: Pos2) -> Vec<[Pos2; 2]> {
    let corners = corners(ink);
    // A hatching line is x + y = c: where does it cross each side?
    let (low, high) = corners
        .iter()
        .map(|at| at.x + at.y)
        .fold((f32::INFINITY, f32::NEG_INFINITY), |(low, high), c| (low.min(c), high.max(c)));
    let mut lines = Vec::new();
    let first = (low / HATCH).ceil() as i64;
    let last = ((high / HATCH).floor() as i64).min(first + 400);
    for c in (first..=last).map(|i| i as f32 * HATCH) {
        let mut crossings: Vec<Vec2> = Vec::new();
        for (i, &a) in corners.iter().enumerate() {
            let b = corners[(i + 1) % corners.len()];
            let (from, to) = (a.x + a.y - c, b.x + b.y - c);
            if (from < 0.0) != (to < 0.0) {
                crossings.push(a + (b - a) * (from / (from - to)));
            }
        }
        crossings.sort_by(|a, b| a.x.total_cmp(&b.x));
        for pair in crossings.chunks_exact(2) {
            lines.push([shift(origin, pair[0]), shift(origin, pair[1])]);
        }
    }
    lines
}

/// The box around a text that stands in one.
pub(crate) fn text_box(at: Vec2, text: &str, size: f32, face: Face, anchor: Anchor) -> (Vec2, Vec2) {
    let width = text_width(text, face, size);
    let left = match anchor {
        Anchor::Start => at.x,
        Anchor::Middle => at.x - width * 0.5,
        Anchor::End => at.x - width,
    };
    let (pad_x, half) = (size * 0.55, size * 0.8);
    (Vec2::new(left - pad_x, at.y - half), Vec2::new(left + width + pad_x, at.y + half))
}

/// How far the pointer is from the outline of the ink, if that is near; nothing on a label.
pub(crate) fn away(ink: &Ink, pointer: Pos2) -> Option<f32> {
    let at = Vec2::new(pointer.x, pointer.y);
    let away = match ink {
        Ink::Line { points } => {
            points.windows(2).map(|ends| to_segment(at, ends[0], ends[1])).fold(f32::INFINITY, f32::min)
        }
        Ink::Area { points } => {
            let next = points.iter().cycle().skip(1);
            points.iter().zip(next).map(|(&from, &to)| to_segment(at, from, to)).fold(f32::INFINITY, f32::min)
        }
        Ink::Circle { center, radius } => (at.distance(*center) - radius).max(0.0),
        Ink::Text { .. } => return reach(ink, pointer).map(|_| 0.0),
        Ink::Rect { .. } | Ink::Arrowhead { .. } | Ink::Formula { .. } | Ink::Image { .. } => return None,
    };
    (away <= NEAR).then_some(away)
}

/// The size of the ink if the pointer is on it: smaller ink is meant first. Nothing if it is not.
pub(crate) fn reach(ink: &Ink, pointer: Pos2) -> Option<f32> {
    let at = Vec2::new(pointer.x, pointer.y);
    match ink {
        Ink::Line { points } => {
            let near = points.windows(2).any(|ends| to_segment(at, ends[0], ends[1]) <= NEAR);
            near.then_some(NEAR * NEAR)
        }
        Ink::Circle { center, radius } => {
            (at.distance(*center) <= radius.max(NEAR)).then_some(std::f32::consts::PI * radius * radius)
        }
        Ink::Rect { min, max, .. } => {
            let inside = at.cmpge(*min).all() && at.cmple(*max).all();
            inside.then_some((max.x - min.x) * (max.y - min.y))
        }
        Ink::Text { at: anchor_at, text, size, face, anchor, .. } => {
            let (min, max) = text_box(*anchor_at, text, *size, *face, *anchor);
            let inside = at.cmpge(min).all() && at.cmple(max).all();
            inside.then_some((max.x - min.x) * (max.y - min.y))
        }
        Ink::Area { points } => contains(points, at).then(|| area(points)),
        Ink::Arrowhead { .. } | Ink::Formula { .. } | Ink::Image { .. } => None,
    }
}

fn to_segment(at: Vec2, from: Vec2, to: Vec2) -> f32 {
    let along = to - from;
    let length = along.length_squared();
    let part = if length > 0.0 { ((at - from).dot(along) / length).clamp(0.0, 1.0) } else { 0.0 };
    at.distance(from + along * part)
}

fn area(points: &[Vec2]) -> f32 {
    signed_area(points).abs()
}

fn signed_area(points: &[Vec2]) -> f32 {
    (0..points.len()).map(|i| points[i].perp_dot(points[(i + 1) % points.len()])).sum::<f32>() * 0.5
}

fn contains(points: &[Vec2], at: Vec2) -> bool {
    let mut inside = false;
    for (i, &a) in points.iter().enumerate() {
        let b = points[(i + 1) % points.len()];
        if (a.y > at.y) != (b.y > at.y) && at.x < a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x) {
            inside = !inside;
        }
    }
    inside
}

fn is_convex(points: &[Vec2]) -> bool {
    let turn = |i: usize| {
        let (a, b, c) = (points[i], points[(i + 1) % points.len()], points[(i + 2) % points.len()]);
        (b - a).perp_dot(c - b)
    };
    (0..points.len()).all(|i| turn(i) >= 0.0) || (0..points.len()).all(|i| turn(i) <= 0.0)
}

/// A simple polygon cut into triangles, ear by ear.
fn triangles(points: &[Vec2]) -> Vec<[Vec2; 3]> {
    let mut left: Vec<Vec2> = points.to_vec();
    if signed_area(&left) < 0.0 {
        left.reverse();
    }
    let mut cut = Vec::new();
    while left.len() > 3 {
        let n = left.len();
        let ear = (0..n).find(|&i| {
            let (a, b, c) = (left[(i + n - 1) % n], left[i], left[(i + 1) % n]);
            let others = left.iter().filter(|&&p| p != a && p != b && p != c);
            (b - a).perp_dot(c - b) > 0.0 && others.clone().all(|&p| !contains(&[a, b, c], p))
        });
        let Some(i) = ear else { break };
        cut.push([left[(i + n - 1) % n], left[i], left[(i + 1) % n]]);
        left.remove(i);
    }
    if let [a, b, c] = left[..] {
        cut.push([a, b, c]);
    }
    cut
}

#[cfg(test)]
mod tests {
    use egui::pos2;

    use super::*;

    #[test]
    fn a_concave_polygon_is_cut_without_losing_area() {
        let notch = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (2.0, 1.0), (0.0, 4.0)].map(|(x, y)| Vec2::new(x, y));
        assert!(!is_convex(&notch));
        let parts = triangles(&notch);
        assert_eq!(parts.len(), 3);
        assert!((parts.iter().map(|part| area(part)).sum::<f32>() - area(&notch)).abs() < 1e-4);
        assert!(contains(&notch, Vec2::new(3.5, 2.0)) && !contains(&notch, Vec2::new(2.0, 3.0)));
    }

    #[test]
    fn hatching_stays_inside() {
        let disc = Ink::Circle { center: Vec2::new(50.0, 50.0), radius: 20.0 };
        let lines = hatching(&disc, Pos2::ZERO);
        assert!(lines.len() > 6);
        for at in lines.iter().flatten() {
            assert!(at.distance(pos2(50.0, 50.0)) < 20.5);
        }
    }

    #[test]
    fn the_pointer_finds_lines_and_insides() {
        let line = Ink::Line { points: vec![Vec2::ZERO, Vec2::new(10.0, 0.0)] };
        assert!(reach(&line, pos2(5.0, 4.0)).is_some() && reach(&line, pos2(5.0, 9.0)).is_none());
        let rect = Ink::Rect { min: Vec2::ZERO, max: Vec2::splat(10.0), round: 2.0 };
        assert_eq!(reach(&rect, pos2(5.0, 5.0)), Some(100.0));
    }
}
