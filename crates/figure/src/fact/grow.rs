//! Builds: a symbol for each kind of event, and a few words for each event.

use raystep_accel::{Grow, Place, Value};

use super::{Fact, Symbol};
use crate::Role;

const GROWS: Symbol = Symbol { sign: "▷", name: "box grows", role: Role::Here, rank: 0 };
const WEIGHED: Symbol = Symbol { sign: "|", name: "weighed", role: Role::Candidate, rank: 1 };
const RASTERISED: Symbol = Symbol { sign: "◇", name: "cell met", role: Role::Here, rank: 2 };
const PRUNED: Symbol = Symbol { sign: "×", name: "pruned", role: Role::Dropped, rank: 3 };
const STORED: Symbol = Symbol { sign: "●", name: "stored", role: Role::Seen, rank: 4 };
const LEAF: Symbol = Symbol { sign: "□", name: "leaf", role: Role::Seen, rank: 5 };
const SPLIT: Symbol = Symbol { sign: "△", name: "split", role: Role::Plane, rank: 6 };

impl Fact for Grow {
    const SYMBOLS: &'static [Symbol] = &[GROWS, RASTERISED, PRUNED, WEIGHED, SPLIT, LEAF, STORED];

    fn name(&self) -> &'static str {
        self.name()
    }

    fn place(&self) -> Place {
        self.place()
    }

    fn field(&self, name: &str) -> Option<Value> {
        self.field(name)
    }

    fn symbol(&self) -> Option<Symbol> {
        Some(match self {
            Grow::Widen { .. } => GROWS,
            Grow::Weigh { .. } => WEIGHED,
            Grow::Rasterise { .. } => RASTERISED,
            Grow::Prune { .. } => PRUNED,
            Grow::Settle { .. } => STORED,
            Grow::Leaf { .. } => LEAF,
            Grow::Split { .. } | Grow::Divide { .. } => SPLIT,
            _ => return None,
        })
    }

    fn short(&self) -> &'static str {
        match self {
            Grow::Widen { .. } => "the box grows",
            Grow::Resolve { .. } => "the resolution is chosen",
            Grow::Rasterise { .. } => "a primitive's box meets a cell",
            Grow::Prune { .. } => "the primitive itself does not",
            Grow::Open { .. } => "a node comes to be",
            Grow::Weigh { .. } => "a split is weighed",
            Grow::Split { .. } => "the split is taken",
            Grow::Divide { .. } => "the cell is divided",
            Grow::Touch { .. } => "a node is looked at",
            Grow::Leaf { .. } => "the node stays a leaf",
            Grow::Settle { .. } => "a reference is stored",
            Grow::Merge { .. } => "two nodes become one",
            Grow::Move { .. } => "a node moves",
            Grow::Renumber { .. } => "a node gets its final number",
        }
    }
}
