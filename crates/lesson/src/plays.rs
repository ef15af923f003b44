//! What a slide plays: a ray's walk, that of several rays at once, the building of a structure, a board that is filled,
//! pairs of objects, or a volume that is fitted.

use raystep_accel::{Fit, Grow, PacketVisit, Reveal, Trial, Visit};

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
    /// A ray's walks through several structures, side by side.
    Walks,
    /// The walk of several rays that go through the structure together.
    Packet,
    /// The filling of tables and charts; there is no ray.
    Board,
    /// The tests of pairs of objects, one after the other; there is no structure.
    Pairs,
    /// The fitting of one volume around everything; there is neither ray nor structure.
    Fit,
}

impl Plays {
    /// All of them.
    pub const ALL: [Plays; 7] =
        [Plays::Walk, Plays::Build, Plays::Walks, Plays::Packet, Plays::Board, Plays::Pairs, Plays::Fit];

    /// Whether a ray walks, alone or with others.
    pub fn has_rays(self) -> bool {
        matches!(self, Plays::Walk | Plays::Walks | Plays::Packet)
    }

    /// How a slide writes it, and what it is called.
    pub fn name(self) -> &'static str {
        match self {
            Plays::Walk => "walk",
            Plays::Build => "build",
            Plays::Walks => "walks",
            Plays::Packet => "packet",
            Plays::Board => "board",
            Plays::Pairs => "pairs",
            Plays::Fit => "fit",
        }
    }

    /// The same in a sentence: `"a build"`, `"pairs"`.
    pub(crate) fn one(self) -> String {
        match self {
            Plays::Walks | Plays::Pairs => self.name().to_owned(),
            Plays::Walk | Plays::Build | Plays::Packet | Plays::Board | Plays::Fit => format!("a {}", self.name()),
        }
    }

    /// The events that can happen in it.
    pub(crate) fn vocabulary(self) -> Vocabulary {
        match self {
            Plays::Walk | Plays::Walks => Visit::NAMES,
            Plays::Build => Grow::NAMES,
            Plays::Packet => PacketVisit::NAMES,
            Plays::Board => Reveal::NAMES,
            Plays::Pairs => Trial::NAMES,
            Plays::Fit => Fit::NAMES,
        }
    }
}
