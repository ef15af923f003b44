//! What views ask of a grid.

use super::{Cells, GridOf, Lattice};
use crate::{Aabb, CellId, PrimId};

/// A grid of any kind, whatever its cells are stored in.
pub trait AnyGrid {
    /// The cells over everything; in nested grids the coarse ones.
    fn lattice(&self) -> &Lattice;

    /// The grids within cells, in the order of their first cells, each with the cell that holds it.
    fn finer(&self) -> &[(CellId, Lattice)];

    /// What a cell refers to: nothing, if it holds a grid.
    fn cell_prims(&self, cell: CellId) -> &[PrimId];

    /// The number of references from cells to primitives.
    fn reference_count(&self) -> usize;

    /// How much memory it takes.
    fn bytes(&self) -> usize;

    /// The number of cells on all levels.
    fn cell_count(&self) -> usize {
        self.finer().last().map_or(self.lattice().cell_count(), |(_, last)| last.first.index() + last.cell_count())
    }

    /// The equal cells among which a cell lies, and the cell that holds them all, if there is one.
    fn around(&self, cell: CellId) -> (&Lattice, Option<CellId>) {
        match self.finer().partition_point(|(_, finer)| finer.first <= cell) {
            0 => (self.lattice(), None),
            after => {
                let (holder, finer) = &self.finer()[after - 1];
                (finer, Some(*holder))
            }
        }
    }

    /// A cell's box.
    fn cell_bounds(&self, cell: CellId) -> Aabb {
        self.around(cell).0.cell_bounds(cell)
    }

    /// A cell's place among its equals, counted in cells.
    fn cell_place(&self, cell: CellId) -> [u32; 3] {
        self.around(cell).0.cell_place(cell)
    }

    /// The cells that hold a cell, the coarse one first; it itself is the last.
    fn path(&self, cell: CellId) -> Vec<CellId> {
        let mut path: Vec<CellId> = std::iter::successors(Some(cell), |&cell| self.around(cell).1).collect();
        path.reverse();
        path
    }
}

impl<C: Cells> AnyGrid for GridOf<C> {
    fn lattice(&self) -> &Lattice {
        &self.lattice
    }

    fn finer(&self) -> &[(CellId, Lattice)] {
        self.cells.finer()
    }

    fn cell_prims(&self, cell: CellId) -> &[PrimId] {
        self.cells.look_up(cell, &mut ())
    }

    fn reference_count(&self) -> usize {
        self.cells.reference_count()
    }

    fn bytes(&self) -> usize {
        size_of::<GridOf<C>>() + self.cells.bytes()
    }
}
