//! Nested grids, slides 23 and 24: a crowded cell holds a grid of its own.

use std::cmp::Reverse;

use super::build::Building;
use super::cells::Reference;
use super::{Cells, Dense, GridOf, Lattice};
use crate::events::{patiently, sort_patiently};
use crate::{Aabb, Cancelled, CellId, GridRule, Grow, Margin, NestedRule, Observer, PrimId, Primitives, Visit};

/// A coarse grid in which each cell with many primitives holds a finer grid, and so on for some levels.
pub type NestedGrid = GridOf<Nested>;

/// The cells of the coarse grid, and after them those of the finer ones.
#[derive(Clone, Debug, PartialEq)]
pub struct Nested {
    /// What the cells of all levels refer to: nothing, where a cell has a grid of its own.
    refs: Dense,
    /// The finer grids, in the order of their first cells, each with the cell that holds it.
    finer: Vec<(CellId, Lattice)>,
    /// For each cell the place of its own grid in `finer`, or [`NONE`].
    own: Vec<u32>,
}

/// A cell without a grid of its own.
const NONE: u32 = u32::MAX;

/// A crowded cell.
struct Crowded {
    cell: CellId,
    bounds: Aabb,
    held: Vec<PrimId>,
}

impl NestedGrid {
    /// Builds nested grids over `prims`. Where the finer ones would not fit into memory they get fewer cells
    /// than asked for, or none at all.
    ///
    /// # Errors
    /// The observer cancelled it.
    pub fn build(
        prims: &impl Primitives,
        rule: &NestedRule,
        watch: &mut impl Observer<Grow>,
    ) -> Result<NestedGrid, Cancelled> {
        // The coarse grid, as if it were the only one.
        let mut building = Building::begin(prims, rule.grid.prune, |bounds, _| Margin::near(bounds), watch)?;
        let lattice = building.whole(&rule.grid, watch)?;
        let everything: Vec<PrimId> = (0..prims.len() as u32).map(PrimId).collect();
        let settled = building.insert(&lattice, &everything, watch)?;
        let (mut stay, mut crowded) = (Vec::new(), Vec::new());
        rule.part(&lattice, 1, settled, (&mut stay, &mut crowded), watch)?;

        // Level by level, the most crowded cells first: a grid of its own for each.
        let (mut count, mut finer) = (lattice.cell_count(), Vec::new());
        for level in 2..=rule.levels {
            let mut crowd = std::mem::take(&mut crowded);
            crowd.sort_by_key(|Crowded { held, .. }| Reverse(held.len()));
            for Crowded { cell, bounds, held } in crowd {
                if watch.cancelled() {
                    return Err(Cancelled);
                }
                let first = CellId(count as u32);
                let Some(inner) = building.within(&rule.inner(), bounds, &held, first, watch)? else {
                    stay.extend(held.into_iter().map(|prim| (cell, prim)));
                    continue;
                };
                let [nx, ny, nz] = inner.resolution;
                watch.on(Grow::Refine { cell, first: inner.first, nx, ny, nz, prims: held.len() as u32 });
                let settled = building.insert(&inner, &held, watch)?;
                rule.part(&inner, level, settled, (&mut stay, &mut crowded), watch)?;
                count += inner.cell_count();
                finer.push((cell, inner));
            }
        }

        let mut own = vec![NONE; count];
        for grid in patiently((0..).zip(&finer), watch) {
            let (place, (cell, _)) = grid?;
            own[cell.index()] = place;
        }
        watch.on(Grow::End { nodes: 0, cells: count as u32, references: stay.len() as u32 });
        let cells = Nested { refs: Dense::file(count, &stay, watch)?, finer, own };
        Ok(GridOf { lattice, cells, margin: building.margin, mailbox: rule.grid.mailbox })
    }
}

impl NestedRule {
    /// Divides what settled in a grid of this level: most references stay, those of a crowded cell go to its own grid.
    fn part(
        &self,
        lattice: &Lattice,
        level: u32,
        mut settled: Vec<Reference>,
        (stay, crowded): (&mut Vec<Reference>, &mut Vec<Crowded>),
        watch: &impl Observer<Grow>,
    ) -> Result<(), Cancelled> {
        sort_patiently(&mut settled, watch, |(a, _), (b, _)| a.cmp(b))?;
        for references in patiently(settled.chunk_by(|a, b| a.0 == b.0), watch) {
            let references = references?;
            if level < self.levels && references.len() > self.more_than as usize {
                let cell = references[0].0;
                let held = references.iter().map(|(_, prim)| *prim).collect();
                crowded.push(Crowded { cell, bounds: lattice.cell_bounds(cell), held });
            } else {
                stay.extend_from_slice(references);
            }
        }
        Ok(())
    }

    /// How a grid within a cell is built.
    fn inner(&self) -> GridRule {
        GridRule { resolution: self.inner_resolution, factor: self.inner_factor, cells: [0; 3], ..self.grid }
    }
}

impl Cells for Nested {
    #[inline]
    fn look_up(&self, cell: CellId, watch: &mut impl Observer<Visit>) -> &[PrimId] {
        self.refs.look_up(cell, watch)
    }

    fn finer(&self) -> &[(CellId, Lattice)] {
        &self.finer
    }

    #[inline]
    fn within(&self, cell: CellId) -> Option<&Lattice> {
        match self.own[cell.index()] {
            NONE => None,
            place => Some(&self.finer[place as usize].1),
        }
    }

    fn reference_count(&self) -> usize {
        self.refs.reference_count()
    }

    fn bytes(&self) -> usize {
        self.refs.bytes() + size_of_val(&*self.finer) + size_of_val(&*self.own)
    }
}
