//! The small symbols that stand for kinds of events, and what to call an event in a few words.

use raystep_accel::{Ending, Verdict, Visit};

use crate::Role;

/// A kind of event that is worth a symbol. The later in the list, the more it matters in a crowd.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Glyph {
    Slab,
    Box,
    Skip,
    Test,
    Cell,
    Plane,
    Pop,
    Push,
    Drop,
    Hit,
}

impl Glyph {
    pub(crate) const ALL: [Glyph; 10] = [
        Glyph::Slab,
        Glyph::Plane,
        Glyph::Box,
        Glyph::Cell,
        Glyph::Push,
        Glyph::Pop,
        Glyph::Drop,
        Glyph::Skip,
        Glyph::Test,
        Glyph::Hit,
    ];

    /// The symbol of an event, if it has one.
    pub(crate) fn of(event: &Visit) -> Option<Glyph> {
        Some(match event {
            Visit::Divide { .. } | Visit::Parallel { .. } => Glyph::Slab,
            Visit::Plane { .. } => Glyph::Plane,
            Visit::Volume { .. } => Glyph::Box,
            Visit::Step { .. } => Glyph::Cell,
            Visit::Push { .. } => Glyph::Push,
            Visit::Pop { .. } => Glyph::Pop,
            Visit::Drop { .. } => Glyph::Drop,
            Visit::Skip { .. } => Glyph::Skip,
            Visit::Test { hit: false, .. } => Glyph::Test,
            Visit::Test { hit: true, .. } => Glyph::Hit,
            _ => return None,
        })
    }

    /// The character that draws it; both shipped families have it.
    pub(crate) fn symbol(self) -> &'static str {
        match self {
            Glyph::Slab => "▽",
            Glyph::Plane => "△",
            Glyph::Box => "◇",
            Glyph::Cell => "▷",
            Glyph::Push => "□",
            Glyph::Pop => "■",
            Glyph::Drop => "×",
            Glyph::Skip => "○",
            Glyph::Test => "|",
            Glyph::Hit => "●",
        }
    }

    pub(crate) fn name(self) -> &'static str {
        match self {
            Glyph::Slab => "slab",
            Glyph::Plane => "plane",
            Glyph::Box => "box",
            Glyph::Cell => "next cell",
            Glyph::Push => "push",
            Glyph::Pop => "pop",
            Glyph::Drop => "drop",
            Glyph::Skip => "skip",
            Glyph::Test => "miss",
            Glyph::Hit => "hit",
        }
    }

    pub(crate) fn role(self) -> Role {
        match self {
            Glyph::Slab | Glyph::Plane => Role::Plane,
            Glyph::Box | Glyph::Cell => Role::Here,
            Glyph::Push | Glyph::Pop => Role::Waiting,
            Glyph::Drop | Glyph::Skip => Role::Dropped,
            Glyph::Test => Role::Missed,
            Glyph::Hit => Role::Hit,
        }
    }
}

/// What an event is, in a few words.
pub fn short(event: &Visit) -> &'static str {
    match event {
        Visit::Parallel { .. } => "the ray runs along a slab",
        Visit::Divide { .. } => "a slab cuts the ray",
        Visit::Order { swapped: true, .. } => "the two cuts are swapped",
        Visit::Order { .. } => "the two cuts are in order",
        Visit::Narrow { empty: true, .. } => "nothing of the interval is left",
        Visit::Narrow { .. } => "the interval narrows",
        Visit::Volume { verdict: Verdict::Hit, .. } => "the box is met",
        Visit::Volume { verdict: Verdict::Miss, .. } => "the box is missed",
        Visit::Volume { verdict: Verdict::Cut, .. } => "the box is too far",
        Visit::Enter { .. } => match event.name() {
            "enter.cell" => "a cell is entered",
            "enter.leaf" => "a leaf is entered",
            _ => "a node is entered",
        },
        Visit::Plane { .. } => "the plane cuts the ray",
        Visit::Split { .. } => match event.name() {
            "split.both" => "both children are met",
            "split.near" => "only the near child is met",
            _ => "only the far child is met",
        },
        Visit::Push { .. } => "a node waits on the stack",
        Visit::Pop { .. } => "a node comes off the stack",
        Visit::Drop { .. } => "a node is never opened",
        Visit::Step { inside: true, .. } => "on to the next cell",
        Visit::Step { .. } => "the ray leaves the grid",
        Visit::Probe { found: true, .. } => "the table has the cell",
        Visit::Probe { .. } => "the table has no such cell",
        Visit::Skip { .. } => "tested before: skipped",
        Visit::Test { hit: true, .. } => "a primitive is hit",
        Visit::Test { .. } => "a primitive is missed",
        Visit::Better { .. } => "the best hit so far",
        Visit::Beyond { .. } => "the hit lies beyond the cell",
        Visit::Distant { .. } => "too far away: brute force",
        Visit::End { why: Ending::Outside, .. } => "the box is never met",
        Visit::End { hit: true, .. } => "the nearest hit is found",
        Visit::End { .. } => "nothing is hit",
    }
}
