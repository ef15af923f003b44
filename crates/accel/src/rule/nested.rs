//! How nested grids are to be built.

use super::parameter::{Field, Slot};
use super::{GridRule, Resolution};

/// The parameters of nested grids.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NestedRule {
    /// The coarse grid, and what holds on all levels.
    pub grid: GridRule,
    /// How many levels there may be; with one it is a uniform grid.
    pub levels: u32,
    /// Cells with more primitives than this get a grid of their own.
    pub more_than: u32,
    /// How the resolution of a cell's own grid is found.
    pub inner_resolution: Resolution,
    /// The factor in it.
    pub inner_factor: f32,
}

impl Default for NestedRule {
    fn default() -> NestedRule {
        NestedRule {
            grid: GridRule::default(),
            levels: 2,
            more_than: 8,
            inner_resolution: Resolution::Longest,
            inner_factor: 3.0,
        }
    }
}

impl NestedRule {
    /// The most levels that may be asked for.
    pub const MOST_LEVELS: u32 = 6;

    pub(super) fn slots(&mut self) -> Vec<Slot<'_>> {
        let mut slots = self.grid.slots();
        slots.extend([
            Slot {
                key: "levels",
                about: "how many levels of grids there may be",
                field: Field::Count(&mut self.levels, 1, NestedRule::MOST_LEVELS),
            },
            Slot {
                key: "more_than",
                about: "cells with more primitives than this get a grid of their own",
                field: Field::Count(&mut self.more_than, 1, 1000),
            },
            Slot {
                key: "inner_resolution",
                about: "how the number of cells of a cell's own grid is found",
                field: Field::Word(&mut self.inner_resolution),
            },
            Slot {
                key: "inner_factor",
                about: "the factor in that rule",
                field: Field::Real(&mut self.inner_factor, 0.1, 20.0),
            },
        ]);
        slots
    }
}
