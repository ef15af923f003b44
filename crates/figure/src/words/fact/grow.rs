//! Builds: a symbol for each kind of event, and a few words for each event.

use std::borrow::Cow;
use std::collections::BTreeMap;

use raystep_accel::{Grow, Place, Value};

use super::{Fact, Symbol};
use crate::theme::Role;
use crate::words::{VolumeName, whole};

const GROWS: Symbol = Symbol { sign: "▷", name: "box grows", role: Role::Here, rank: 0 };
const WEIGHED: Symbol = Symbol { sign: "|", name: "weighed", role: Role::Candidate, rank: 1 };
const RASTERISED: Symbol = Symbol { sign: "◇", name: "cell met", role: Role::Here, rank: 2 };
const PRUNED: Symbol = Symbol { sign: "×", name: "not reached", role: Role::Dropped, rank: 3 };
const STORED: Symbol = Symbol { sign: "●", name: "stored", role: Role::Seen, rank: 4 };
const SHARED: Symbol = Symbol { sign: "■", name: "on both sides", role: Role::Hit, rank: 4 };
const LEAF: Symbol = Symbol { sign: "□", name: "leaf", role: Role::Seen, rank: 5 };
const TOUCHED: Symbol = Symbol { sign: "○", name: "looked at", role: Role::Here, rank: 2 };
const REMOVED: Symbol = Symbol { sign: "×", name: "removed", role: Role::Dropped, rank: 5 };
const MERGED: Symbol = Symbol { sign: "▽", name: "merged", role: Role::Plane, rank: 6 };
const RANKED: Symbol = Symbol { sign: "○", name: "on the curve", role: Role::Line, rank: 2 };
const SPLIT: Symbol = Symbol { sign: "△", name: "taken", role: Role::Plane, rank: 6 };

/// Every symbol of a build, in the order of a legend.
pub(crate) const SYMBOLS: &[Symbol] =
    &[GROWS, RASTERISED, PRUNED, WEIGHED, RANKED, SPLIT, MERGED, SHARED, LEAF, TOUCHED, REMOVED, STORED];

impl Fact for Grow {
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
            Grow::Widen { grown: true, .. } => GROWS,
            Grow::Weigh { .. } => WEIGHED,
            Grow::Rasterise { .. } => RASTERISED,
            Grow::Prune { .. } => PRUNED,
            Grow::Settle { .. } => STORED,
            Grow::Share { .. } => SHARED,
            Grow::Leaf { .. } => LEAF,
            Grow::Touch { .. } => TOUCHED,
            Grow::Remove { .. } => REMOVED,
            Grow::Rank { .. } => RANKED,
            Grow::Merge { .. } => MERGED,
            Grow::Split { .. } | Grow::Divide { .. } | Grow::Refine { .. } => SPLIT,
            _ => return None,
        })
    }

    fn short(&self, volume: VolumeName) -> Cow<'static, str> {
        let cut = volume.cut;
        Cow::Borrowed(match self {
            Grow::Widen { grown: true, .. } => "the box grows",
            Grow::Widen { .. } => "it fits into the box",
            Grow::Resolve { .. } => "the resolution is chosen",
            Grow::Refine { .. } => "a cell gets its own grid",
            Grow::Rasterise { .. } => "a primitive's box meets a cell",
            Grow::Prune { .. } => "the primitive itself does not",
            Grow::Open { .. } => "a node comes to be",
            Grow::Normal { .. } => "a plane is proposed",
            Grow::Weigh { .. } => return format!("a {cut} is weighed").into(),
            Grow::Split { .. } => return format!("the {cut} is taken").into(),
            Grow::Share { .. } => "it goes to both children",
            Grow::Divide { .. } => "the cell is divided",
            Grow::Touch { .. } => "a node is looked at",
            Grow::Leaf { .. } => "the node stays a leaf",
            Grow::Settle { .. } => "a reference is stored",
            Grow::Remove { .. } => "a reference is removed",
            Grow::Rank { .. } => "a set gets its place on the curve",
            Grow::Prefer { .. } => "a set chooses a neighbour",
            Grow::Merge { .. } => "two nodes are merged",
            Grow::Move { .. } => "a node moves",
            Grow::Refit { .. } => "a volume is fitted anew",
            Grow::Renumber { .. } => "a node is laid where it stays",
            Grow::End { .. } => "the structure is built",
        })
    }

    fn sentence(&self, volume: VolumeName) -> String {
        crate::words::sentence::of_grow(self, volume)
    }
}

/// What of a build was not kept, in words: "not kept: 260,689 planes weighed".
pub(crate) fn left_out(lost: &BTreeMap<&'static str, u64>, volume: VolumeName) -> String {
    let mut kinds: Vec<(u64, String)> = lost.iter().map(|(name, count)| (*count, many(name, volume))).collect();
    kinds.sort_by(|a, b| b.cmp(a));
    let parts: Vec<String> = kinds.into_iter().map(|(count, what)| format!("{} {what}", whole(count))).collect();
    if parts.is_empty() { String::new() } else { format!("not kept: {}", parts.join(", ")) }
}

/// What many events of that name are.
fn many(name: &str, volume: VolumeName) -> String {
    let what = match name {
        "weigh" => return format!("{}s weighed", volume.cut),
        "normal" => "planes proposed",
        "rasterise" => "cells met by boxes",
        "widen.same" => "primitives that lay in the box",
        "touch" => "nodes looked at",
        "prefer" => "neighbours chosen",
        "settle" => "references stored",
        "remove" => "references removed",
        "open" => "nodes",
        "leaf" => "leaves",
        "split" | "divide" => "nodes divided",
        "share" => "primitives on both sides",
        "prune" => "cells not reached",
        other => return format!("× {other}"),
    };
    what.to_owned()
}
