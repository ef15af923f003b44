//! Parameters that several kinds of structure have: when a node stays a leaf, what work costs, the mailbox.

use super::ByHand;
use super::parameter::{Field, Slot};

/// How deep a tree may become.
pub(super) fn max_depth(depth: &mut u32, deepest: u32) -> Slot<'_> {
    Slot { key: "max_depth", about: "nodes this deep stay leaves", field: Field::Count(depth, 0, deepest) }
}

/// How few primitives are left together.
pub(super) fn min_objects(count: &mut u32, least: u32) -> Slot<'_> {
    Slot {
        key: "min_objects",
        about: "nodes with so few primitives stay leaves",
        field: Field::Count(count, least, 1000),
    }
}

/// Which nodes are cut where somebody wants it.
pub(super) fn cut(cuts: &mut ByHand) -> Slot<'_> {
    Slot { key: "cut", about: "where nodes are cut by hand", field: Field::Cuts(cuts) }
}

/// Whether rays keep a mailbox.
pub(super) fn mailbox(kept: &mut bool) -> Slot<'_> {
    Slot { key: "mailbox", about: "remember which primitives this ray has tested", field: Field::Flag(kept) }
}

/// What a step costs.
pub(super) fn traversal_cost(cost: &mut f32) -> Slot<'_> {
    Slot { key: "traversal_cost", about: "what it costs to walk through a node", field: Field::Real(cost, 0.0, 1000.0) }
}

/// What a test costs.
pub(super) fn intersection_cost(cost: &mut f32) -> Slot<'_> {
    Slot { key: "intersection_cost", about: "what it costs to test a primitive", field: Field::Real(cost, 0.0, 1000.0) }
}
