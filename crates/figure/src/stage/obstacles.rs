//! What labels keep off: the ray, planes, other labels, primitives.

use glam::{Vec2, Vec3};
use raystep_accel::Place;

use super::crop::polygon;
use super::lens::Lens;
use super::spot::Spot;
use super::{axes, rulers};
use crate::page::{Figure, Ink};
use crate::theme::{Role, text_width};
use crate::world::{Form, Space};

/// What a label should keep off, and how much it matters.
#[derive(Default)]
pub(super) struct Obstacles {
    pub(super) lines: Vec<(Vec2, Vec2, f32)>,
    pub(super) spots: Vec<(Spot, f32)>,
    /// The primitives of a flat scene: whichever is met next must be seen.
    pub(super) shapes: Vec<(Option<Place>, Ink)>,
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

    /// How many labels a line runs through.
    pub(super) fn labels_on(&self, from: Vec2, to: Vec2) -> usize {
        self.spots.iter().filter(|(spot, weight)| *weight >= HOPELESS && spot.length_of(from, to) > 0.0).count()
    }
}

/// A label that costs as much covers another one or lies outside the picture.
pub(super) const HOPELESS: f32 = 1e4;

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

/// The area of a polygon.
pub(super) fn area(points: &[Vec2]) -> f32 {
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
pub(super) fn obstacles(space: &Space, lens: &Lens, figure: &Figure) -> Obstacles {
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
                found.spots.extend(Spot::over(points).map(|spot| (spot, 10.0)));
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
        found.spots.extend(rulers::names(&around, lens, figure).into_iter().map(|name| (name, HOPELESS)));
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
