//! Boards: a symbol for each kind of entry, and a few words for each.

use std::borrow::Cow;

use raystep_accel::{Place, Reveal, Value};

use super::{Fact, Symbol};
use crate::theme::Role;
use crate::words::{VolumeName, told};

const ROW: Symbol = Symbol { sign: "■", name: "row", role: Role::Seen, rank: 0 };
const POINT: Symbol = Symbol { sign: "●", name: "point", role: Role::Seen, rank: 1 };
const MAP: Symbol = Symbol { sign: "◇", name: "heat map", role: Role::Seen, rank: 3 };
const PICTURE: Symbol = Symbol { sign: "□", name: "picture", role: Role::Seen, rank: 4 };
const LINE: Symbol = Symbol { sign: "△", name: "line", role: Role::Seen, rank: 2 };

impl Fact for Reveal {
    fn name(&self) -> &'static str {
        self.name()
    }

    fn place(&self) -> Place {
        self.place()
    }

    fn field(&self, name: &str) -> Option<Value> {
        self.told(name)
    }

    fn symbol(&self) -> Option<Symbol> {
        Some(match self {
            Reveal::Row { .. } => ROW,
            Reveal::Point { .. } => POINT,
            Reveal::Line { .. } => LINE,
            Reveal::Map { .. } => MAP,
            Reveal::Picture { .. } => PICTURE,
        })
    }

    fn short(&self, _: VolumeName) -> Cow<'static, str> {
        Cow::Borrowed(match self {
            Reveal::Row { .. } => "a row of the table",
            Reveal::Point { .. } => "a point of the chart",
            Reveal::Line { .. } => "a line of the chart",
            Reveal::Map { .. } => "a heat map",
            Reveal::Picture { .. } => "a picture",
        })
    }

    fn sentence(&self, _: VolumeName) -> String {
        let template = match self {
            Reveal::Picture { tests, .. } if tests.is_nan() => "The picture is not traced yet.",
            Reveal::Map { mean, .. } if mean.is_nan() => "What its rays cost is not counted yet.",
            Reveal::Line { first, .. } if first.is_nan() => "The line is not measured yet.",
            Reveal::Row { .. } => "A row of the table is filled.",
            Reveal::Point { .. } => "A point is marked at ({{x}}, {{y}}).",
            Reveal::Picture { .. } => {
                "The picture shows {{triangles}} triangles and took {{rays}} rays, {{tests}} tests each."
            }
            Reveal::Map { .. } => "A ray costs from {{least}} to {{most}}, in the mean {{mean}}.",
            Reveal::Line { .. } => "A line is drawn from ({{from}}, {{first}}) to ({{to}}, {{last}}).",
        };
        told(template, self)
    }
}
