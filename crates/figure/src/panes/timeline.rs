//! The walk from its first step to its last, to be scrubbed.

use std::borrow::Cow;

use glam::Vec2;
use raystep_accel::Place;

use super::Ask;
use crate::moments::{Build, Walk};
use crate::page::{Anchor, Figure, Ink, Look, line, write};
use crate::theme::{Face, Role, text_width};
use crate::words::fact::{grow, visit};
use crate::words::{Fact, Symbol, VolumeName, veiled_visit};

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

/// The track of a walk with a symbol for each event that has one, the current step and what it is. While
/// a question is open what is still to come is left out, and before one what it asks for.
pub fn timeline(walk: &Walk<'_>, step: usize, ask: &Ask<'_>) -> Figure {
    let volume = VolumeName::of(walk.structure);
    let fact = |step: usize| -> Option<&dyn Fact> { Some(walk.events.get(step.checked_sub(1)?)?) };
    let now = step.checked_sub(1).and_then(|index| walk.events.get(index));
    let says = now.map(|event| if ask.hide { veiled_visit(event).short(volume) } else { event.short(volume) });
    draw(&of_walk(walk, &not_kept(walk), &fact), step, says, ask)
}

/// The track of a build.
pub fn timeline_of_build(build: &Build<'_>, step: usize, ask: &Ask<'_>) -> Figure {
    let volume = VolumeName::of(build.structure);
    let fact = |step: usize| -> Option<&dyn Fact> { Some(build.events.get(step.checked_sub(1)?)?) };
    let says = fact(step).map(|event| event.short(volume));
    draw(&of_build(build, &grow::left_out(build.lost, volume), &fact), step, says, ask)
}

/// The track of steps of any kind: `fact` says what each shows, the first one being 1.
pub(crate) fn track<'a>(
    steps: usize,
    fact: &'a dyn Fn(usize) -> Option<&'a dyn Fact>,
    volume: VolumeName,
    flat: bool,
    step: usize,
    ask: &Ask<'_>,
) -> Figure {
    let says = step.checked_sub(1).and_then(|_| fact(step)).map(|fact| fact.short(volume));
    let tape = Recorded { steps, fact, symbols: &[], lost: "", flat, volume };
    draw(&tape, step, says, ask)
}

/// What is on a track.
struct Recorded<'a> {
    steps: usize,
    /// What a step shows, the first one being 1.
    fact: &'a dyn Fn(usize) -> Option<&'a dyn Fact>,
    /// The symbols that there are, in the order of a legend; others follow as they come.
    symbols: &'static [Symbol],
    /// Events that were not recorded, in words.
    lost: &'a str,
    flat: bool,
    volume: VolumeName,
}

impl Recorded<'_> {
    /// Up to which step the track says what happens.
    fn told(&self, step: usize, ask: &Ask<'_>) -> usize {
        let ahead = if ask.hide { step } else { ask.told.max(step) };
        ahead.min(self.steps)
    }
}

/// How many steps of a walk were not recorded, in words.
fn not_kept(walk: &Walk<'_>) -> String {
    if walk.lost > 0 { format!("not kept: {} more steps", walk.lost) } else { String::new() }
}

fn of_walk<'a>(walk: &Walk<'_>, lost: &'a str, fact: &'a dyn Fn(usize) -> Option<&'a dyn Fact>) -> Recorded<'a> {
    let volume = VolumeName::of(walk.structure);
    Recorded { steps: walk.events.len(), fact, symbols: visit::SYMBOLS, lost, flat: walk.flat, volume }
}

fn of_build<'a>(build: &Build<'_>, lost: &'a str, fact: &'a dyn Fn(usize) -> Option<&'a dyn Fact>) -> Recorded<'a> {
    let volume = VolumeName::of(build.structure);
    Recorded { steps: build.events.len(), fact, symbols: grow::SYMBOLS, lost, flat: build.flat, volume }
}

fn draw(tape: &Recorded<'_>, step: usize, says: Option<Cow<'static, str>>, ask: &Ask<'_>) -> Figure {
    let Ask { size, ref look, .. } = *ask;
    let Recorded { steps, lost, .. } = *tape;
    let mut figure = Figure::new(size);
    let track = Track::new(steps, size, look);
    let (small, u) = (look.small(), look.text);

    // What is shown now, in words.
    let count = format!("step {step} of {steps}");
    let says = says.unwrap_or("at the very beginning".into());
    let (above, below) = (Vec2::new(look.margin(), track.y - 0.65 * u), Vec2::new(look.margin(), track.y + 0.75 * u));
    write(&mut figure, Role::Text, None, above, &count, u, Face::Bold, Anchor::Start);
    // In smaller letters rather than into the track.
    let fits = (track.left - look.margin() - u) / text_width(&says, Face::Regular, 1.0).max(0.01);
    write(&mut figure, Role::Quiet, None, below, &says, small.min(fits), Face::Regular, Anchor::Start);

    // The track, its part played so far, and the handle.
    let now = Vec2::new(track.x(step), track.y);
    let (from, to) = (Vec2::new(track.left, track.y), Vec2::new(track.right, track.y));
    figure.add(Role::Edge, None, line(from, to));
    if step > 0 {
        figure.add(Role::Here, None, line(from, now));
    }

    // One symbol for each event that has one; of a crowd, the one that matters most.
    let told = tape.told(step, ask);
    for (x, symbol, place) in crowd(told, tape, &track, u * 0.8) {
        let at = Vec2::new(x, track.y - 1.25 * u);
        write(&mut figure, symbol.role, Some(place), at, symbol.sign, u * 0.85, Face::Medium, Anchor::Middle);
    }
    for role in [Role::Page, Role::Here] {
        figure.add(role, None, Ink::Circle { center: now, radius: u * 0.5 });
    }

    if !lost.is_empty() {
        let at = Vec2::new(track.right, track.y + 1.5 * u);
        write(&mut figure, Role::Quiet, None, at, lost, small, Face::Regular, Anchor::End);
    }
    let y = track.y + 1.5 * u;
    for Named { symbol, name, left, .. } in legend_row(told, tape, &track, look) {
        let sign = Vec2::new(left + small * 0.4, y);
        write(&mut figure, symbol.role, None, sign, symbol.sign, small, Face::Medium, Anchor::Middle);
        let beside = Vec2::new(left + small * 1.2, y);
        write(&mut figure, Role::Quiet, None, beside, name, small, Face::Regular, Anchor::Start);
    }
    figure
}

/// The symbol whose name stands at this point of the legend of a walk's timeline.
pub(crate) fn symbol_at(walk: &Walk<'_>, step: usize, ask: &Ask<'_>, point: Vec2) -> Option<Symbol> {
    let fact = |step: usize| -> Option<&dyn Fact> { Some(walk.events.get(step.checked_sub(1)?)?) };
    named_at(&of_walk(walk, &not_kept(walk), &fact), step, ask, point)
}

/// The same on the timeline of a build.
pub(crate) fn symbol_of_build_at(build: &Build<'_>, step: usize, ask: &Ask<'_>, point: Vec2) -> Option<Symbol> {
    let fact = |step: usize| -> Option<&dyn Fact> { Some(build.events.get(step.checked_sub(1)?)?) };
    let lost = grow::left_out(build.lost, VolumeName::of(build.structure));
    named_at(&of_build(build, &lost, &fact), step, ask, point)
}

/// The same on the track of steps of any kind.
pub(crate) fn symbol_on_track<'a>(
    steps: usize,
    fact: &'a dyn Fn(usize) -> Option<&'a dyn Fact>,
    volume: VolumeName,
    flat: bool,
    step: usize,
    ask: &Ask<'_>,
    point: Vec2,
) -> Option<Symbol> {
    named_at(&Recorded { steps, fact, symbols: &[], lost: "", flat, volume }, step, ask, point)
}

fn named_at(tape: &Recorded<'_>, step: usize, ask: &Ask<'_>, point: Vec2) -> Option<Symbol> {
    let look = &ask.look;
    let track = Track::new(tape.steps, ask.size, look);
    if (point.y - track.y - 1.5 * look.text).abs() > look.text * 0.8 {
        return None;
    }
    let named = legend_row(tape.told(step, ask), tape, &track, look);
    named.into_iter().find(|named| (named.left..named.right).contains(&point.x)).map(|named| named.symbol)
}

/// The symbols of the first `told` steps that stand on the track, at least `apart` points from each other.
fn crowd(told: usize, tape: &Recorded<'_>, track: &Track, apart: f32) -> Vec<(f32, Symbol, Place)> {
    let shown = |fact: &&dyn Fact| !(tape.flat && fact.concerns_z());
    let symbol = |step: usize| {
        let fact = (tape.fact)(step).filter(shown)?;
        Some((step, fact.symbol()?, fact.place()))
    };
    let symbols = (1..=told).filter_map(symbol);
    let length = track.right - track.left;
    if length / track.steps.max(1) as f32 >= apart {
        return symbols.map(|(step, symbol, place)| (track.x(step), symbol, place)).collect();
    }
    // More steps than there is room for symbols: one for each stretch of the track.
    let bins = ((length / apart) as usize).clamp(1, MOST);
    let mut best: Vec<Option<(Symbol, Place)>> = vec![None; bins];
    for (step, symbol, place) in symbols {
        let bin = &mut best[step * (bins - 1) / track.steps.max(1)];
        if bin.is_none_or(|(other, _)| symbol.rank > other.rank) {
            *bin = Some((symbol, place));
        }
    }
    let middle = |bin: usize| track.left + (bin as f32 + 0.5) * length / bins as f32;
    let filled = best.into_iter().enumerate();
    filled.filter_map(|(bin, best)| best.map(|(symbol, place)| (middle(bin), symbol, place))).collect()
}

/// A symbol in the legend of a timeline.
struct Named {
    symbol: Symbol,
    name: &'static str,
    left: f32,
    right: f32,
}

/// The symbols that occur in the first `told` steps, with their names, as far as there is room.
fn legend_row(told: usize, tape: &Recorded<'_>, track: &Track, look: &Look) -> Vec<Named> {
    let small = look.small();
    let room = match tape.lost {
        "" => track.right,
        lost => track.right - text_width(lost, Face::Regular, small) - look.text,
    };
    let mut occur: Vec<Symbol> = Vec::new();
    for symbol in (1..=told).filter_map(|step| (tape.fact)(step)?.symbol()) {
        if !occur.contains(&symbol) {
            occur.push(symbol);
        }
    }
    let rank = |symbol: &Symbol| tape.symbols.iter().position(|known| known == symbol).unwrap_or(usize::MAX);
    occur.sort_by_key(rank);
    let mut left = track.left;
    let mut row = Vec::new();
    for symbol in occur {
        let name = if symbol == visit::VOLUME { tape.volume.one } else { symbol.name };
        let right = left + small * 1.2 + text_width(name, Face::Regular, small);
        if right > room {
            break;
        }
        row.push(Named { symbol, name, left, right });
        left = right + look.text * 1.5;
    }
    row
}
