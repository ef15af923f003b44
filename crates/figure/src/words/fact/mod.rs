//! What events of walks and of builds have in common, and how views call them.

mod fit;
pub(crate) mod grow;
mod packet;
mod reveal;
mod trial;
pub(crate) mod visit;

use std::borrow::Cow;

use raystep_accel::{Event, PacketStep, PacketVisit, Place, Value, Visit};

use crate::theme::Role;
use crate::words::VolumeName;

/// An event of a walk or of a build, as listings, templates and timelines see it.
pub trait Fact {
    /// What slides and listings call it.
    fn name(&self) -> &'static str;

    /// What it is about.
    fn place(&self) -> Place;

    /// The value of one of its fields.
    fn field(&self, name: &str) -> Option<Value>;

    /// Whether a field is a number that few rays have told: then a sign stands before it.
    fn is_rough(&self, _name: &str) -> bool {
        false
    }

    /// Whether flat scenes leave it out.
    fn concerns_z(&self) -> bool {
        false
    }

    /// Its symbol on a timeline, if it has one.
    fn symbol(&self) -> Option<Symbol>;

    /// What it is, in a few words; `volume` is what is tested in its structure.
    fn short(&self, volume: VolumeName) -> Cow<'static, str>;

    /// What it says, in plain words with its numbers; `volume` as above.
    fn sentence(&self, volume: VolumeName) -> String;
}

/// A small sign for a kind of event.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Symbol {
    /// The character that draws it; both shipped families have it.
    pub sign: &'static str,
    /// Its name in a legend.
    pub name: &'static str,
    /// Its meaning.
    pub role: Role,
    /// In a crowd, the highest is drawn.
    pub rank: u8,
}

impl Fact for Event {
    fn name(&self) -> &'static str {
        self.name()
    }

    fn place(&self) -> Place {
        self.place()
    }

    fn field(&self, name: &str) -> Option<Value> {
        self.field(name)
    }

    fn concerns_z(&self) -> bool {
        self.concerns_z()
    }

    fn symbol(&self) -> Option<Symbol> {
        match self {
            Event::Walk(visit) => visit.symbol(),
            Event::Build(grow) => grow.symbol(),
            Event::Board(reveal) => reveal.symbol(),
            Event::Pair(trial) => trial.symbol(),
            Event::Fit(fit) => fit.symbol(),
            Event::Packet(visit) => visit.symbol(),
        }
    }

    fn short(&self, volume: VolumeName) -> Cow<'static, str> {
        match self {
            Event::Walk(visit) => visit.short(volume),
            Event::Build(grow) => grow.short(volume),
            Event::Board(reveal) => reveal.short(volume),
            Event::Pair(trial) => trial.short(volume),
            Event::Fit(fit) => fit.short(volume),
            Event::Packet(visit) => visit.short(volume),
        }
    }

    fn sentence(&self, volume: VolumeName) -> String {
        match self {
            Event::Walk(visit) => visit.sentence(volume),
            Event::Build(grow) => grow.sentence(volume),
            Event::Board(reveal) => reveal.sentence(volume),
            Event::Pair(trial) => trial.sentence(volume),
            Event::Fit(fit) => fit.sentence(volume),
            Event::Packet(visit) => visit.sentence(volume),
        }
    }
}

/// A wrong answer among the facts: the coming event, and as `own.field` the event that belongs to the answer.
#[derive(Clone, Copy, Debug)]
pub struct Answer {
    /// The event that answers the question.
    pub coming: Event,
    /// What belongs to this answer alone.
    pub own: Option<Event>,
}

impl Fact for Answer {
    fn name(&self) -> &'static str {
        self.coming.name()
    }

    fn place(&self) -> Place {
        self.coming.place()
    }

    fn field(&self, name: &str) -> Option<Value> {
        match name.strip_prefix("own.") {
            Some(own) => self.own?.field(own),
            None => self.coming.field(name),
        }
    }

    fn symbol(&self) -> Option<Symbol> {
        self.coming.symbol()
    }

    fn short(&self, volume: VolumeName) -> Cow<'static, str> {
        self.coming.short(volume)
    }

    fn sentence(&self, volume: VolumeName) -> String {
        self.coming.sentence(volume)
    }
}

/// One sentence about what just happened, with its numbers; `volume` is what is tested in its structure.
pub fn sentence(event: &(impl Fact + ?Sized), volume: VolumeName) -> String {
    event.sentence(volume)
}

/// What an event is, in a few words; `volume` is what is tested in its structure.
pub fn short(event: &(impl Fact + ?Sized), volume: VolumeName) -> Cow<'static, str> {
    event.short(volume)
}

/// The event without what it comes to: while a question asks for the verdict, the numbers stand there and the
/// conclusion does not.
pub fn veiled(event: &Event) -> Event {
    match event {
        Event::Walk(event) => Event::Walk(veiled_visit(event)),
        Event::Packet(PacketVisit { lanes, step: PacketStep::Lane(visit) }) => {
            Event::Packet(PacketVisit { lanes: *lanes, step: PacketStep::Lane(veiled_visit(visit)) })
        }
        Event::Build(_) | Event::Fit(_) | Event::Board(_) | Event::Pair(_) | Event::Packet(_) => *event,
    }
}

pub(crate) fn veiled_visit(event: &Visit) -> Visit {
    let mut veiled = *event;
    if let Visit::Narrow { empty, .. } | Visit::Roots { empty, .. } | Visit::Clip { empty, .. } = &mut veiled {
        *empty = false;
    }
    veiled
}
