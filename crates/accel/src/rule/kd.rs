//! How a kd-tree is to be built.

use super::ByHand;
use super::parameter::{Field, Slot, choice};
use super::shared;
use crate::events::words;
use crate::{Axes, Measure};

words! {
    /// Where a node is cut.
    pub enum KdSplit {
        /// Through the middle of the longest side.
        Middle = "middle",
        /// Where as many primitives lie below as above, across the longest side.
        Median = "median",
        /// Where a ray is expected to have the least work (MacDonald and Booth 1990).
        Sah = "sah",
    }
}
choice!(KdSplit);

/// The parameters of a kd-tree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KdRule {
    /// Where a node is cut.
    pub split: KdSplit,
    /// Nodes this deep stay leaves; the root has depth 0.
    pub max_depth: u32,
    /// Nodes with so few primitives stay leaves.
    pub min_objects: u32,
    /// By which part a split that cuts off empty space is cheaper.
    pub empty_bonus: f32,
    /// Whether a ray remembers which primitives it tested.
    pub mailbox: bool,
    /// What it costs to walk through a node.
    pub traversal_cost: f32,
    /// What it costs to test a primitive.
    pub intersection_cost: f32,
    /// Cuts that are chosen by hand, whatever they cost.
    pub cut: ByHand,
    /// The axes to cut across: a flat scene is not cut across z.
    pub axes: Axes,
    /// How boxes are measured.
    pub measure: Measure,
}

impl Default for KdRule {
    fn default() -> KdRule {
        KdRule {
            split: KdSplit::Sah,
            max_depth: 24,
            min_objects: 4,
            empty_bonus: 0.2,
            mailbox: true,
            traversal_cost: 1.0,
            intersection_cost: 4.0,
            cut: ByHand::default(),
            axes: Axes::Xyz,
            measure: Measure::Area,
        }
    }
}

impl KdRule {
    /// The greatest depth that may be asked for.
    pub const DEEPEST: u32 = 64;

    pub(super) fn slots(&mut self) -> Vec<Slot<'_>> {
        vec![
            Slot { key: "split", about: "where a node is cut", field: Field::Word(&mut self.split) },
            shared::max_depth(&mut self.max_depth, KdRule::DEEPEST),
            shared::min_objects(&mut self.min_objects, 0),
            Slot {
                key: "empty_bonus",
                about: "how much cheaper a split counts that cuts off empty space",
                field: Field::Real(&mut self.empty_bonus, 0.0, 1.0),
            },
            shared::mailbox(&mut self.mailbox),
            shared::traversal_cost(&mut self.traversal_cost),
            shared::intersection_cost(&mut self.intersection_cost),
            shared::cut(&mut self.cut),
        ]
    }
}
