//! What a slide plays: a ray's walk, or the building of its structure.

use raystep_accel::{Grow, Visit};

/// Names of events, each group with the fields that they have.
type Vocabulary = &'static [(&'static [&'static str], &'static [&'static str])];

/// What a slide plays.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Plays {
    /// A ray's walk through the finished structure.
    #[default]
    Walk,
    /// The building of the structure; there is no ray.
    Build,
}

impl Plays {
    /// Both.
    pub const ALL: [Plays; 2] = [Plays::Walk, Plays::Build];

    /// How a slide writes it, and what it is called.
    pub fn name(self) -> &'static str {
        match self {
            Plays::Walk => "walk",
            Plays::Build => "build",
        }
    }

    /// The events that can happen in it.
    pub(crate) fn vocabulary(self) -> Vocabulary {
        match self {
            Plays::Walk => Visit::NAMES,
            Plays::Build => Grow::NAMES,
        }
    }
}
