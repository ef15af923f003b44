//! The walk from its first step to its last, to be scrubbed.

use glam::Vec2;
use raystep_accel::Visit;

use crate::glyph::Glyph;
use crate::look::{line, write};
use crate::{Anchor, Face, Figure, Ink, Look, Role, Walk, short, text_width};

/// Most symbols on one track.
const MOST: usize = 240;

/// Where the steps lie on the track of a timeline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Track {
    /// The x of step 0, in points.
    pub left: f32,
    /// The x of the last step.
    pub right: f32,
    /// The y of the track.
    pub y: f32,
    /// How many steps there are.
    pub steps: usize,
}

impl Track {
    /// The track of a timeline drawn at this size for a walk of so many events.
    pub fn new(steps: usize, size: Vec2, look: &Look) -> Track {
        let left = look.margin() + look.text * 13.5;
        let right = (size.x - look.margin() - look.text * 0.6).max(left + 1.0);
        Track { left, right, y: (size.y * 0.5).round(), steps }
    }

    /// Where a step lies.
    pub fn x(&self, step: usize) -> f32 {
        self.left + (self.right - self.left) * step as f32 / self.steps.max(1) as f32
    }

    /// The step nearest to `x`.
    pub fn step_at(&self, x: f32) -> usize {
        let part = ((x - self.left) / (self.right - self.left)).clamp(0.0, 1.0);
        (part * self.steps as f32).round() as usize
    }
}

/// The track with a symbol for each event that has one, the current step and what it is.
pub fn timeline(walk: &Walk<'_>, step: usize, size: Vec2, look: &Look) -> Figure {
    let events = walk.events;
    let mut figure = Figure::new(size);
    let track = Track::new(events.len(), size, look);
    let (small, u) = (look.small(), look.text);

    // What is shown now, in words.
    let count = format!("step {step} of {}", events.len());
    let says = match step.checked_sub(1).and_then(|i| events.get(i)) {
        Some(event) => short(event),
        None => "before the walk",
    };
    let left = look.margin();
    write(&mut figure, Role::Text, None, Vec2::new(left, track.y - 0.65 * u), &count, u, Face::Bold, Anchor::Start);
    write(
        &mut figure,
        Role::Quiet,
        None,
        Vec2::new(left, track.y + 0.75 * u),
        says,
        small,
        Face::Regular,
        Anchor::Start,
    );

    // The track, its part played so far, and the handle.
    let now = Vec2::new(track.x(step), track.y);
    let (from, to) = (Vec2::new(track.left, track.y), Vec2::new(track.right, track.y));
    figure.add(Role::Edge, None, line(from, to));
    if step > 0 {
        figure.add(Role::Here, None, line(from, now));
    }

    // One symbol for each event that has one; of a crowd, the one that matters most.
    let above = track.y - 1.25 * u;
    for (at, glyph, place) in crowd(walk, &track, u * 0.8) {
        write(
            &mut figure,
            glyph.role(),
            place,
            Vec2::new(at, above),
            glyph.symbol(),
            u * 0.85,
            Face::Medium,
            Anchor::Middle,
        );
    }
    for role in [Role::Page, Role::Here] {
        figure.add(role, None, Ink::Circle { center: now, radius: u * 0.5 });
    }

    legend_row(&mut figure, events, Vec2::new(track.left, track.y + 1.5 * u), track.right, look);
    figure
}

/// The symbols that stand on the track, at least `apart` points from each other.
fn crowd(walk: &Walk<'_>, track: &Track, apart: f32) -> Vec<(f32, Glyph, Option<raystep_accel::Place>)> {
    let bins = (((track.right - track.left) / apart) as usize).clamp(1, MOST);
    let dense = (track.right - track.left) / (track.steps.max(1) as f32) < apart;
    let shown = |event: &Visit| Glyph::of(event).filter(|_| !(walk.flat && event.concerns_z()));
    let events = walk.events.iter().enumerate();
    let symbols = events.filter_map(|(i, event)| Some((i + 1, shown(event)?, event.place())));
    if !dense {
        return symbols.map(|(step, glyph, place)| (track.x(step), glyph, Some(place))).collect();
    }
    let mut best: Vec<Option<(Glyph, raystep_accel::Place)>> = vec![None; bins];
    for (step, glyph, place) in symbols {
        let bin = &mut best[(step * (bins - 1)) / track.steps.max(1)];
        if bin.is_none_or(|(other, _)| glyph > other) {
            *bin = Some((glyph, place));
        }
    }
    let width = (track.right - track.left) / bins as f32;
    let middle = |bin: usize| track.left + (bin as f32 + 0.5) * width;
    best.iter()
        .enumerate()
        .filter_map(|(bin, best)| best.map(|(glyph, place)| (middle(bin), glyph, Some(place))))
        .collect()
}

/// The symbols that occur, with their names.
fn legend_row(figure: &mut Figure, events: &[Visit], at: Vec2, right: f32, look: &Look) {
    let (small, mut x) = (look.small(), at.x);
    for glyph in Glyph::ALL.into_iter().filter(|glyph| events.iter().any(|event| Glyph::of(event) == Some(*glyph))) {
        let width = small * 1.2 + text_width(glyph.name(), Face::Regular, small);
        if x + width > right {
            break;
        }
        let symbol = Vec2::new(x + small * 0.4, at.y);
        write(figure, glyph.role(), None, symbol, glyph.symbol(), small, Face::Medium, Anchor::Middle);
        let beside = Vec2::new(x + small * 1.2, at.y);
        write(figure, Role::Quiet, None, beside, glyph.name(), small, Face::Regular, Anchor::Start);
        x += width + look.text * 1.5;
    }
}
