//! Where labels go: near what they label, inside the picture, off the ray and off each other.

use glam::{Vec2, Vec3};
use raystep_accel::{Aabb, Place};

use super::lens::Lens;
use crate::page::{Anchor, Figure, Ink};
use crate::theme::{Face, Role, text_width};
use crate::world::{Form, Space, contour, corners};

/// Room around a label's text, in sizes of its face, as `print` and the window draw its box.
const ASIDE: f32 = 0.5;
const HALF: f32 = 0.8;

/// Space between a label and what it labels, in points.
const GAP: f32 = 7.0;

/// The directions in which there may be room: the corners first.
const AROUND: [(f32, f32); 8] =
    [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0), (0.0, -1.0), (0.0, 1.0), (-1.0, 0.0), (1.0, 0.0)];

/// A rectangle of the page.
#[derive(Clone, Copy, Debug)]
struct Spot {
    min: Vec2,
    max: Vec2,
}

impl Spot {
    fn around(center: Vec2, half: Vec2) -> Spot {
        Spot { min: center - half, max: center + half }
    }

    fn center(self) -> Vec2 {
        (self.min + self.max) * 0.5
    }

    fn half(self) -> Vec2 {
        (self.max - self.min) * 0.5
    }

    /// The area that two rectangles share.
    fn shared(self, other: Spot) -> f32 {
        let common = (self.max.min(other.max) - self.min.max(other.min)).max(Vec2::ZERO);
        common.x * common.y
    }

    /// Whether all of it lies in a convex polygon.
    fn is_within(self, polygon: &[Vec2]) -> bool {
        let own = [self.min, Vec2::new(self.max.x, self.min.y), self.max, Vec2::new(self.min.x, self.max.y)];
        let next = polygon.iter().cycle().skip(1);
        let side = |(&from, &to): (&Vec2, &Vec2), p: Vec2| (to - from).perp_dot(p - from);
        let sides: Vec<f32> = polygon.iter().zip(next).flat_map(|edge| own.map(|p| side(edge, p))).collect();
        sides.iter().all(|side| *side >= 0.0) || sides.iter().all(|side| *side <= 0.0)
    }

    /// The length of a line inside the rectangle.
    fn length_of(self, from: Vec2, to: Vec2) -> f32 {
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

/// What a label should keep off, and how much it matters.
#[derive(Default)]
struct Obstacles {
    lines: Vec<(Vec2, Vec2, f32)>,
    spots: Vec<(Spot, f32)>,
}

/// Sets the labels of a space, the most important first; one that fits nowhere is left out.
pub(super) fn place(space: &Space, lens: &Lens, figure: &mut Figure) {
    let size = size(figure.size);
    let mut obstacles = obstacles(figure);
    let mut wanted: Vec<_> = space
        .marks
        .iter()
        .filter_map(|mark| match &mark.form {
            Form::Label { at, within, text } => Some((mark.role, mark.place, *at, *within, text)),
            _ => None,
        })
        .collect();
    wanted.sort_by_key(|(role, ..)| rank(*role));
    let mut set = Vec::new();
    for (role, place, at, within, text) in wanted {
        let half = Vec2::new(text_width(text, Face::Medium, size) * 0.5 + size * ASIDE, size * HALF);
        let candidates = match within {
            Some(bounds) => match outline(space, place, lens) {
                shape if shape.is_empty() => beside_box(&bounds, lens, half, space.flat),
                shape => beside_shape(&shape, half, space.flat),
            },
            None => beside_point(
                lens.point(at).map(|(point, _)| point).filter(|point| within_page(*point, figure.size)),
                half,
            ),
        };
        let cost = |index: usize, spot: Spot| index as f32 * 1.5 + obstacles.cost(spot) + outside(spot, figure.size);
        let best = candidates
            .iter()
            .enumerate()
            .map(|(index, &spot)| (cost(index, spot), spot))
            .min_by(|(a, _), (b, _)| a.total_cmp(b));
        let Some((cost, spot)) = best else { continue };
        if cost >= HOPELESS && rank(role) > 1 {
            continue;
        }
        obstacles.spots.push((Spot::around(spot.center(), spot.half() + 2.0), HOPELESS));
        let text = text.clone();
        let ink = Ink::Text { at: spot.center(), text, size, face: Face::Medium, anchor: Anchor::Middle, boxed: true };
        set.push((role, place, ink));
    }
    for (role, place, ink) in set {
        figure.add(role, place, ink);
    }
}

/// Size of the letters in a picture of this size.
pub(super) fn size(page: Vec2) -> f32 {
    (page.y / 42.0).clamp(11.0, 22.0)
}

/// A label that costs as much covers another one or lies outside the picture.
const HOPELESS: f32 = 1e4;

fn rank(role: Role) -> u32 {
    match role {
        Role::Here | Role::Guess => 0,
        Role::Best | Role::Hit | Role::Tick => 1,
        Role::Waiting | Role::Missed => 2,
        _ => 3,
    }
}

impl Obstacles {
    fn cost(&self, spot: Spot) -> f32 {
        let lines: f32 = self.lines.iter().map(|&(from, to, weight)| spot.length_of(from, to) * weight).sum();
        let full = (spot.half().x * spot.half().y * 4.0).max(1.0);
        let spots = self.spots.iter().map(|&(other, weight)| {
            let share = spot.shared(other) / full;
            // Covering a label is out of the question, however little of it.
            if weight >= HOPELESS && share > 0.0 { HOPELESS * (1.0 + share) } else { share * weight }
        });
        lines + spots.sum::<f32>()
    }
}

/// What is drawn already: the ray above all, then rings, planes and primitives.
fn obstacles(figure: &Figure) -> Obstacles {
    let mut found = Obstacles::default();
    for mark in &figure.marks {
        let weight = match mark.role {
            Role::Live => 3.0,
            Role::Ray | Role::Plane => 1.5,
            Role::Here | Role::Waiting => 0.5,
            _ => 0.1,
        };
        match &mark.ink {
            Ink::Line { points } => found.lines.extend(points.windows(2).map(|pair| (pair[0], pair[1], weight))),
            // What bounds a place is a line to keep off, not a surface.
            Ink::Circle { .. } if matches!(mark.place, Some(Place::Node(_))) && !ring_role(mark.role) => {}
            Ink::Area { points } if matches!(mark.place, Some(Place::Node(_))) && mark.role != Role::Plane => {
                let next = points.iter().cycle().skip(1);
                found.lines.extend(points.iter().zip(next).map(|(&from, &to)| (from, to, weight * 0.4)));
            }
            // What is written there already ends on its right.
            Ink::Text { at, text, size, face, .. } => {
                let width = text_width(text, *face, *size);
                let spot = Spot { min: *at - Vec2::new(width, size * 0.6), max: *at + Vec2::new(0.0, size * 0.6) };
                found.spots.push((spot, HOPELESS));
            }
            Ink::Circle { center, radius } => {
                let ring = ring_role(mark.role) && *radius < 10.0;
                found.spots.push((Spot::around(*center, Vec2::splat(*radius)), if ring { 4000.0 } else { 25.0 }));
            }
            Ink::Area { points } if points.len() < 100 && mark.role != Role::Plane => {
                let min = points.iter().copied().fold(Vec2::INFINITY, Vec2::min);
                let max = points.iter().copied().fold(Vec2::NEG_INFINITY, Vec2::max);
                found.spots.push((Spot { min, max }, 10.0));
            }
            Ink::Rect { min, max, .. } => {
                let (a, b) = (Vec2::new(max.x, min.y), Vec2::new(min.x, max.y));
                let sides = [(*min, a), (a, *max), (*max, b), (b, *min)];
                found.lines.extend(sides.into_iter().map(|(from, to)| (from, to, weight * 0.4)));
            }
            _ => {}
        }
    }
    found
}

/// Whether circles of this role are rings around points of the ray.
fn ring_role(role: Role) -> bool {
    matches!(role, Role::Tick | Role::Best | Role::Ray | Role::Hit | Role::Live)
}

/// Whether a point is in the picture.
fn within_page(point: Vec2, size: Vec2) -> bool {
    point.cmpge(Vec2::ZERO).all() && point.cmple(size).all()
}

/// What it costs to reach out of the picture.
fn outside(spot: Spot, size: Vec2) -> f32 {
    let out = (Vec2::splat(2.0) - spot.min).max(Vec2::ZERO) + (spot.max - (size - 2.0)).max(Vec2::ZERO);
    if out == Vec2::ZERO { 0.0 } else { HOPELESS * (1.0 + out.length()) }
}

/// The corners of a flat box, inside where there is room; around the corners of a box in space.
fn beside_box(bounds: &Aabb, lens: &Lens, half: Vec2, flat: bool) -> Vec<Spot> {
    let seen: Vec<Vec2> = corners(bounds).iter().filter_map(|&corner| Some(lens.point(corner)?.0)).collect();
    if seen.is_empty() {
        return Vec::new();
    }
    let min = seen.iter().copied().fold(Vec2::INFINITY, Vec2::min);
    let max = seen.iter().copied().fold(Vec2::NEG_INFINITY, Vec2::max);
    let outer = Spot { min, max };
    let middle = outer.center();
    let mut spots = Vec::new();
    let room = outer.half() - half - GAP;
    if flat && room.min_element() >= 0.0 {
        spots.extend(AROUND.iter().map(|&(x, y)| Spot::around(middle + room * Vec2::new(x, y), half)));
    }
    if !flat {
        for corner in seen {
            let away = (corner - middle).signum();
            spots.push(Spot::around(corner + away * (half + 2.0), half));
        }
    }
    let beyond = outer.half() + half + 3.0;
    let inner = outer.half() - half;
    for &(x, y) in &[(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0), (0.0, -1.0), (0.0, 1.0)] {
        spots.push(Spot::around(middle + Vec2::new(inner.x * x, beyond.y * y), half));
    }
    for &(x, y) in &[(-1.0, 0.0), (1.0, 0.0), (-1.0, -1.0), (1.0, 1.0)] {
        spots.push(Spot::around(middle + Vec2::new(beyond.x * x, inner.y * y), half));
    }
    spots
}

/// Corners of what bounds a place, on the page, if that is no box along the axes; in a flat scene in order.
fn outline(space: &Space, place: Option<Place>, lens: &Lens) -> Vec<Vec2> {
    let of_place = space.marks.iter().filter(|mark| place.is_some() && mark.place == place);
    let mut corners: Vec<Vec3> = Vec::new();
    for mark in of_place {
        match &mark.form {
            Form::Body(edges) => corners.extend(edges.iter().flatten()),
            Form::Sphere(sphere) if space.flat => {
                let away = |angle: f64| Vec3::new(libm::cos(angle) as f32, libm::sin(angle) as f32, 0.0);
                let around = (0..32).map(|i| away(f64::from(i) * std::f64::consts::TAU / 32.0));
                corners = around.map(|away| sphere.center + away * sphere.radius).collect();
            }
            Form::Sphere(sphere) => corners.extend(contour(sphere, lens.eye()).unwrap_or_default()),
            Form::Polygon(around) if space.flat => corners.clone_from(around),
            Form::Segment(from, to) if !space.flat && mark.role != Role::Live && mark.role != Role::Candidate => {
                corners.extend([*from, *to]);
            }
            _ => {}
        }
    }
    corners.into_iter().filter_map(|corner| Some(lens.point(corner)?.0)).collect()
}

/// Within a flat shape where there is room, else around what of it lies furthest out.
fn beside_shape(shape: &[Vec2], half: Vec2, flat: bool) -> Vec<Spot> {
    let furthest = |away: Vec2| shape.iter().copied().max_by(|a, b| a.dot(away).total_cmp(&b.dot(away)));
    let ends = AROUND.iter().filter_map(|&(x, y)| Some((Vec2::new(x, y), furthest(Vec2::new(x, y))?)));
    let ends: Vec<(Vec2, Vec2)> = ends.collect();
    let mut spots = Vec::new();
    for reach in [1.0, 1.5, 2.2].into_iter().filter(|_| flat) {
        let within = ends.iter().map(|&(away, end)| Spot::around(end - away * (half + GAP) * reach, half));
        spots.extend(within.filter(|spot| spot.is_within(shape)));
    }
    spots.extend(ends.iter().map(|&(away, end)| Spot::around(end + away * (half + 3.0), half)));
    spots
}

/// All around a point: above first.
fn beside_point(point: Option<Vec2>, half: Vec2) -> Vec<Spot> {
    let Some(point) = point else { return Vec::new() };
    let near = half + GAP + 2.0;
    let mut spots = Vec::new();
    for reach in [1.0, 1.7, 2.6] {
        for (x, y) in
            [(-0.55, -1.0), (0.55, -1.0), (0.0, -1.0), (0.0, 1.0), (0.55, 1.0), (-0.55, 1.0), (1.0, 0.0), (-1.0, 0.0)]
        {
            spots.push(Spot::around(point + Vec2::new(near.x * x, near.y * y * reach), half));
        }
    }
    spots
}
