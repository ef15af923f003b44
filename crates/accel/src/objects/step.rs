//! The steps of one test, in order.

use super::Probe;
use crate::{Grain, Observer, Value, Visit};

/// Who watches a test: both vocabularies, because boxes are met by the slab test of walks.
pub trait Watch: Observer<Probe> + Observer<Visit> {}

impl<W: Observer<Probe> + Observer<Visit>> Watch for W {}

/// One step of a test.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step {
    /// The slab test, in the words of walks.
    Slab(Visit),
    /// All else.
    Probe(Probe),
}

impl Step {
    /// What slides, listings and questions call this step.
    pub fn name(&self) -> &'static str {
        match self {
            Step::Slab(visit) => visit.name(),
            Step::Probe(probe) => probe.name(),
        }
    }

    /// How coarse it is.
    pub fn grain(&self) -> Grain {
        match self {
            Step::Slab(visit) => visit.grain(),
            Step::Probe(probe) => probe.grain(),
        }
    }

    /// The names of its fields, in order.
    pub fn fields(&self) -> &'static [&'static str] {
        match self {
            Step::Slab(visit) => visit.fields(),
            Step::Probe(probe) => probe.fields(),
        }
    }

    /// The value of the field called `name`.
    pub fn field(&self, name: &str) -> Option<Value> {
        match self {
            Step::Slab(visit) => visit.field(name),
            Step::Probe(probe) => probe.field(name),
        }
    }
}

/// A tape of steps.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Steps(pub Vec<Step>);

impl Observer<Visit> for Steps {
    fn on(&mut self, event: Visit) {
        self.0.push(Step::Slab(event));
    }
}

impl Observer<Probe> for Steps {
    fn on(&mut self, event: Probe) {
        self.0.push(Step::Probe(event));
    }
}
