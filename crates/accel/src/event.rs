//! An event of a walk, of a packet, of a build, of a volume that is fitted, of a board or of a pair of objects, for whoever shows them all.

use crate::{Fit, Grain, Grow, PacketVisit, Place, Reveal, Trial, Value, Visit};

/// Something that a walk, a builder or the fitting of a volume did, that came to be seen on a board, or that a test of two objects did.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// A ray's walk did it.
    Walk(Visit),
    /// A builder did it.
    Build(Grow),
    /// The fitting of a volume did it.
    Fit(Fit),
    /// It came to be seen on a board.
    Board(Reveal),
    /// A test of two objects did it.
    Pair(Trial),
    /// The walk of a packet did it.
    Packet(PacketVisit),
}

/// Asks whichever it is.
macro_rules! either {
    ($event:expr, $inner:ident => $ask:expr) => {
        match $event {
            Event::Walk($inner) => $ask,
            Event::Build($inner) => $ask,
            Event::Fit($inner) => $ask,
            Event::Board($inner) => $ask,
            Event::Pair($inner) => $ask,
            Event::Packet($inner) => $ask,
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

    /// The value of the field called `name`. What a board has no number for is no field of it.
    pub fn field(&self, name: &str) -> Option<Value> {
        let missing = |value: &Value| matches!((self, value), (Event::Board(_), Value::Number(n)) if n.is_nan());
        either!(self, event => event.field(name)).filter(|value| !missing(value))
    }

    /// The names of its fields, in order.
    pub fn fields(&self) -> &'static [&'static str] {
        either!(self, event => event.fields())
    }

    /// Whether flat scenes leave it out: builders of flat scenes do nothing across z.
    pub fn concerns_z(&self) -> bool {
        match self {
            Event::Walk(visit) => visit.concerns_z(),
            Event::Packet(visit) => visit.concerns_z(),
            Event::Fit(fit) => fit.concerns_z(),
            Event::Build(_) | Event::Board(_) | Event::Pair(_) => false,
        }
    }
}
