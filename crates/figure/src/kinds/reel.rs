//! What was recorded, a walk or a build, and its state at one step.

use raystep_accel::{Event, Grow, Place, Prims, Structure, Visit};

use super::Still;
use crate::moments::{Build, GrowMoment, Moment, Walk};
use crate::words::{Fact, Symbol, VolumeName};

/// A walk or a build. The views ask this one and need not know which.
#[derive(Clone, Copy)]
pub enum Reel<'a> {
    /// A ray walks.
    Walk(Walk<'a>),
    /// A structure is built.
    Build(Build<'a>),
}

/// The state of a reel after some of its events.
#[derive(Clone, Debug, PartialEq)]
pub enum Instant {
    /// Of a walk.
    Walk(Moment),
    /// Of a build.
    Build(GrowMoment),
}

impl<'a> Reel<'a> {
    /// How many events it has.
    pub fn len(&self) -> usize {
        match self {
            Reel::Walk(walk) => walk.events.len(),
            Reel::Build(build) => build.events.len(),
        }
    }

    /// Whether nothing happens.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The state before the first event.
    pub fn start(&self) -> Instant {
        match self {
            Reel::Walk(walk) => Instant::Walk(Moment::start(walk)),
            Reel::Build(_) => Instant::Build(GrowMoment::default()),
        }
    }

    /// The state after the first `step` events.
    pub fn at(&self, step: usize) -> Instant {
        let mut instant = self.start();
        self.advance(&mut instant, step);
        instant
    }

    /// Lets events happen until `step` have. An instant of the other kind stays as it is.
    pub fn advance(&self, instant: &mut Instant, step: usize) {
        match (self, instant) {
            (Reel::Walk(walk), Instant::Walk(moment)) => moment.advance(walk, step),
            (Reel::Build(build), Instant::Build(moment)) => moment.advance(build.events, step),
            _ => {}
        }
    }

    /// The reel at one of its instants, ready to be drawn.
    pub fn still<'b>(&'b self, instant: &'b Instant) -> Still<'b> {
        match (self, instant) {
            (Reel::Walk(walk), Instant::Walk(moment)) => Still::Walk(walk, moment),
            (Reel::Build(build), Instant::Build(moment)) => Still::Build(build, moment),
            _ => unreachable!("an instant belongs to the reel that made it"),
        }
    }

    /// Whether the scene is flat.
    pub fn flat(&self) -> bool {
        match self {
            Reel::Walk(walk) => walk.flat,
            Reel::Build(build) => build.flat,
        }
    }

    /// What the ray walks through, or what the build ends in.
    pub fn structure(&self) -> &'a Structure {
        match self {
            Reel::Walk(walk) => walk.structure,
            Reel::Build(build) => build.structure,
        }
    }

    /// What its structure's volumes are called.
    pub fn volume(&self) -> VolumeName {
        VolumeName::of(self.structure())
    }

    /// What the structure is built over.
    pub fn prims(&self) -> &'a Prims {
        match self {
            Reel::Walk(walk) => walk.prims,
            Reel::Build(build) => build.prims,
        }
    }

    /// The steps whose events have this symbol on the timeline.
    pub fn steps_with(&self, symbol: &Symbol) -> Vec<usize> {
        fn steps<E: Fact>(events: &[E], symbol: &Symbol, flat: bool) -> Vec<usize> {
            let has = |event: &E| event.symbol().as_ref() == Some(symbol) && !(flat && event.concerns_z());
            events.iter().enumerate().filter(|(_, event)| has(event)).map(|(index, _)| index + 1).collect()
        }
        match self {
            Reel::Walk(walk) => steps(walk.events, symbol, walk.flat),
            Reel::Build(build) => steps(build.events, symbol, build.flat),
        }
    }

    /// The steps at which something happened at a place: each is the number of the event, counted from 1.
    pub fn steps_at(&self, place: Place) -> Vec<usize> {
        let steps = |places: &mut dyn Iterator<Item = Place>| -> Vec<usize> {
            places.enumerate().filter(|(_, at)| *at == place).map(|(index, _)| index + 1).collect()
        };
        match self {
            Reel::Walk(walk) => steps(&mut walk.events.iter().map(Visit::place)),
            Reel::Build(build) => steps(&mut build.events.iter().map(Grow::place)),
        }
    }
}

impl Instant {
    /// How many events have happened.
    pub fn step(&self) -> usize {
        match self {
            Instant::Walk(moment) => moment.step,
            Instant::Build(moment) => moment.step,
        }
    }

    /// The last of them: what this step shows.
    pub fn event(&self) -> Option<Event> {
        match self {
            Instant::Walk(moment) => moment.event.map(Event::Walk),
            Instant::Build(moment) => moment.event.map(Event::Build),
        }
    }
}
