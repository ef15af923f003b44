//! An event of a walk or of a build, for whoever shows both.

use super::{Grain, Grow, Place, Value, Visit};

/// Something that a walk or a builder did.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// A ray's walk did it.
    Walk(Visit),
    /// A builder did it.
    Build(Grow),
}

/// Asks whichever it is.
macro_rules! either {
    ($event:expr, $inner:ident => $ask:expr) => {
        match $event {
            Event::Walk($inner) => $ask,
            Event::Build($inner) => $ask,
        }
    };
}

impl Event {
    /// What slides, listings and questions call it.
    pub fn name(&self) -> &'static str {
        either!(self, event => event.name())
    }

    /// What it is about.
    pub fn place(&self) -> Place {
        either!(self, event => event.place())
    }

    /// How coarse it is.
    pub fn grain(&self) -> Grain {
        either!(self, event => event.grain())
    }

    /// The value of the field called `name`.
    pub fn field(&self, name: &str) -> Option<Value> {
        either!(self, event => event.field(name))
    }

    /// The names of its fields, in order.
    pub fn fields(&self) -> &'static [&'static str] {
        either!(self, event => event.fields())
    }

    /// Whether flat scenes leave it out: builders of flat scenes do nothing across z.
    pub fn concerns_z(&self) -> bool {
        matches!(self, Event::Walk(visit) if visit.concerns_z())
    }
}
