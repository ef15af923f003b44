//! The cells of a grid: all of them while they are few, else those along the ray.

use raystep_accel::{Axis, CellId, Grid, Place, Visit};

use super::{Drawing, Form};
use crate::{Role, number};

/// A flat grid with more cells than this shows only those that the walk has entered.
const FEW: usize = 1024;

/// Of a long walk, so many of the cells last left are outlined.
const TRAIL: usize = 256;

impl Drawing<'_> {
    pub(super) fn cells(&mut self, grid: &Grid) {
        if self.walk.flat && grid.cell_count() <= FEW {
            for cell in (0..grid.cell_count() as u32).map(CellId) {
                self.outline(Role::Edge, Place::Cell(cell));
            }
        } else if !grid.bounds.is_empty() {
            self.add(Role::Edge, Some(Place::World), Form::Box(grid.bounds));
        }
        let seen = &self.moment.seen;
        for &place in &seen[seen.len().saturating_sub(TRAIL)..] {
            self.outline(Role::Seen, place);
        }
        if let Some(here @ Place::Cell(cell)) = self.moment.here {
            self.outline(Role::Here, here);
            self.title(Role::Here, here, format!("{cell} here"));
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
