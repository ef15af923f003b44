//! Where labels go: near what they label, inside the picture, off the ray and off each other.

use glam::Vec2;
use raystep_accel::{Aabb, Place};

use super::beside::{GAP, beside_point, is_line};
use super::lens::Lens;
use super::named::Named;
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
    // What leads to labels lies below all of them.
    let (mut leaders, mut labels) = (Vec::new(), Vec::new());
    for (role, place, at, within, text) in wanted {
        let half = Vec2::new(text_width(text, Face::Medium, size) * 0.5 + size * ASIDE, size * HALF);
        let own = within.map(|bounds| Named::new(bounds, place, space, lens, figure));
        let mut candidates = match &own {
            Some(own) => own.candidates(half),
            None => beside_point(
                lens.point(at).map(|(point, _)| point).filter(|point| within_page(*point, figure.size)),
                half,
            ),
        };
        // What would be cut by the picture's edge is moved into it.
        let cut = candidates.iter().filter(|spot| outside(**spot, figure.size) > 0.0);
        let moved: Vec<Spot> = cut.filter_map(|spot| spot.moved_into(figure.size)).collect();
        candidates.extend(moved);
        let point = lens.point(at).map(|(point, _)| point).filter(|_| within.is_none());
        let far = if point.is_some() { half.y + GAP * 2.0 } else { GAP * 2.0 };
        let leader = |spot: Spot| {
            let named = point.or_else(|| own.as_ref()?.nearest(spot))?;
            let from = spot.nearest(named);
            (from.distance(named) > far).then_some((from, named))
        };
        let cost = |index: usize, spot: Spot| {
            let aside = if own.as_ref().is_some_and(|own| own.is_beside(spot)) { BESIDE } else { 0.0 };
            let led = leader(spot).map_or(0.0, |(from, to)| LED * obstacles.labels_on(from, to) as f32);
            index as f32 * 1.5 + obstacles.cost(spot) + outside(spot, figure.size) + aside + led
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
        if let Some((from, to)) = leader(spot) {
            leaders.push((Role::Quiet, place, line(from, to)));
            obstacles.lines.push((from, to, 1.5));
        }
        obstacles.spots.push((Spot::around(spot.center(), spot.half() + 2.0), HOPELESS));
        let text = text.clone();
        let ink = Ink::Text { at: spot.center(), text, size, face: Face::Medium, anchor: Anchor::Middle, boxed: true };
        labels.push((role, place, ink));
    }
    for (role, place, ink) in leaders.into_iter().chain(labels) {
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

/// What it costs to be led to through another label.
const LED: f32 = 60.0;

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
