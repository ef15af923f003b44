//! What is timed beside the rungs: a structure of the textbook with any parameters, a fast one with any instructions.

use raystep_accel::Rule;

use super::entrant::Entrant;
use super::{Outcome, Race, Told};
use crate::{AnyFast, FastKind, Isa, Settings};

/// Something to be timed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Runner<'a> {
    /// A structure of the textbook, on one thread.
    Textbook(&'a Rule),
    /// A fast structure with these instructions, on one thread.
    Alone(FastKind, Isa),
    /// A fast structure with the best instructions, on all threads of the current pool.
    Together(FastKind),
}

impl Race<'_> {
    /// Times a runner over the race's rays, or says in a sentence why it is not timed. Nothing if it shall not go on.
    pub fn time(&self, runner: Runner<'_>) -> Option<Result<Told, String>> {
        if matches!(runner, Runner::Together(_)) && rayon::current_num_threads() < 2 {
            return Some(Err("this machine has one thread".to_owned()));
        }
        let begun = (self.pace.clock)();
        let entrant = match runner {
            Runner::Textbook(rule) => Entrant::Textbook(self.built(rule)?),
            Runner::Alone(kind, isa) => Entrant::Alone(self.fast_of(kind).with(isa)),
            Runner::Together(kind) => Entrant::Together(self.fast_of(kind)),
        };
        let build_ms = ((self.pace.clock)() - begun) * 1e3;
        Some(match self.timed(&entrant, build_ms)? {
            Outcome::Told(told) => Ok(told),
            Outcome::Absent(why) => Err(why.to_owned()),
        })
    }

    fn fast_of(&self, kind: FastKind) -> AnyFast {
        kind.build(self.mesh, &Settings::default())
    }
}
