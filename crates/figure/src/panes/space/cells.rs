//! The cells of a grid: all of them while they are few, else those along the ray; and those of the grids within.

use raystep_accel::{AnyGrid, Axis, CellId, Lattice, Place, Visit};

use super::Drawing;
use crate::theme::Role;
use crate::words::number;
use crate::world::Form;

/// A flat grid with more cells than this shows only those that the walk has entered.
const FEW: usize = 1024;

/// Of a long walk, so many of the cells last left are outlined.
const TRAIL: usize = 256;

impl Drawing<'_> {
    pub(super) fn cells(&mut self, grid: &dyn AnyGrid) {
        let few = grid.cell_count() <= FEW;
        if !grid.lattice().bounds.is_empty() {
            self.lattice(grid.lattice(), Place::World);
        }
        for (holder, finer) in grid.finer() {
            if few || self.moment.within.contains(holder) {
                self.lattice(finer, Place::Cell(*holder));
            }
        }
        let seen = &self.moment.seen;
        for &place in &seen[seen.len().saturating_sub(TRAIL)..] {
            self.outline(Role::Seen, place);
        }
        for &holder in &self.moment.within {
            self.outline(Role::Seen, Place::Cell(holder));
        }
        if let Some(here @ Place::Cell(cell)) = self.moment.here {
            self.outline(Role::Here, here);
            self.title(Role::Here, here, self.here(&cell.to_string()));
        }
    }

    /// Equal cells: in a flat scene each of them while they are few, else their box.
    fn lattice(&mut self, lattice: &Lattice, holder: Place) {
        if self.walk.flat && lattice.cell_count() <= FEW {
            let first = lattice.first.0;
            for cell in (first..first + lattice.cell_count() as u32).map(CellId) {
                let place = Place::Cell(cell);
                self.outline(self.ground(place), place);
            }
        } else {
            self.add(Role::Edge, Some(holder), Form::Box(lattice.bounds));
        }
    }

    /// At a step, where the ray meets the next plane of each axis: the first of them decides.
    pub(super) fn next_planes(&mut self) {
        let (Some(Visit::Step { .. }), Some(stepping)) = (self.moment.event, self.moment.stepping) else { return };
        for axis in Axis::ALL {
            if self.walk.flat && axis == Axis::Z {
                continue;
            }
            let t = stepping.next[axis.index()];
            self.ring(Role::Tick, self.moment.here, t, Some(format!("next {axis}: {}", number(t))));
        }
    }
}
