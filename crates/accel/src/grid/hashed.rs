//! The hashed grid of slide 63: only occupied cells are stored.

use super::cells::Reference;
use super::{Cells, Dense, GridOf};
use crate::events::{patiently, sort_patiently};
use crate::{Cancelled, CellId, GridRule, Grow, Observer, PrimId, Primitives, Probed, Visit};

/// A uniform grid whose occupied cells are found by hashing. It has the cells of the plain one, and a walk
/// takes the same steps: hashing skips no empty cell, it only stores none.
pub type HashedGrid = GridOf<Hashed>;

/// The occupied cells in a hash table with open addressing: a cell that finds its slot taken looks in the next.
#[derive(Clone, Debug, PartialEq)]
pub struct Hashed {
    /// A power of two of them, at most half of them occupied.
    slots: Vec<Slot>,
    /// The references of the occupied cells, one cell after the other.
    refs: Vec<PrimId>,
}

/// A cell with where its references begin and end.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Slot {
    cell: CellId,
    start: u32,
    end: u32,
}

impl Slot {
    /// No grid has a cell of this number.
    const EMPTY: Slot = Slot { cell: CellId(u32::MAX), start: 0, end: 0 };
}

impl HashedGrid {
    /// How many bytes a slot of the table takes.
    pub const SLOT_BYTES: usize = size_of::<Slot>();

    /// Builds a grid over `prims`. Grids that would not fit into memory get fewer cells than asked for.
    ///
    /// # Errors
    /// The observer cancelled it.
    pub fn build(
        prims: &impl Primitives,
        rule: &GridRule,
        watch: &mut impl Observer<Grow>,
    ) -> Result<HashedGrid, Cancelled> {
        GridOf::uniform(prims, rule, watch, |_, settled, watch| Hashed::file(settled, watch))
    }

    /// How many bytes the same grid would take with all its cells stored.
    pub fn dense_bytes(&self) -> usize {
        size_of::<super::Grid>() + Dense::bytes_of(self.lattice.cell_count(), self.cells.refs.len())
    }

    /// How many slots the table has.
    pub fn slot_count(&self) -> u32 {
        self.cells.slots.len() as u32
    }

    /// The cell that sits in a slot, and how many primitives it refers to; none if the slot is free.
    pub fn slot(&self, slot: u32) -> Option<(CellId, u32)> {
        let Slot { cell, start, end } = self.cells.slots[slot as usize];
        (cell != Slot::EMPTY.cell).then_some((cell, end - start))
    }
}

impl Hashed {
    fn file(mut settled: Vec<Reference>, watch: &impl Observer<Grow>) -> Result<Hashed, Cancelled> {
        sort_patiently(&mut settled, watch, |(a, _), (b, _)| a.cmp(b))?;
        let occupied = settled.chunk_by(|a, b| a.0 == b.0);
        // At least half of the slots stay empty, so that no search is long.
        let slots = (2 * occupied.clone().count()).next_power_of_two().max(2);
        let mut table = Hashed { slots: vec![Slot::EMPTY; slots], refs: Vec::with_capacity(settled.len()) };
        for references in patiently(occupied, watch) {
            let references = references?;
            let (cell, start) = (references[0].0, table.refs.len() as u32);
            table.refs.extend(references.iter().map(|(_, prim)| prim));
            let slot = table.find(cell, &mut ());
            table.slots[slot] = Slot { cell, start, end: table.refs.len() as u32 };
        }
        Ok(table)
    }

    /// The slot that holds a cell, or the empty one where it would be.
    #[inline]
    fn find(&self, cell: CellId, watch: &mut impl Observer<Visit>) -> usize {
        let mut slot = self.home(cell);
        loop {
            let holds = match self.slots[slot].cell {
                held if held == cell => Probed::Found,
                held if held == Slot::EMPTY.cell => Probed::Empty,
                _ => Probed::Taken,
            };
            watch.on(Visit::Probe { cell, slot: slot as u32, holds });
            if holds != Probed::Taken {
                return slot;
            }
            // Look in the next slot, after the last one in the first.
            slot = (slot + 1) % self.slots.len();
        }
    }

    /// Where the search for a cell begins: the upper bits of its product with 2³² / φ (Knuth 1973).
    #[inline]
    fn home(&self, cell: CellId) -> usize {
        (cell.0.wrapping_mul(0x9E37_79B9) >> (32 - self.slots.len().trailing_zeros())) as usize
    }
}

impl Cells for Hashed {
    #[inline]
    fn look_up(&self, cell: CellId, watch: &mut impl Observer<Visit>) -> &[PrimId] {
        let Slot { start, end, .. } = self.slots[self.find(cell, watch)];
        &self.refs[start as usize..end as usize]
    }

    fn reference_count(&self) -> usize {
        self.refs.len()
    }

    fn bytes(&self) -> usize {
        size_of_val(&*self.slots) + size_of_val(&*self.refs)
    }
}
