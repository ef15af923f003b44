//! How a hierarchy of volumes is to be built and walked.

use super::parameter::{Field, Slot, choice};
use super::{ByHand, shared};
use crate::events::words;
use crate::{Axes, Measure};

words! {
    /// What bounds a node's primitives.
    pub enum BvhVolume {
        /// A sphere (slide 49).
        Sphere = "sphere",
        /// An axis-aligned box (slide 50).
        Aabb = "aabb",
        /// An oriented box (slide 51).
        Obb = "obb",
        /// A k-DOP of the six axis-aligned planes: a box again.
        KDop6 = "kdop6",
        /// A k-DOP with the four pairs of planes across the corners of a cube (slide 52).
        KDop14 = "kdop14",
        /// A k-DOP with the six pairs of planes across the edges of a cube.
        KDop18 = "kdop18",
        /// A k-DOP with both.
        KDop26 = "kdop26",
        /// A convex hull (slide 52).
        Hull = "hull",
    }

    /// From which end a hierarchy is put together.
    pub enum BvhBuilder {
        /// All primitives are divided, then each part (slide 53).
        TopDown = "top-down",
        /// The two nearest sets are joined until one is left (slide 54).
        BottomUp = "bottom-up",
        /// The same, but each set looks for its nearest among few neighbours only (Meister and Bittner 2018).
        Ploc = "ploc",
        /// Each primitive goes to where the tree grows least (slide 55).
        Insertion = "insertion",
    }

    /// How a node's primitives are divided between its children.
    pub enum BvhSplit {
        /// By the middle of their centres' box.
        Middle = "middle",
        /// Into two halves along the longest side of their centres' box.
        Median = "median",
        /// At the cheapest of a few evenly spaced planes (Wald 2007).
        Binned = "binned",
        /// At the cheapest place of all.
        Sweep = "sweep",
    }

    /// In which order a walk opens the nodes.
    pub enum BvhOrder {
        /// Left child, then right child, whatever was found: as slide 56 prints it.
        Printed = "printed",
        /// The nearer child first; boxes behind the best hit stay closed.
        Ordered = "ordered",
    }
}
choice!(BvhVolume, BvhBuilder, BvhSplit, BvhOrder);

/// The parameters of a hierarchy of volumes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BvhRule {
    /// What bounds a node's primitives.
    pub volume: BvhVolume,
    /// From which end it is put together.
    pub builder: BvhBuilder,
    /// How primitives are divided.
    pub split: BvhSplit,
    /// Nodes with so few primitives stay leaves.
    pub leaf_size: u32,
    /// How many bins each axis has under [`BvhSplit::Binned`].
    pub bins: u32,
    /// How many neighbours on each side a set looks at under [`BvhBuilder::Ploc`].
    pub search: u32,
    /// In which order a walk opens the nodes.
    pub order: BvhOrder,
    /// Cuts that are chosen by hand, whatever they cost.
    pub cut: ByHand,
    /// The axes along which primitives are divided.
    pub axes: Axes,
    /// How boxes are measured.
    pub measure: Measure,
}

impl Default for BvhRule {
    fn default() -> BvhRule {
        BvhRule {
            volume: BvhVolume::Aabb,
            builder: BvhBuilder::TopDown,
            split: BvhSplit::Binned,
            leaf_size: 2,
            bins: 16,
            search: 14,
            order: BvhOrder::Ordered,
            cut: ByHand::default(),
            axes: Axes::Xyz,
            measure: Measure::Area,
        }
    }
}

impl BvhRule {
    pub(super) fn slots(&mut self) -> Vec<Slot<'_>> {
        vec![
            Slot { key: "volume", about: "what bounds a node's primitives", field: Field::Word(&mut self.volume) },
            Slot {
                key: "builder",
                about: "from which end the tree is put together",
                field: Field::Word(&mut self.builder),
            },
            Slot {
                key: "split",
                about: "how a node's primitives are divided between its children",
                field: Field::Word(&mut self.split),
            },
            Slot {
                key: "leaf_size",
                about: "nodes with so few primitives stay leaves",
                field: Field::Count(&mut self.leaf_size, 1, 64),
            },
            Slot { key: "bins", about: "bins along each axis", field: Field::Count(&mut self.bins, 2, 64) },
            Slot {
                key: "search",
                about: "neighbours on each side that ploc looks at",
                field: Field::Count(&mut self.search, 1, 100),
            },
            Slot { key: "order", about: "in which order nodes are opened", field: Field::Word(&mut self.order) },
            shared::cut(&mut self.cut),
        ]
    }
}
