//! How a uniform grid is to be built.

use super::parameter::{Field, Slot, choice};
use super::shared;
use crate::Axes;
use crate::events::words;

words! {
    /// How the number of cells follows from the number of primitives, n.
    pub enum Resolution {
        /// `factor · ∛n` cells along every axis, whatever the shape of the box (slide 17).
        Cubic = "3n",
        /// `factor · ∛n` cells along the longest axis, cubes along the others (Pharr and Humphreys).
        Longest = "longest",
        /// Cubes, so large that there are `factor` of them for each primitive.
        Density = "density",
    }
}
choice!(Resolution);

/// The parameters of a uniform grid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridRule {
    /// How the resolution is found.
    pub resolution: Resolution,
    /// The factor in it.
    pub factor: f32,
    /// Cells along x, y and z; 0 leaves an axis to `resolution`.
    pub cells: [u32; 3],
    /// Whether a ray remembers which primitives it tested.
    pub mailbox: bool,
    /// Whether cells that a primitive's box meets but the primitive does not are left out.
    pub prune: bool,
    /// The axes to divide: a flat scene has one layer in z.
    pub axes: Axes,
}

impl Default for GridRule {
    fn default() -> GridRule {
        GridRule {
            resolution: Resolution::Longest,
            factor: 3.0,
            cells: [0; 3],
            mailbox: true,
            prune: true,
            axes: Axes::Xyz,
        }
    }
}

impl GridRule {
    /// The most cells along an axis that may be asked for.
    pub const MOST: u32 = 512;

    pub(super) fn slots(&mut self) -> Vec<Slot<'_>> {
        let [nx, ny, nz] = &mut self.cells;
        vec![
            Slot {
                key: "resolution",
                about: "how the number of cells follows from the number of primitives",
                field: Field::Word(&mut self.resolution),
            },
            Slot { key: "factor", about: "the factor in that rule", field: Field::Real(&mut self.factor, 0.1, 20.0) },
            Slot { key: "nx", about: "cells along x; 0: by the rule", field: Field::Count(nx, 0, GridRule::MOST) },
            Slot { key: "ny", about: "cells along y; 0: by the rule", field: Field::Count(ny, 0, GridRule::MOST) },
            Slot { key: "nz", about: "cells along z; 0: by the rule", field: Field::Count(nz, 0, GridRule::MOST) },
            shared::mailbox(&mut self.mailbox),
            Slot {
                key: "prune",
                about: "leave out cells that the primitive itself does not reach",
                field: Field::Flag(&mut self.prune),
            },
        ]
    }
}
