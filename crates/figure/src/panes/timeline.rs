//! The walk from its first step to its last, to be scrubbed.

use glam::Vec2;
use raystep_accel::Place;

use super::Ask;
use crate::moments::{Build, Walk};
use crate::page::{Anchor, Figure, Ink, Look, line, write};
use crate::theme::{Face, Role, text_width};
use crate::words::fact::{grow, visit};
use crate::words::{Fact, Symbol, VolumeName};

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
/// a question is open, `hide_ahead` leaves out what is still to come.
pub fn timeline(walk: &Walk<'_>, step: usize, hide_ahead: bool, size: Vec2, look: &Look) -> Figure {
    let volume = VolumeName::of(walk.structure);
    let fact = |step: usize| -> Option<&dyn Fact> { Some(walk.events.get(step - 1)?) };
    let lost = if walk.lost > 0 { format!("not kept: {} more steps", walk.lost) } else { String::new() };
    let tape = Recorded {
        steps: walk.events.len(),
        fact: &fact,
        symbols: visit::SYMBOLS,
        lost: &lost,
        flat: walk.flat,
        volume,
    };
    draw(&tape, step, hide_ahead, size, look)
}

/// The track of a build.
pub fn timeline_of_build(build: &Build<'_>, step: usize, hide_ahead: bool, size: Vec2, look: &Look) -> Figure {
    let volume = VolumeName::of(build.structure);
    let lost = grow::left_out(build.lost, volume);
    let fact = |step: usize| -> Option<&dyn Fact> { Some(build.events.get(step - 1)?) };
    let tape = Recorded {
        steps: build.events.len(),
        fact: &fact,
        symbols: grow::SYMBOLS,
        lost: &lost,
        flat: build.flat,
        volume,
    };
    draw(&tape, step, hide_ahead, size, look)
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
    draw(&Recorded { steps, fact, symbols: &[], lost: "", flat, volume }, step, ask.hide, ask.size, &ask.look)
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

fn draw(tape: &Recorded<'_>, step: usize, hide_ahead: bool, size: Vec2, look: &Look) -> Figure {
    let Recorded { steps, fact, lost, volume, .. } = *tape;
    let mut figure = Figure::new(size);
    let track = Track::new(steps, size, look);
    let (small, u) = (look.small(), look.text);

    // What is shown now, in words.
    let count = format!("step {step} of {steps}");
    let says = if step > 0 { fact(step) } else { None };
    let says = says.map_or("at the very beginning".into(), |fact| fact.short(volume));
    let (above, below) = (Vec2::new(look.margin(), track.y - 0.65 * u), Vec2::new(look.margin(), track.y + 0.75 * u));
    write(&mut figure, Role::Text, None, above, &count, u, Face::Bold, Anchor::Start);
    write(&mut figure, Role::Quiet, None, below, &says, small, Face::Regular, Anchor::Start);

    // The track, its part played so far, and the handle.
    let now = Vec2::new(track.x(step), track.y);
    let (from, to) = (Vec2::new(track.left, track.y), Vec2::new(track.right, track.y));
    figure.add(Role::Edge, None, line(from, to));
    if step > 0 {
        figure.add(Role::Here, None, line(from, now));
    }

    // One symbol for each event that has one; of a crowd, the one that matters most.
    let told = if hide_ahead { step.min(steps) } else { steps };
    for (x, symbol, place) in crowd(told, tape, &track, u * 0.8) {
        let at = Vec2::new(x, track.y - 1.25 * u);
        write(&mut figure, symbol.role, Some(place), at, symbol.sign, u * 0.85, Face::Medium, Anchor::Middle);
    }
    for role in [Role::Page, Role::Here] {
        figure.add(role, None, Ink::Circle { center: now, radius: u * 0.5 });
    }

    let right = if !lost.is_empty() {
        let at = Vec2::new(track.right, track.y + 1.5 * u);
        write(&mut figure, Role::Quiet, None, at, lost, small, Face::Regular, Anchor::End);
        track.right - text_width(lost, Face::Regular, small) - u
    } else {
        track.right
    };
    legend_row(&mut figure, told, tape, Vec2::new(track.left, track.y + 1.5 * u), right, look);
    figure
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

/// The symbols that occur in the first `told` steps, with their names.
fn legend_row(figure: &mut Figure, told: usize, tape: &Recorded<'_>, at: Vec2, right: f32, look: &Look) {
    let (small, mut x) = (look.small(), at.x);
    let mut occur: Vec<Symbol> = Vec::new();
    for symbol in (1..=told).filter_map(|step| (tape.fact)(step)?.symbol()) {
        if !occur.contains(&symbol) {
            occur.push(symbol);
        }
    }
    let rank = |symbol: &Symbol| tape.symbols.iter().position(|known| known == symbol).unwrap_or(usize::MAX);
    occur.sort_by_key(rank);
    for symbol in &occur {
        let name = if *symbol == visit::VOLUME { tape.volume.one } else { symbol.name };
        let width = small * 1.2 + text_width(name, Face::Regular, small);
        if x + width > right {
            break;
        }
        let sign = Vec2::new(x + small * 0.4, at.y);
        write(figure, symbol.role, None, sign, symbol.sign, small, Face::Medium, Anchor::Middle);
        let beside = Vec2::new(x + small * 1.2, at.y);
        write(figure, Role::Quiet, None, beside, name, small, Face::Regular, Anchor::Start);
        x += width + look.text * 1.5;
    }
}
