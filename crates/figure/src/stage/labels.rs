//! Where labels go: near what they label, inside the picture, off the ray and off each other.

use glam::Vec2;
use raystep_accel::{Aabb, Place};

use super::beside::{
    GAP, beside_box, beside_line, beside_point, beside_shape, further, is_line, is_sheet, on_edges, outline,
};
use super::lens::Lens;
use super::obstacles::{HOPELESS, Obstacles, obstacles};
use super::spot::{ASIDE, HALF, Spot, letters};
use crate::page::{Anchor, Figure, Ink, line};
use crate::theme::{Face, Role, text_width};
use crate::world::{Form, Space};

/// What the pointer is on, in a picture of this size: its name in a label beside the pointer.
pub fn pointed_at(place: Place, pointer: Vec2, size: Vec2) -> Figure {
    let mut figure = Figure::new(size);
    let text = place.to_string();
    let (letters, face) = (letters(size).min(13.0), Face::Medium);
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

/// Sets the labels of a space, the most important first; one that fits nowhere is left out. Returns what is not to be
/// covered any more. `kept` are the corners of a rectangle in which something else will stand.
pub(super) fn place(kept: Option<[Vec2; 2]>, space: &Space, lens: &Lens, figure: &mut Figure) -> Obstacles {
    let size = letters(figure.size);
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
    // Where there are axes, a line is named at its end on them, and nothing else stands there.
    let axes = space.marks.iter().any(|mark| matches!(mark.form, Form::Axes(_)));
    let on_axis = |within: &Option<Aabb>| axes && within.is_some_and(|bounds| is_line(&bounds));
    wanted.sort_by_key(|(role, _, _, within, _)| if on_axis(within) { 0 } else { rank(*role) });
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
        // A box in space is drawn by its edges.
        let solid = within.filter(|bounds| !space.flat && !is_sheet(bounds) && outline(space, place, lens).is_empty());
        let named = named.or_else(|| on_edges(&solid?, lens, spot));
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

fn rank(role: Role) -> u32 {
    match role {
        Role::Here | Role::Guess => 0,
        Role::Best | Role::Hit | Role::Tick | Role::Lane => 1,
        Role::Waiting | Role::Missed => 2,
        _ => 3,
    }
}

/// What it costs to stand beside what a label names, where another place lies.
const BESIDE: f32 = 150.0;

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
