//! A long reel, ready to be shown at any step.

use super::{Instant, Reel};

/// Instants along a reel from which any other is reached in few events.
#[derive(Clone, Debug)]
pub struct Film {
    every: usize,
    instants: Vec<Instant>,
}

impl Film {
    /// Plays the reel once.
    pub fn new(reel: &Reel<'_>) -> Film {
        let every = (reel.len() / 16).max(1024);
        let mut instant = reel.start();
        let mut instants = vec![instant.clone()];
        for step in (every..=reel.len()).step_by(every) {
            reel.advance(&mut instant, step);
            instants.push(instant.clone());
        }
        Film { every, instants }
    }

    /// The same as [`Reel::at`], quicker. `reel` must be the one played.
    pub fn at(&self, reel: &Reel<'_>, step: usize) -> Instant {
        let last = self.instants.len() - 1;
        let mut instant = self.instants[(step / self.every).min(last)].clone();
        reel.advance(&mut instant, step);
        instant
    }
}
