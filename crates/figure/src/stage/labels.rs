//! Where labels go: near what they label, inside the picture, off the ray and off each other.

use glam::{Vec2, Vec3};
use raystep_accel::{Aabb, Place};

use super::axes;
use super::crop::polygon;
use super::lens::Lens;
use super::spot::{ASIDE, HALF, Spot};
use crate::page::{Anchor, Figure, Ink, line};
use crate::theme::{Face, Role, text_width};
use crate::world::{Form, Space, contour, corners};

/// Space between a label and what it labels, in points.
const GAP: f32 = 7.0;

/// The directions in which there may be room: the corners first.
pub(super) const AROUND: [(f32, f32); 8] =
    [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0), (0.0, -1.0), (0.0, 1.0), (-1.0, 0.0), (1.0, 0.0)];

/// Size of the letters in a picture.
pub(super) fn letters(figure: &Figure) -> f32 {
    (figure.size.y / 42.0).clamp(11.0, 22.0)
}

/// What the pointer is on, in a picture of this size: its name in a label beside the pointer.
pub fn pointed_at(place: Place, pointer: Vec2, size: Vec2) -> Figure {
    let mut figure = Figure::new(size);
    let text = place.to_string();
    let (letters, face) = (letters(&figure).min(13.0), Face::Medium);
    let half = Vec2::new(text_width(&text, face, letters) * 0.5 + letters * ASIDE, letters * HALF);
    // Above and to the right of the pointer; below it at the upper edge, inside the picture.
    let up = pointer.y > half.y * 2.0 + 16.0;
    let beside = Vec2::new(half.x + 10.0, if up { -half.y - 10.0 } else { half.y + 20.0 });
    let at = (pointer + beside).clamp(half + 2.0, (size - half - 2.0).max(half + 2.0));
    figure.add(
        Role::Hover,
        Some(place),
        Ink::Text { at, text, size: letters, face, anchor: Anchor::Middle, boxed: true },
    );
    figure
}

/// What a label should keep off, and how much it matters.
#[derive(Default)]
pub(super) struct Obstacles {
    pub(super) lines: Vec<(Vec2, Vec2, f32)>,
    pub(super) spots: Vec<(Spot, f32)>,
    /// The primitives of a flat scene: whichever is met next must be seen.
    pub(super) shapes: Vec<(Option<Place>, Ink)>,
}

/// Sets the labels of a space, the most important first; one that fits nowhere is left out. Returns what is not to be
/// covered any more. `kept` are the corners of a rectangle in which something else will stand.
pub(super) fn place(kept: Option<[Vec2; 2]>, space: &Space, lens: &Lens, figure: &mut Figure) -> Obstacles {
    let size = letters(figure);
    let mut obstacles = obstacles(space, lens, figure);
    obstacles.spots.extend(kept.map(|[min, max]| (Spot { min, max }, HOPELESS)));
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
        // What a label of a flat box names, on the page.
        let own = within.filter(|bounds| space.flat && !is_line(bounds));
        let own = own.and_then(|bounds| Some((lens.point(bounds.min)?.0, lens.point(bounds.max)?.0)));
        let own = own.map(|(a, b)| Spot { min: a.min(b), max: a.max(b) });
        let mut candidates = match within {
            Some(bounds) if space.flat && is_line(&bounds) => beside_line(&bounds, lens, half),
            // A plane of a volume's: its label stands with the plane, not with the volume.
            Some(bounds) if !space.flat && is_sheet(&bounds) => beside_box(&bounds, lens, half, false, false),
            Some(bounds) => match outline(space, place, lens) {
                // A primitive that a label lies in is not seen.
                shape if shape.is_empty() => {
                    let inside = space.flat && !matches!(place, Some(Place::Prim(_)));
                    beside_box(&bounds, lens, half, space.flat, inside)
                }
                shape => beside_shape(&shape, half, space.flat),
            },
            None => beside_point(
                lens.point(at).map(|(point, _)| point).filter(|point| within_page(*point, figure.size)),
                half,
            ),
        };
        // In a crowd there is room only further off.
        candidates.extend(own.into_iter().flat_map(|own| further(own, half)));
        // What would be cut by the picture's edge is moved into it.
        let cut = candidates.iter().filter(|spot| outside(**spot, figure.size) > 0.0);
        let moved: Vec<Spot> = cut.filter_map(|spot| spot.moved_into(figure.size)).collect();
        candidates.extend(moved);
        // In a box there is room for its label: beside it lies another place.
        let is_place = matches!(place, Some(Place::Cell(_) | Place::Node(_)));
        let beside = |spot: Spot| {
            own.filter(|_| is_place).is_some_and(|own| own.shared(spot) < own.shared(own).min(spot.shared(spot)) * 0.9)
        };
        let cost = |index: usize, spot: Spot| {
            let aside = if beside(spot) { BESIDE } else { 0.0 };
            index as f32 * 1.5 + obstacles.cost(spot) + outside(spot, figure.size) + aside
        };
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
        let point = lens.point(at).map(|(point, _)| point).filter(|_| within.is_none());
        let named = point.or_else(|| own.map(|own| own.nearest(spot.center())));
        let far = if point.is_some() { half.y + GAP * 2.0 } else { GAP * 2.0 };
        if let Some(point) = named.filter(|point| spot.nearest(*point).distance(*point) > far) {
            let leader = line(spot.nearest(point), point);
            set.push((Role::Quiet, place, leader));
        }
        let text = text.clone();
        let ink = Ink::Text { at: spot.center(), text, size, face: Face::Medium, anchor: Anchor::Middle, boxed: true };
        set.push((role, place, ink));
    }
    for (role, place, ink) in set {
        figure.add(role, place, ink);
    }
    obstacles
}

/// A label that costs as much covers another one or lies outside the picture.
pub(super) const HOPELESS: f32 = 1e4;

fn rank(role: Role) -> u32 {
    match role {
        Role::Here | Role::Guess => 0,
        Role::Best | Role::Hit | Role::Tick | Role::Lane => 1,
        Role::Waiting | Role::Missed => 2,
        _ => 3,
    }
}

impl Obstacles {
    pub(super) fn cost(&self, spot: Spot) -> f32 {
        let lines: f32 = self.lines.iter().map(|&(from, to, weight)| spot.length_of(from, to) * weight).sum();
        let full = (spot.half().x * spot.half().y * 4.0).max(1.0);
        let spots = self.spots.iter().map(|&(other, weight)| {
            let share = spot.shared(other) / full;
            // Covering a label is out of the question, however little of it.
            if weight >= HOPELESS && share > 0.0 { HOPELESS * (1.0 + share) } else { share * weight }
        });
        let shapes = self.shapes.iter().map(|(_, shape)| match covered(shape, spot) / full {
            share if share <= 0.0 => 0.0,
            share if size(shape) > full * LARGE => 25.0 * share,
            share => SHAPE * (0.2 + share),
        });
        lines + spots.sum::<f32>() + shapes.sum::<f32>()
    }
}

/// What it costs to stand beside what a label names, where another place lies.
const BESIDE: f32 = 150.0;

/// What it costs to cover a primitive of a flat scene.
const SHAPE: f32 = 600.0;

/// A shape so many times as large as a label is seen well enough under it.
const LARGE: f32 = 12.0;

/// The area of a shape.
fn size(shape: &Ink) -> f32 {
    match shape {
        Ink::Circle { radius, .. } => std::f32::consts::PI * radius * radius,
        Ink::Area { points } => area(points),
        _ => 0.0,
    }
}

fn area(points: &[Vec2]) -> f32 {
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).map(|(a, b)| a.perp_dot(*b)).sum::<f32>().abs() * 0.5
}

/// How much of a rectangle a shape lies under.
pub(super) fn covered(shape: &Ink, spot: Spot) -> f32 {
    match shape {
        Ink::Circle { center, radius } if spot.nearest(*center).distance(*center) >= *radius => 0.0,
        Ink::Circle { center, radius } => spot.shared(Spot::around(*center, Vec2::splat(*radius))),
        Ink::Area { points } => area(&polygon(points, spot.min, spot.max)),
        _ => 0.0,
    }
}

/// What is drawn already: the ray above all, then rings, planes and primitives.
fn obstacles(space: &Space, lens: &Lens, figure: &Figure) -> Obstacles {
    let mut found = Obstacles::default();
    let mut here: Option<Spot> = None;
    for mark in &figure.marks {
        let weight: f32 = match mark.role {
            Role::Live | Role::Strand1 | Role::Strand2 | Role::Strand3 | Role::Strand4 => 3.0,
            Role::Ray | Role::Plane | Role::Thread1 | Role::Thread2 | Role::Thread3 | Role::Thread4 => 1.5,
            Role::Here | Role::Waiting | Role::Line => 0.5,
            _ => 0.1,
        };
        let flat_shape = space.flat && matches!(mark.place, Some(Place::Prim(_)));
        match &mark.ink {
            Ink::Line { points } => {
                let weight = if flat_shape { weight.max(6.0) } else { weight };
                found.lines.extend(points.windows(2).map(|pair| (pair[0], pair[1], weight)));
                if matches!((mark.role, mark.place), (Role::Here, Some(Place::Node(_) | Place::Cell(_)))) && !space.flat
                {
                    let all = points.iter().map(|point| Spot { min: *point, max: *point }).chain(here);
                    here = all.reduce(|a, b| Spot { min: a.min.min(b.min), max: a.max.max(b.max) });
                }
            }
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
                if ring_role(mark.role) && *radius < 10.0 {
                    found.spots.push((Spot::around(*center, Vec2::splat(*radius)), 4000.0));
                } else if flat_shape {
                    found.shapes.push((mark.place, mark.ink.clone()));
                } else {
                    found.spots.push((Spot::around(*center, Vec2::splat(*radius)), 25.0));
                }
            }
            Ink::Area { .. } if flat_shape => found.shapes.push((mark.place, mark.ink.clone())),
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
    for mark in &space.marks {
        let Form::Axes(around) = mark.form else { continue };
        let corner = |x: f32, y: f32| lens.point(Vec3::new(x, y, 0.0)).map(|(at, _)| at);
        let ends = [corner(around.max.x, around.min.y), corner(around.min.x, around.max.y)];
        let origin = corner(around.min.x, around.min.y);
        found.lines.extend(ends.into_iter().filter_map(|end| Some((origin?, end?, 2.0))));
    }
    // The axes are drawn afterwards.
    if !space.flat {
        let [min, max] = axes::room(figure.size);
        found.spots.push((Spot { min, max }, HOPELESS));
    }
    // A small place in space must not disappear behind what is said of it.
    let page = figure.size.x * figure.size.y;
    found.spots.extend(here.filter(|spot| spot.shared(*spot) < SMALL * page).map(|spot| (spot, SHAPE)));
    found
}

/// The current place is small in the picture below this part of it.
const SMALL: f32 = 0.05;

/// Whether circles of this role are rings around points of the ray.
fn ring_role(role: Role) -> bool {
    matches!(role, Role::Tick | Role::Best | Role::Ray | Role::Hit | Role::Live)
}

/// Whether a point is in the picture.
fn within_page(point: Vec2, size: Vec2) -> bool {
    point.cmpge(Vec2::ZERO).all() && point.cmple(size).all()
}

/// What it costs to reach out of the picture.
pub(super) fn outside(spot: Spot, size: Vec2) -> f32 {
    let out = (Vec2::splat(2.0) - spot.min).max(Vec2::ZERO) + (spot.max - (size - 2.0)).max(Vec2::ZERO);
    if out == Vec2::ZERO { 0.0 } else { HOPELESS * (1.0 + out.length()) }
}

/// Whether a text lies in a picture of this size with all its letters; what is no text does.
pub(super) fn is_whole(ink: &Ink, size: Vec2) -> bool {
    Spot::of_label(ink).is_none_or(|spot| outside(spot, size) == 0.0)
}

/// Whether a box is a line of a flat scene: a plane seen from above.
fn is_line(bounds: &Aabb) -> bool {
    let extent = bounds.extent();
    (extent.x == 0.0) != (extent.y == 0.0)
}

/// Whether a box is a part of a plane in space.
fn is_sheet(bounds: &Aabb) -> bool {
    bounds.extent().to_array().into_iter().filter(|side| *side == 0.0).count() == 1
}

/// The ends of a line along an axis, beyond it, and beside it near the ends.
fn beside_line(bounds: &Aabb, lens: &Lens, half: Vec2) -> Vec<Spot> {
    let end = |at: Vec3| lens.point(at.with_z(0.0)).map(|(at, _)| at);
    let (Some(from), Some(to)) = (end(bounds.min), end(bounds.max)) else { return Vec::new() };
    let along = (to - from).normalize_or_zero();
    let across = along.perp();
    let out = |at: Vec2, way: Vec2, gap: f32| Spot::around(at + way * (way.abs().dot(half) + gap), half);
    let mut spots = vec![out(from, -along, 4.0), out(to, along, 4.0)];
    for share in [0.0, 1.0, 0.12, 0.88, 0.3, 0.7] {
        let at = from.lerp(to, share);
        let inward = if share < 0.5 { along } else { -along } * (along.abs().dot(half) + 4.0);
        spots.extend([across, -across].map(|way| out(at + inward, way, 4.0)));
    }
    spots
}

/// The corners of a flat box, inside where there is room; around the corners of a box in space.
fn beside_box(bounds: &Aabb, lens: &Lens, half: Vec2, flat: bool, inside: bool) -> Vec<Spot> {
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
    if inside && room.min_element() >= 0.0 {
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

/// All around a flat box, at some distance.
fn further(own: Spot, half: Vec2) -> Vec<Spot> {
    let at = |gap: f32| {
        AROUND.iter().map(move |&(x, y)| Spot::around(own.center() + (own.half() + half + gap) * Vec2::new(x, y), half))
    };
    [18.0, 36.0, 60.0].into_iter().flat_map(at).collect()
}

/// Corners of what bounds a place, on the page, if that is no box along the axes; in a flat scene in order.
pub(super) fn outline(space: &Space, place: Option<Place>, lens: &Lens) -> Vec<Vec2> {
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
    let mut spots = if flat { within_shape(shape, half) } else { Vec::new() };
    spots.extend(ends(shape).into_iter().map(|(away, end)| Spot::around(end + away * (half + 3.0), half)));
    spots
}

/// Within a flat shape, near what of it lies furthest out.
pub(super) fn within_shape(shape: &[Vec2], half: Vec2) -> Vec<Spot> {
    let within = |reach: f32| {
        let spots =
            ends(shape).into_iter().map(move |(away, end)| Spot::around(end - away * (half + GAP) * reach, half));
        spots.filter(|spot| spot.is_within(shape))
    };
    [1.0, 1.5, 2.2].into_iter().flat_map(within).collect()
}

/// What of a shape lies furthest out in each direction.
fn ends(shape: &[Vec2]) -> Vec<(Vec2, Vec2)> {
    let furthest = |away: Vec2| shape.iter().copied().max_by(|a, b| a.dot(away).total_cmp(&b.dot(away)));
    AROUND.iter().filter_map(|&(x, y)| Some((Vec2::new(x, y), furthest(Vec2::new(x, y))?))).collect()
}

/// All around a point: above first.
pub(super) fn beside_point(point: Option<Vec2>, half: Vec2) -> Vec<Spot> {
    let Some(point) = point else { return Vec::new() };
    let near = half + GAP + 2.0;
    let mut spots = Vec::new();
    for reach in [1.0, 1.7, 2.6, 3.8, 5.4] {
        for (x, y) in
            [(-0.55, -1.0), (0.55, -1.0), (0.0, -1.0), (0.0, 1.0), (0.55, 1.0), (-0.55, 1.0), (1.0, 0.0), (-1.0, 0.0)]
        {
            spots.push(Spot::around(point + Vec2::new(near.x * x, near.y * y * reach), half));
        }
    }
    spots
}
