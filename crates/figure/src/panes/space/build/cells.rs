//! The cells of a grid that is filled: those that hold something, and those that the current primitive's box meets.

use raystep_accel::{CellId, Grow, Place};

use super::super::layer::Layer;
use super::Drawing;
use crate::moments::Fate;
use crate::theme::Role;
use crate::world::{Form, SpaceMark};

/// Most cells of a grid in one picture.
const CELLS: usize = 1024;

/// Of the cells that the box of a primitive meets, most that are drawn in space.
const MET: usize = 48;

impl Drawing<'_> {
    /// All cells while they are few; those that hold something; those of the current primitive.
    pub(super) fn cells(&mut self) {
        let (Some(grid), count @ 1..) = (self.build.structure.grid(), self.moment.cell_count) else { return };
        let outline = |role, cell: CellId| SpaceMark {
            form: Form::Box(grid.cell_bounds(cell)),
            role,
            place: Some(Place::Cell(cell)),
        };
        let filled = |cell: CellId| self.moment.cells.contains_key(&cell);
        if self.build.flat && count as usize <= CELLS {
            let role = |cell| if filled(cell) { Role::Filled } else { Role::Edge };
            self.marks.extend((0..count).map(CellId).map(|cell| outline(role(cell), cell)));
        }
        if !self.build.flat {
            let layer = Layer::middle(grid.lattice());
            self.notes.push(layer.to_string());
            self.marks.extend(layer.marks(self.moment.cells.keys().copied()));
            for (_, finer) in grid.finer().iter().filter(|(_, finer)| finer.first.0 < count) {
                let layer = Layer::middle(finer);
                self.notes.push(format!("finer {layer}"));
                self.marks.extend(layer.marks(self.moment.cells.keys().copied()));
            }
        }
        if let Some(Grow::Refine { cell, .. }) = self.moment.event {
            self.marks.push(outline(Role::Here, cell));
        }
        // Of a large flat grid only the cells that are filled are drawn.
        if self.build.flat && count as usize > CELLS {
            let filled = self.moment.cells.keys().rev().take(CELLS);
            self.marks.extend(filled.map(|cell| outline(Role::Seen, *cell)));
        }
        // Of very many in space, those around the next one to be decided.
        let met = &self.moment.rasterised;
        let most = if self.build.flat { usize::MAX } else { MET };
        let next = met.iter().position(|(_, fate)| *fate == Fate::Open).unwrap_or(met.len());
        let from = next.saturating_sub(most / 2).min(met.len().saturating_sub(most));
        if met.len() > most {
            self.notes.push(format!("its box meets {} cells, not all drawn", met.len()));
        }
        for &(cell, fate) in met.iter().skip(from).take(most) {
            let role = match fate {
                Fate::Open => Role::Waiting,
                Fate::Stored => Role::Here,
                Fate::Pruned => Role::Dropped,
            };
            self.marks.push(outline(role, cell));
            if self.build.flat {
                let form = Form::Number { within: grid.cell_bounds(cell), text: cell.to_string(), scale: 1.0 };
                let role = if role == Role::Dropped { Role::Quiet } else { role };
                self.marks.push(SpaceMark { form, role, place: Some(Place::Cell(cell)) });
            }
        }
    }
}
