//! How a BSP tree is to be built.

use super::parameter::{Field, Slot, choice};
use super::shared;
use crate::events::words;
use crate::{Axes, KdRule, Measure};

words! {
    /// Which planes are weighed.
    pub enum BspPlanes {
        /// Planes of the polygons themselves, and planes on their edges (Fuchs, Kedem and Naylor 1980).
        Polygons = "polygons",
        /// Planes beside the polygons, across a small set of directions (Kammaje and Mora 2007).
        Candidates = "candidates",
    }

    /// What becomes of a polygon that a plane cuts.
    pub enum Straddlers {
        /// It is cut, and each side gets its fragment.
        Cut = "cut",
        /// It stays whole, and both sides refer to it.
        Both = "both",
    }
}
choice!(BspPlanes, Straddlers);

/// The parameters of a BSP tree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BspRule {
    /// Which planes are weighed.
    pub planes: BspPlanes,
    /// What becomes of a polygon that a plane cuts.
    pub straddlers: Straddlers,
    /// How many of a node's primitives propose planes.
    pub samples: u32,
    /// Which of them: the same seed, the same tree.
    pub seed: u32,
    /// Nodes this deep stay leaves; the root has depth 0.
    pub max_depth: u32,
    /// Nodes with so few primitives stay leaves.
    pub min_objects: u32,
    /// Whether a ray remembers which primitives it tested.
    pub mailbox: bool,
    /// What it costs to walk through a node.
    pub traversal_cost: f32,
    /// What it costs to test a primitive.
    pub intersection_cost: f32,
    /// The axes that a plane's normal may have a part of: in a flat scene, planes stand upright.
    pub axes: Axes,
    /// How cells are measured.
    pub measure: Measure,
}

impl Default for BspRule {
    fn default() -> BspRule {
        BspRule {
            planes: BspPlanes::Polygons,
            straddlers: Straddlers::Cut,
            samples: 8,
            seed: 1,
            max_depth: 24,
            min_objects: 4,
            mailbox: true,
            traversal_cost: 1.0,
            intersection_cost: 4.0,
            axes: Axes::Xyz,
            measure: Measure::Area,
        }
    }
}

impl BspRule {
    pub(super) fn slots(&mut self) -> Vec<Slot<'_>> {
        vec![
            Slot { key: "planes", about: "which planes are weighed", field: Field::Word(&mut self.planes) },
            Slot {
                key: "straddlers",
                about: "what becomes of a polygon that a plane cuts",
                field: Field::Word(&mut self.straddlers),
            },
            Slot {
                key: "samples",
                about: "how many of a node's primitives propose planes",
                field: Field::Count(&mut self.samples, 1, 64),
            },
            Slot { key: "seed", about: "which primitives those are", field: Field::Count(&mut self.seed, 0, 9999) },
            shared::max_depth(&mut self.max_depth, KdRule::DEEPEST),
            shared::min_objects(&mut self.min_objects, 0),
            shared::mailbox(&mut self.mailbox),
            shared::traversal_cost(&mut self.traversal_cost),
            shared::intersection_cost(&mut self.intersection_cost),
        ]
    }
}
