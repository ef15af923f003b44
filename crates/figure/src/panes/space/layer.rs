//! One layer of a grid in space: its lines, and which of its cells refer to something. All cells at once would be a
//! tangle.

use std::fmt::{Display, Formatter};

use raystep_accel::{Aabb, Axis, CellId, Lattice, Place};

use crate::theme::Role;
use crate::world::{Form, SpaceMark};

/// A layer of the cells of a grid.
pub(super) struct Layer<'a> {
    lattice: &'a Lattice,
    across: Axis,
    index: u32,
}

impl Layer<'_> {
    /// The layer in the middle, upright to the side that is neither the longest nor the shortest: it shows most.
    pub(super) fn middle(lattice: &Lattice) -> Layer<'_> {
        let mut axes = Axis::ALL;
        axes.sort_by_key(|axis| lattice.resolution[axis.index()]);
        let across = axes[1];
        Layer { lattice, across, index: lattice.resolution[across.index()] / 2 }
    }

    /// A box cut down to the middle of the layer.
    fn cut(&self, mut bounds: Aabb) -> Aabb {
        let [low, high] = [self.index, self.index + 1].map(|index| self.lattice.plane(self.across, index));
        let middle = low + (high - low) * 0.5;
        bounds.min[self.across] = middle;
        bounds.max[self.across] = middle;
        bounds
    }

    /// The lines between its cells, and those of its cells that are `filled`.
    pub(super) fn marks(&self, filled: impl Iterator<Item = CellId>) -> Vec<SpaceMark> {
        let mark = |form, role, place| SpaceMark { form, role, place: Some(place) };
        let room = self.cut(self.lattice.bounds);
        let lines = Axis::ALL.into_iter().filter(|axis| *axis != self.across).flat_map(|axis| {
            (0..=self.lattice.resolution[axis.index()]).map(move |index| {
                let (mut from, mut to) = (room.min, room.max);
                from[axis] = self.lattice.plane(axis, index);
                to[axis] = from[axis];
                mark(Form::Segment(from, to), Role::Edge, Place::World)
            })
        });
        let own = self.lattice.first.index()..self.lattice.first.index() + self.lattice.cell_count();
        let is_here = |cell: &CellId| {
            own.contains(&cell.index()) && self.lattice.cell_place(*cell)[self.across.index()] == self.index
        };
        let sheet = |cell| {
            let sheet = Form::Sheet(self.cut(self.lattice.cell_bounds(cell)));
            mark(sheet, Role::Seen, Place::Cell(cell))
        };
        lines.chain(filled.filter(is_here).map(sheet)).collect()
    }
}

impl Display for Layer<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        let layers = self.lattice.resolution[self.across.index()];
        write!(f, "cells: layer {} of {layers} across {}", self.index + 1, self.across.name())
    }
}
