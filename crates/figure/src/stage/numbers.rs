//! The numbers of primitives, cells and nodes of a flat scene, set small into what they name.

use glam::{Vec2, Vec3};
use raystep_accel::{Place, PrimId, Primitives, Prims, Shape};

use super::beside::{AROUND, outline, within_shape};
use super::lens::Lens;
use super::obstacles::{HOPELESS, Obstacles, covered};
use super::spot::{ASIDE, HALF, Spot, letters};
use crate::page::{Anchor, Figure, Ink, write};
use crate::theme::{Face, Role, text_width};
use crate::world::{Form, Space};

/// What it may cost to set a number somewhere: more, and it could not be read, or would hide something.
const MOST: f32 = 25.0;

/// What it costs to stand beside words: less than not to be written.
const BESIDE_WORDS: f32 = 10.0;

/// Of so many primitives one that is too small for its number, or crossed by the ray, has it beside it. Among more it could be another one's.
const FEW: usize = 24;

/// Writes each number of a space where there is room for it beside what is drawn and labelled already.
pub(super) fn set(space: &Space, prims: &Prims, lens: &Lens, figure: &mut Figure, obstacles: &mut Obstacles) {
    for mark in &space.marks {
        let Form::Number { within, text, scale } = &mark.form else { continue };
        let usual = letters(figure.size) * 0.9 * scale;
        let boxed = mark.role == Role::Best;
        let room = |size: f32| {
            let aside = if boxed { Vec2::new(size * ASIDE, size * (HALF - 0.5)) } else { Vec2::ONE };
            let half = Vec2::new(text_width(text, Face::Medium, size), size) * 0.5 + aside;
            let candidates = match mark.place {
                Some(Place::Prim(prim)) if prim.index() < prims.len() => within_prim(prims, prim, lens, half),
                place => match outline(space, place, lens) {
                    shape if shape.is_empty() => within_corners(lens, within.min, within.max, half),
                    shape => within_shape(&shape, half).into_iter().chain(towards_middle(&shape, half)).collect(),
                },
            };
            let on_page = |spot: &Spot| spot.min.cmpge(Vec2::ZERO).all() && spot.max.cmple(figure.size).all();
            let cost = |index: usize, spot: Spot| index as f32 * 0.5 + obstacles.crossed(spot, mark.place);
            let spots = candidates.into_iter().enumerate().filter(|(_, spot)| on_page(spot));
            let best = spots.map(|(index, spot)| (cost(index, spot), spot)).min_by(|(a, _), (b, _)| a.total_cmp(b));
            best.filter(|(cost, _)| *cost < MOST).map(|(_, spot)| (spot, size))
        };
        // In a box it needs more room; a little smaller it may still find it.
        let smaller = || room(usual * 0.84).filter(|_| boxed);
        let Some((spot, size)) = room(usual).or_else(smaller) else { continue };
        obstacles.spots.push((spot, HOPELESS));
        if boxed {
            let (text, face, anchor) = (text.clone(), Face::Medium, Anchor::Middle);
            let ink = Ink::Text { at: spot.center(), text, size, face, anchor, boxed };
            figure.add(mark.role, mark.place, ink);
            continue;
        }
        if is_hatched(figure, mark.place) {
            let radius = spot.half().max_element();
            figure.add(Role::Page, mark.place, Ink::Circle { center: spot.center(), radius });
        }
        write(figure, mark.role, mark.place, spot.center(), text, size, Face::Medium, Anchor::Middle);
    }
}

/// Whether a place is hatched, so that nothing could be read on it.
fn is_hatched(figure: &Figure, place: Option<Place>) -> bool {
    let hatched = |role| matches!(role, Role::Missed | Role::Below | Role::Wrong);
    matches!(place, Some(Place::Prim(_))) && figure.marks.iter().any(|mark| mark.place == place && hatched(mark.role))
}

impl Obstacles {
    /// What it costs to set a number somewhere: what lies under it may show, lines and words may not, and beside words it
    /// would be read with them.
    fn crossed(&self, spot: Spot, place: Option<Place>) -> f32 {
        let lines: f32 = self.lines.iter().map(|&(from, to, weight)| spot.length_of(from, to) * weight.max(0.2)).sum();
        let spots = self.spots.iter().filter(|(other, weight)| *weight > 1000.0 && spot.shared(*other) > 0.0);
        let beside = Spot::around(spot.center(), spot.half() * Vec2::new(3.0, 1.0));
        let by_words = self.spots.iter().any(|(other, weight)| *weight >= HOPELESS && beside.shared(*other) > 0.0);
        let full = spot.shared(spot).max(1.0);
        let others = self.shapes.iter().filter(|(other, _)| place.is_none() || *other != place);
        let shapes = others.map(|(_, shape)| covered(shape, spot) / full * 40.0);
        let words = if by_words { BESIDE_WORDS } else { 0.0 };
        lines + spots.map(|(_, weight)| weight).sum::<f32>() + shapes.sum::<f32>() + words
    }
}

/// Within a flat shape, from its corners on towards its middle.
fn towards_middle(shape: &[Vec2], half: Vec2) -> Vec<Spot> {
    let middle = shape.iter().sum::<Vec2>() / shape.len().max(1) as f32;
    let on_the_way = |share: f32| shape.iter().map(move |corner| Spot::around(corner.lerp(middle, share), half));
    let spots = [0.25, 0.5, 0.75, 1.0].into_iter().flat_map(on_the_way);
    spots.filter(|spot| spot.is_within(shape)).collect()
}

/// Inside a primitive where it is large enough; beside a segment, which has no inside, and beside a disc that has no room.
fn within_prim(prims: &Prims, prim: PrimId, lens: &Lens, half: Vec2) -> Vec<Spot> {
    let page = |at: Vec3| lens.point(at.with_z(0.0)).map(|(at, _)| at);
    let inside = |corners: Vec<Vec3>| {
        let corners: Vec<Vec2> = corners.into_iter().filter_map(page).collect();
        let middle = corners.iter().sum::<Vec2>() / corners.len().max(1) as f32;
        let towards = corners.iter().flat_map(|corner| [0.25, 0.45].map(|share| middle.lerp(*corner, share)));
        let spots = [middle].into_iter().chain(towards).map(|at| Spot::around(at, half));
        spots.filter(|spot| spot.is_within(&corners)).collect()
    };
    match prims.shape(prim) {
        Shape::Sphere(sphere) => {
            let Some(center) = page(sphere.center) else { return Vec::new() };
            let radius = sphere.radius * lens.scale_at(sphere.center);
            let room = radius - half.length() - 1.0;
            let around = AROUND.iter().map(|&(x, y)| Vec2::new(x, y).normalize_or_zero());
            let inside = [Vec2::ZERO].into_iter().chain(around.clone()).map(|way| center + way * room);
            let beside = around.map(|way| center + way * (radius + way.abs().dot(half) + 2.0));
            let spots = inside.filter(|_| room >= 0.0).chain(beside.filter(|_| prims.len() <= FEW));
            spots.map(|at| Spot::around(at, half)).collect()
        }
        Shape::Wall(wall) => {
            let (Some(from), Some(to)) = (page(wall.from.extend(0.0)), page(wall.to.extend(0.0))) else {
                return Vec::new();
            };
            let across = (to - from).normalize_or_zero().perp();
            let beside = across * (across.abs().dot(half) + 3.0);
            let shares = [0.5, 0.35, 0.65, 0.2, 0.8].map(|share| from.lerp(to, share));
            shares.into_iter().flat_map(|at| [at + beside, at - beside]).map(|at| Spot::around(at, half)).collect()
        }
        Shape::Triangle(triangle) => inside(vec![triangle.a, triangle.b, triangle.c]),
        Shape::Prism(prism) => inside(prism.outline.iter().map(|corner| corner.extend(0.0)).collect()),
        shape => {
            let bounds = shape.bounds();
            within_corners(lens, bounds.min, bounds.max, half)
        }
    }
}

/// The corners of a box, from inside: the upper left one first.
fn within_corners(lens: &Lens, min: Vec3, max: Vec3, half: Vec2) -> Vec<Spot> {
    let (Some((a, _)), Some((b, _))) = (lens.point(min.with_z(0.0)), lens.point(max.with_z(0.0))) else {
        return Vec::new();
    };
    let (min, max) = (a.min(b), a.max(b));
    let (middle, room) = ((min + max) * 0.5, (max - min) * 0.5 - half - 3.0);
    if room.min_element() < 0.0 {
        return Vec::new();
    }
    AROUND.iter().map(|&(x, y)| Spot::around(middle + room * Vec2::new(x, y), half)).collect()
}
