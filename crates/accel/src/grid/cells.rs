//! What cells refer to: the trait behind all grids, and the plain array of slides 18 and 20.

use super::Lattice;
use crate::events::patiently;
use crate::{Cancelled, CellId, Grow, Observer, PrimId, Visit};

/// A reference from a cell to a primitive.
pub(super) type Reference = (CellId, PrimId);

/// The contents of a grid's cells, however they are stored.
pub trait Cells {
    /// What a cell refers to, looked up as a walk does.
    fn look_up(&self, cell: CellId, watch: &mut impl Observer<Visit>) -> &[PrimId];

    /// The grids within cells, in the order of their first cells, each with the cell that holds it.
    fn finer(&self) -> &[(CellId, Lattice)] {
        &[]
    }

    /// The grid within a cell, if it has one.
    #[inline(always)]
    fn within(&self, _: CellId) -> Option<&Lattice> {
        None
    }

    /// The number of references from cells to primitives.
    fn reference_count(&self) -> usize;

    /// How much memory its arrays take.
    fn bytes(&self) -> usize;
}

/// The references of all cells in one array, one cell after the other.
#[derive(Clone, Debug, PartialEq)]
pub struct Dense {
    /// Where each cell's references begin in `refs`, and at last where they all end.
    starts: Vec<u32>,
    refs: Vec<PrimId>,
}

impl Dense {
    /// Sorts the references to `count` cells by cell, in the order in which they settled.
    pub(super) fn file(count: usize, settled: &[Reference], watch: &impl Observer<Grow>) -> Result<Dense, Cancelled> {
        let mut starts = vec![0; count + 1];
        for reference in patiently(settled, watch) {
            starts[reference?.0.index() + 1] += 1;
        }
        for cell in patiently(1..starts.len(), watch) {
            let cell = cell?;
            starts[cell] += starts[cell - 1];
        }
        let mut next = starts.clone();
        let mut refs = vec![PrimId(0); settled.len()];
        for reference in patiently(settled, watch) {
            let &(cell, prim) = reference?;
            let place = &mut next[cell.index()];
            refs[*place as usize] = prim;
            *place += 1;
        }
        Ok(Dense { starts, refs })
    }

    /// How much memory so many cells and references take.
    pub(super) fn bytes_of(cells: usize, references: usize) -> usize {
        (cells + 1) * size_of::<u32>() + references * size_of::<PrimId>()
    }
}

impl Cells for Dense {
    #[inline]
    fn look_up(&self, cell: CellId, _: &mut impl Observer<Visit>) -> &[PrimId] {
        &self.refs[self.starts[cell.index()] as usize..self.starts[cell.index() + 1] as usize]
    }

    fn reference_count(&self) -> usize {
        self.refs.len()
    }

    fn bytes(&self) -> usize {
        Dense::bytes_of(self.starts.len() - 1, self.refs.len())
    }
}
