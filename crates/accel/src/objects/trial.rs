//! A pair of objects on trial: which pair, which of its arrangements, and what its test does.

use glam::Vec3;

use super::{Body, PAIRS, Pair, Probe, Step};
use crate::{CellId, Grain, Place, Value, Visit};

/// One thing that happens while pairs of objects are tried one after the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trial {
    /// The place of the pair in [`PAIRS`].
    pub pair: u32,
    /// Which of its arrangements, from 1.
    pub case: u32,
    /// What the test does; nothing where the two objects are only laid out.
    pub step: Option<Step>,
}

/// What it is called where two objects are laid out.
const LAID: &str = "pair";

/// Every pair by its name.
const NAMES: [&str; PAIRS.len()] = {
    let mut names = [""; PAIRS.len()];
    let mut index = 0;
    while index < names.len() {
        names[index] = PAIRS[index].name;
        index += 1;
    }
    names
};

/// The names of an event, and its fields.
type Named = (&'static [&'static str], &'static [&'static str]);

/// The events of slabs among those of walks.
const SLABS: usize = {
    let (mut count, mut index) = (0, 0);
    while index < Visit::NAMES.len() {
        if is_slab(Visit::NAMES[index].0[0]) {
            count += 1;
        }
        index += 1;
    }
    count
};

const fn is_slab(name: &str) -> bool {
    matches!(name.as_bytes(), [b's', b'l', b'a', b'b', b'.', ..])
}

const ALL: [Named; 1 + Probe::NAMES.len() + SLABS] = {
    let mut all: [Named; 1 + Probe::NAMES.len() + SLABS] =
        [(&[LAID], &["pair", "case"]); 1 + Probe::NAMES.len() + SLABS];
    let (mut next, mut index) = (1, 0);
    while index < Probe::NAMES.len() {
        all[next] = Probe::NAMES[index];
        (next, index) = (next + 1, index + 1);
    }
    index = 0;
    while index < Visit::NAMES.len() {
        if is_slab(Visit::NAMES[index].0[0]) {
            all[next] = Visit::NAMES[index];
            next += 1;
        }
        index += 1;
    }
    all
};

impl Trial {
    /// Every name an event can go by, with the names of its fields; besides, each has a `pair` and a `case`.
    pub const NAMES: &'static [(&'static [&'static str], &'static [&'static str])] = &ALL;

    /// The fields that every event has.
    pub const COMMON: [&'static str; 2] = ["pair", "case"];

    /// The pair that is tried.
    pub fn tried(&self) -> Option<&'static Pair> {
        PAIRS.get(self.pair as usize)
    }

    /// What slides, listings and questions call it.
    pub fn name(&self) -> &'static str {
        self.step.as_ref().map_or(LAID, Step::name)
    }

    /// The names of its own fields, in order.
    pub fn fields(&self) -> &'static [&'static str] {
        self.step.as_ref().map_or(ALL[0].1, Step::fields)
    }

    /// The value of the field called `name`.
    pub fn field(&self, name: &str) -> Option<Value> {
        match name {
            "pair" => self.tried().map(|pair| Value::Word(pair.name, &NAMES)),
            "case" => Some(Value::Count(self.case)),
            _ => self.step.as_ref()?.field(name),
        }
    }

    /// How coarse it is: laid out and answered are visits.
    pub fn grain(&self) -> Grain {
        self.step.as_ref().map_or(Grain::Visit, Step::grain)
    }

    /// What it is about: each pair is a cell of the matrix.
    pub fn place(&self) -> Place {
        Place::Cell(CellId(self.pair))
    }
}

/// Two objects as they lie for a test.
#[derive(Clone, Debug, PartialEq)]
pub struct Arrangement {
    /// The place of the pair in [`PAIRS`].
    pub pair: u32,
    /// Which of the pair's arrangements, from 1.
    pub case: u32,
    /// How far the first of the two was moved from where the arrangement has it.
    pub moved: Vec3,
    /// The two.
    pub bodies: [Body<'static>; 2],
}

impl Arrangement {
    /// An arrangement of a pair, the first of the two moved by so much; nothing if there is none.
    pub fn of(pair: u32, case: u32, moved: Vec3) -> Option<Arrangement> {
        let cases = PAIRS.get(pair as usize)?.cases();
        let [first, second] = *cases.get((case as usize).checked_sub(1)?)?;
        Some(Arrangement { pair, case, moved, bodies: [first.moved(moved), second] })
    }

    /// What the test does, from the moment the two are laid out.
    pub fn observe(&self) -> Vec<Trial> {
        let (pair, case) = (self.pair, self.case);
        let [first, second] = &self.bodies;
        let tried = PAIRS.get(pair as usize).and_then(|tried| tried.observe([first, second]));
        let steps = tried.map_or_else(Vec::new, |(steps, _)| steps);
        std::iter::once(None).chain(steps.into_iter().map(Some)).map(|step| Trial { pair, case, step }).collect()
    }
}
