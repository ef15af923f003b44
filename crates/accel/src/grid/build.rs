//! Building a grid, slides 17 and 18: the same steps whatever the cells are stored in.

use super::cells::Reference;
use super::resolution::{FEW_REFERENCES, Room, asked};
use super::{Dense, Grid, GridOf, Lattice};
use crate::events::{BETWEEN_LOOKS, patiently};
use crate::{Aabb, Axis, Cancelled, CellId, GridRule, Grow, Margin, Observer, Place, PrimId, Primitives, around};

impl Grid {
    /// Builds a grid over `prims`. Grids that would not fit into memory get fewer cells than asked for.
    ///
    /// # Errors
    /// The observer cancelled it.
    pub fn build(prims: &impl Primitives, rule: &GridRule, watch: &mut impl Observer<Grow>) -> Result<Grid, Cancelled> {
        GridOf::uniform(prims, rule, watch, |count, settled, watch| Dense::file(count, &settled, watch))
    }
}

impl<C> GridOf<C> {
    /// Builds a uniform grid; `file` stores the references to so many cells.
    pub(super) fn uniform<W: Observer<Grow>>(
        prims: &impl Primitives,
        rule: &GridRule,
        watch: &mut W,
        file: impl FnOnce(usize, Vec<Reference>, &W) -> Result<C, Cancelled>,
    ) -> Result<GridOf<C>, Cancelled> {
        let building = Building::begin(prims, rule.prune, Margin::of, watch)?;
        let lattice = building.whole(rule, watch)?;
        let everything: Vec<PrimId> = (0..prims.len() as u32).map(PrimId).collect();
        let settled = building.insert(&lattice, &everything, watch)?;
        let (count, references) = (lattice.cell_count(), settled.len());
        let cells = file(count, settled, watch)?;
        watch.on(Grow::End { nodes: 0, cells: count as u32, references: references as u32 });
        Ok(GridOf { lattice, cells, margin: building.margin, mailbox: rule.mailbox })
    }
}

/// So many primitives say whether a grid separates them.
const FEW: usize = 64;

/// A build under way.
pub(super) struct Building<'a, P> {
    prims: &'a P,
    prune: bool,
    bounds: Aabb,
    pub(super) margin: Margin,
    /// The primitives' boxes, widened by the margin.
    reaches: Vec<Aabb>,
    /// What is left for grids within cells.
    room: Room,
}

impl<'a, P: Primitives> Building<'a, P> {
    /// Finds the box around all primitives.
    pub(super) fn begin(
        prims: &'a P,
        prune: bool,
        margin: impl FnOnce(&Aabb, usize) -> Margin,
        watch: &mut impl Observer<Grow>,
    ) -> Result<Building<'a, P>, Cancelled> {
        let bounds = around(prims, watch)?;
        let margin = margin(&bounds, prims.len());
        let reach = |prim| Ok(prims.bounds(prim?).padded(margin.pad));
        let reaches = patiently((0..prims.len() as u32).map(PrimId), watch).map(reach).collect::<Result<_, _>>()?;
        Ok(Building { prims, prune, bounds, margin, reaches, room: Room::within(prims.len()) })
    }

    /// Chooses the resolution of the grid over everything.
    pub(super) fn whole(&self, rule: &GridRule, watch: &mut impl Observer<Grow>) -> Result<Lattice, Cancelled> {
        let (bounds, prims) = (self.bounds, self.prims.len());
        let mut lattice = Lattice { bounds, resolution: asked(rule, &bounds, prims), first: CellId(0) };
        let touched = Room::over(prims).fit(&mut lattice, &self.reaches, watch)?;
        let everything = |i: usize| PrimId(i as u32);
        if touched > FEW_REFERENCES && !self.separates(&lattice, prims, everything) {
            Room::few().fit(&mut lattice, &self.reaches, watch)?;
        }
        let [nx, ny, nz] = lattice.resolution;
        watch.on(Grow::Resolve { bounds, nx, ny, nz, prims: prims as u32 });
        Ok(lattice)
    }

    /// Chooses the resolution of the grid within a cell; nothing if there is no room to divide the cell.
    pub(super) fn within(
        &mut self,
        rule: &GridRule,
        bounds: Aabb,
        held: &[PrimId],
        first: CellId,
        watch: &impl Observer<Grow>,
    ) -> Result<Option<Lattice>, Cancelled> {
        let mut resolution = asked(rule, &bounds, held.len());
        // Cells narrower than their margins would part nothing.
        for axis in Axis::ALL {
            let most = bounds.extent()[axis] / (2.0 * self.margin.pad);
            resolution[axis.index()] = resolution[axis.index()].min(most as u32).max(1);
        }
        let mut lattice = Lattice { bounds, resolution, first };
        let reaches: Vec<Aabb> = held.iter().map(|prim| self.reaches[prim.index()]).collect();
        let mut touched = self.room.fit(&mut lattice, &reaches, watch)?;
        if touched > FEW_REFERENCES && !self.separates(&lattice, held.len(), |i| held[i]) {
            touched = Room::few().fit(&mut lattice, &reaches, watch)?;
        }
        Ok(self.room.give(&lattice, touched).then_some(lattice))
    }

    /// Whether the cells of a large grid separate its primitives, judged by a few of them: identical ones, and others
    /// that lie in one another, are together in every cell, and dividing that makes references and saves no test.
    fn separates(&self, lattice: &Lattice, count: usize, prim: impl Fn(usize) -> PrimId) -> bool {
        let few = count.min(FEW);
        let held = (0..few).map(|i| prim(i * count / few));
        let mut cells: Vec<CellId> = held.flat_map(|prim| self.cells_held(lattice, prim)).collect();
        cells.sort_unstable();
        let references = cells.len();
        cells.dedup();
        // Half of them in each cell, on average.
        2 * references < few * cells.len()
    }

    /// The cells that a primitive reaches into.
    fn cells_held(&self, lattice: &Lattice, prim: PrimId) -> impl Iterator<Item = CellId> {
        let touched = lattice.cells_of(&self.reaches[prim.index()]);
        touched.filter(move |cell| !self.prune || self.overlaps(prim, &lattice.cell_bounds(*cell)))
    }

    /// Inserts one primitive after the other: finds the cells that are to refer to it.
    pub(super) fn insert(
        &self,
        lattice: &Lattice,
        held: &[PrimId],
        watch: &mut impl Observer<Grow>,
    ) -> Result<Vec<Reference>, Cancelled> {
        let mut settled = Vec::new();
        for (number, &prim) in held.iter().enumerate() {
            if number % BETWEEN_LOOKS == 0 && watch.cancelled() {
                return Err(Cancelled);
            }
            // The cells that its box touches.
            let reach = &self.reaches[prim.index()];
            for cell in lattice.cells_of(reach) {
                watch.on(Grow::Rasterise { prim, cell });
            }
            for cell in lattice.cells_of(reach) {
                // The primitive itself does not reach this one.
                if self.prune && !self.overlaps(prim, &lattice.cell_bounds(cell)) {
                    watch.on(Grow::Prune { prim, cell });
                    continue;
                }
                watch.on(Grow::Settle { prim, place: Place::Cell(cell) });
                settled.push((cell, prim));
            }
        }
        Ok(settled)
    }

    /// Whether a primitive reaches into a cell or comes close.
    fn overlaps(&self, prim: PrimId, cell: &Aabb) -> bool {
        self.prims.overlaps(prim, &cell.padded(self.margin.pad))
    }
}
