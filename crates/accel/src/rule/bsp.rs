//! How a BSP tree is to be built.

use super::parameter::{Field, Slot, choice};
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
            Slot {
                key: "max_depth",
                about: "nodes this deep stay leaves",
                field: Field::Count(&mut self.max_depth, 0, KdRule::DEEPEST),
            },
            Slot {
                key: "min_objects",
                about: "nodes with so few primitives stay leaves",
                field: Field::Count(&mut self.min_objects, 0, 1000),
            },
            Slot {
                key: "mailbox",
                about: "remember which primitives this ray has tested",
                field: Field::Flag(&mut self.mailbox),
            },
            Slot {
                key: "traversal_cost",
                about: "what it costs to walk through a node",
                field: Field::Real(&mut self.traversal_cost, 0.0, 1000.0),
            },
            Slot {
                key: "intersection_cost",
                about: "what it costs to test a primitive",
                field: Field::Real(&mut self.intersection_cost, 0.0, 1000.0),
            },
        ]
    }
}
