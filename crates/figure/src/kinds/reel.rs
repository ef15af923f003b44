//! What plays, of whatever kind.

use std::fmt::{Debug, Formatter};

use raystep_accel::{Place, Prims};

use super::{Guess, Instant, Kind, Still};
use crate::panes::Pane;
use crate::words::{Fact, Symbol, VolumeName};

/// Something that is shown step by step: a walk, a build, or any other [`Kind`].
pub struct Reel<'a>(Box<dyn Kind + 'a>);

impl<'a> Reel<'a> {
    /// A reel of this kind.
    pub fn new(kind: impl Kind + 'a) -> Reel<'a> {
        Reel(Box::new(kind))
    }

    /// How many steps it has.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether nothing happens.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The state before the first step.
    pub fn start(&self) -> Instant {
        self.0.start()
    }

    /// The state after the first `step` steps.
    pub fn at(&self, step: usize) -> Instant {
        let mut instant = self.start();
        self.advance(&mut instant, step);
        instant
    }

    /// Lets steps happen until `step` have. Steps already taken are not taken back.
    pub fn advance(&self, instant: &mut Instant, step: usize) {
        self.0.advance(instant, step);
        instant.reach(step.min(self.len()));
    }

    /// Shows the answers of an open question where they lie.
    pub fn guess(&self, instant: &mut Instant, guesses: &[Guess]) {
        self.0.guess(instant, guesses);
    }

    /// The reel at one of its instants, ready to be drawn.
    pub fn still<'b>(&'b self, instant: &'b Instant) -> Still<'b> {
        Still::new(&*self.0, instant)
    }

    /// Whether there is anything to show in a pane.
    pub fn has(&self, pane: Pane) -> bool {
        super::still::has(&*self.0, pane)
    }

    /// The pane in which it is best seen beside space.
    pub fn best(&self) -> Option<Pane> {
        self.0.best()
    }

    /// Whether space is flat.
    pub fn flat(&self) -> bool {
        self.0.flat()
    }

    /// The deepest level of the tree whose boxes a solid picture shows; nothing where there is no such choice.
    pub fn deepest(&self) -> Option<u32> {
        self.0.deepest()
    }

    /// What is tested before anything in it, in a word.
    pub fn volume(&self) -> VolumeName {
        self.0.volume()
    }

    /// What an event of a step says in one sentence; where several structures are walked, of which of them.
    pub fn sentence(&self, step: usize, event: &dyn Fact) -> String {
        let says = event.sentence(self.volume());
        match self.0.whose(step) {
            Some(name) => format!("{name}: {says}"),
            None => says,
        }
    }

    /// The primitives that space is about.
    pub fn prims(&self) -> &Prims {
        self.0.prims()
    }

    /// The steps that show something with this symbol on the timeline.
    pub fn steps_with(&self, symbol: &Symbol) -> Vec<usize> {
        let shown = |fact: &&dyn Fact| !(self.flat() && fact.concerns_z());
        let has = |step: &usize| self.0.fact(*step).filter(shown).is_some_and(|fact| fact.symbol() == Some(*symbol));
        (1..=self.len()).filter(has).collect()
    }

    /// The steps that show something at a place, counted from 1.
    pub fn steps_at(&self, place: Place) -> Vec<usize> {
        (1..=self.len()).filter(|step| self.0.fact(*step).is_some_and(|fact| fact.place() == place)).collect()
    }
}

impl Debug for Reel<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Reel").field("steps", &self.len()).finish_non_exhaustive()
    }
}
