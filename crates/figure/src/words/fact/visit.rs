//! Walks: a symbol for each kind of event, and a few words for each event.

use std::borrow::Cow;

use raystep_accel::{Ending, Place, Probed, Value, Verdict, Visit};

use super::{Fact, Symbol};
use crate::theme::Role;
use crate::words::VolumeName;

const SLAB: Symbol = Symbol { sign: "▽", name: "slab", role: Role::Plane, rank: 0 };
/// Each structure has a name of its own for it.
pub(crate) const VOLUME: Symbol = Symbol { sign: "◇", name: "volume", role: Role::Here, rank: 1 };
const SKIP: Symbol = Symbol { sign: "○", name: "skip", role: Role::Dropped, rank: 2 };
const MISS: Symbol = Symbol { sign: "|", name: "miss", role: Role::Missed, rank: 3 };
const CELL: Symbol = Symbol { sign: "▷", name: "next cell", role: Role::Here, rank: 4 };
const DOWN: Symbol = Symbol { sign: "▼", name: "into a finer grid", role: Role::Here, rank: 5 };
const UP: Symbol = Symbol { sign: "▲", name: "out of it", role: Role::Here, rank: 5 };
const PROBE: Symbol = Symbol { sign: "◦", name: "slot", role: Role::Seen, rank: 1 };
const PLANE: Symbol = Symbol { sign: "△", name: "plane", role: Role::Plane, rank: 5 };
const POP: Symbol = Symbol { sign: "■", name: "pop", role: Role::Waiting, rank: 6 };
const PUSH: Symbol = Symbol { sign: "□", name: "push", role: Role::Waiting, rank: 7 };
const DROP: Symbol = Symbol { sign: "×", name: "drop", role: Role::Dropped, rank: 8 };
const HIT: Symbol = Symbol { sign: "●", name: "hit", role: Role::Hit, rank: 9 };

/// Every symbol of a walk, in the order of a legend.
pub(crate) const SYMBOLS: &[Symbol] = &[SLAB, PLANE, VOLUME, CELL, DOWN, UP, PROBE, PUSH, POP, DROP, SKIP, MISS, HIT];

impl Fact for Visit {
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
        Some(match self {
            Visit::Divide { .. } | Visit::Parallel { .. } => SLAB,
            Visit::Plane { .. } => PLANE,
            Visit::Volume { .. } => VOLUME,
            Visit::Step { .. } => CELL,
            Visit::Descend { .. } => DOWN,
            Visit::Ascend { .. } => UP,
            Visit::Probe { .. } => PROBE,
            Visit::Push { .. } => PUSH,
            Visit::Pop { .. } => POP,
            Visit::Drop { .. } => DROP,
            Visit::Skip { .. } => SKIP,
            Visit::Test { hit: false, .. } => MISS,
            Visit::Test { hit: true, .. } => HIT,
            _ => return None,
        })
    }

    fn short(&self, volume: VolumeName) -> Cow<'static, str> {
        let one = volume.one;
        Cow::Borrowed(match self {
            Visit::Parallel { .. } => "the ray runs along a slab",
            Visit::Divide { .. } => "a slab cuts the ray",
            Visit::Order { swapped: true, .. } => "the two cuts are swapped",
            Visit::Order { .. } => "the two cuts are in order",
            Visit::Narrow { empty: true, .. } => "nothing of the interval is left",
            Visit::Narrow { .. } => "the interval narrows",
            Visit::Roots { empty: true, .. } | Visit::Clip { empty: true, .. } => "nothing of the interval is left",
            Visit::Roots { .. } => "a sphere cuts the ray",
            Visit::Clip { .. } => "a face cuts the ray",
            Visit::Volume { verdict: Verdict::Hit, .. } => return format!("the {one} is met").into(),
            Visit::Volume { verdict: Verdict::Miss, .. } => return format!("the {one} is missed").into(),
            Visit::Volume { verdict: Verdict::Cut, .. } => return format!("the {one} is too far").into(),
            Visit::Enter { .. } => match self.name() {
                "enter.cell" => "a cell is entered",
                "enter.leaf" => "a leaf is entered",
                _ => "a node is entered",
            },
            Visit::Plane { .. } => "the plane cuts the ray",
            Visit::Split { .. } => match self.name() {
                "split.both" => "both children are met",
                "split.near" => "only the near child is met",
                _ => "only the far child is met",
            },
            Visit::Push { .. } => "a node waits on the stack",
            Visit::Pop { .. } => "a node comes off the stack",
            Visit::Drop { .. } => "a node is dropped",
            Visit::Step { inside: true, .. } => "on to the next cell",
            Visit::Step { .. } => "the ray leaves the grid",
            Visit::Descend { .. } => "down into the cell's own grid",
            Visit::Ascend { .. } => "back in the coarser cell",
            Visit::Probe { holds: Probed::Found, .. } => "the table has the cell",
            Visit::Probe { holds: Probed::Empty, .. } => "the table has no such cell",
            Visit::Probe { holds: Probed::Taken, .. } => "the slot holds another cell",
            Visit::Skip { .. } => "tested before: skipped",
            Visit::Test { hit: true, .. } => "a primitive is hit",
            Visit::Test { .. } => "a primitive is missed",
            Visit::Better { .. } => "the best hit so far",
            Visit::Beyond { .. } => "the hit lies beyond the cell",
            Visit::Local { .. } => "the ray enters an instance",
            Visit::World { .. } => "the ray leaves the instance",
            Visit::Distant { .. } => "too far away: brute force",
            Visit::Extreme { .. } => "too short or too long: brute force",
            Visit::End { why: Ending::Outside, .. } => return format!("the {one} is never met").into(),
            Visit::End { hit: true, .. } => "the nearest hit is found",
            Visit::End { .. } => "nothing is hit",
        })
    }

    fn sentence(&self, volume: VolumeName) -> String {
        crate::words::sentence::of_visit(self, volume)
    }
}
