//! What events of walks and of builds have in common, and how views call them.

mod grow;
mod visit;

use raystep_accel::{Place, Value};

use crate::Role;

/// An event of a walk or of a build, as listings, templates and timelines see it.
pub trait Fact {
    /// Every symbol that events of this vocabulary have, in the order of a legend.
    const SYMBOLS: &'static [Symbol];

    /// What slides and listings call it.
    fn name(&self) -> &'static str;

    /// What it is about.
    fn place(&self) -> Place;

    /// The value of one of its fields.
    fn field(&self, name: &str) -> Option<Value>;

    /// Whether flat scenes leave it out.
    fn concerns_z(&self) -> bool {
        false
    }

    /// Its symbol on a timeline, if it has one.
    fn symbol(&self) -> Option<Symbol>;

    /// What it is, in a few words.
    fn short(&self) -> &'static str;
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

/// What an event is, in a few words.
pub fn short(event: &impl Fact) -> &'static str {
    event.short()
}
