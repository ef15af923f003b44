//! A long walk, ready to be shown at any step.

use crate::{Moment, Walk};

/// Moments along a walk from which any other is reached in few events.
#[derive(Clone, Debug)]
pub struct Film {
    every: usize,
    moments: Vec<Moment>,
}

impl Film {
    /// Plays the walk once.
    pub fn new(walk: &Walk<'_>) -> Film {
        let every = (walk.events.len() / 16).max(1024);
        let mut moment = Moment::start(walk);
        let mut moments = vec![moment.clone()];
        for step in (every..=walk.events.len()).step_by(every) {
            moment.advance(walk, step);
            moments.push(moment.clone());
        }
        Film { every, moments }
    }

    /// The same as [`Moment::at`], quicker. `walk` must be the one played.
    pub fn at(&self, walk: &Walk<'_>, step: usize) -> Moment {
        let last = self.moments.len() - 1;
        let mut moment = self.moments[(step / self.every).min(last)].clone();
        moment.advance(walk, step);
        moment
    }
}
