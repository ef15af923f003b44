//! Building a grid, slides 17 and 18.

use super::Grid;
use super::resolution::asked;
use crate::{Aabb, Cancelled, CellId, GridRule, Grow, Margin, Observer, Place, PrimId, Primitives};

/// How many primitives are inserted between two looks at whether to give up.
const BETWEEN_LOOKS: u32 = 256;

impl Grid {
    /// Builds a grid over `prims`. Grids that would not fit into memory get fewer cells than asked for.
    ///
    /// # Errors
    /// The observer cancelled it.
    pub fn build(prims: &impl Primitives, rule: &GridRule, watch: &mut impl Observer<Grow>) -> Result<Grid, Cancelled> {
        let ids = || (0..prims.len() as u32).map(PrimId);

        // The box around all primitives.
        let mut bounds = Aabb::EMPTY;
        for prim in ids() {
            let before = bounds;
            bounds = before.union(prims.bounds(prim));
            watch.on(Grow::Widen { prim, bounds, grown: bounds != before });
        }

        // The resolution.
        let margin = Margin::of(&bounds);
        let reaches: Vec<Aabb> = ids().map(|prim| prims.bounds(prim).padded(margin.pad)).collect();
        let mut grid = Grid {
            bounds,
            resolution: asked(rule, &bounds, prims.len()),
            starts: Vec::new(),
            refs: Vec::new(),
            margin,
            mailbox: rule.mailbox,
        };
        grid.coarsen(&reaches);
        let [nx, ny, nz] = grid.resolution;
        watch.on(Grow::Resolve { bounds, nx, ny, nz, prims: prims.len() as u32 });

        // Insert one primitive after the other.
        let mut settled = Vec::new();
        for prim in ids() {
            if prim.0 % BETWEEN_LOOKS == 0 && watch.cancelled() {
                return Err(Cancelled);
            }
            grid.insert(prims, prim, &reaches[prim.index()], rule.prune, &mut settled, watch);
        }
        grid.file(&settled);
        let (cells, references) = (grid.cell_count() as u32, grid.reference_count() as u32);
        watch.on(Grow::End { nodes: 0, cells, references });
        Ok(grid)
    }

    /// Finds the cells that are to refer to a primitive.
    fn insert(
        &self,
        prims: &impl Primitives,
        prim: PrimId,
        reach: &Aabb,
        prune: bool,
        settled: &mut Vec<(CellId, PrimId)>,
        watch: &mut impl Observer<Grow>,
    ) {
        // The cells that its box touches.
        for cell in self.cells_of(reach) {
            watch.on(Grow::Rasterise { prim, cell });
        }
        for cell in self.cells_of(reach) {
            // The primitive itself does not reach this one.
            if prune && !prims.overlaps(prim, &self.cell_bounds(cell).padded(self.margin.pad)) {
                watch.on(Grow::Prune { prim, cell });
                continue;
            }
            watch.on(Grow::Settle { prim, place: Place::Cell(cell) });
            settled.push((cell, prim));
        }
    }

    /// The cells that a box touches, row by row.
    fn cells_of(&self, reach: &Aabb) -> impl Iterator<Item = CellId> {
        let [xs, ys, zs] = self.rasterise(reach);
        let rows = zs.flat_map(move |z| ys.clone().map(move |y| (y, z)));
        rows.flat_map(move |(y, z)| xs.clone().map(move |x| self.cell_at(x, y, z)))
    }

    /// Sorts the references by cell, in the order in which they settled.
    fn file(&mut self, settled: &[(CellId, PrimId)]) {
        let [nx, ny, nz] = self.resolution;
        self.starts = vec![0; (nx * ny * nz) as usize + 1];
        for (cell, _) in settled {
            self.starts[cell.index() + 1] += 1;
        }
        for cell in 1..self.starts.len() {
            self.starts[cell] += self.starts[cell - 1];
        }
        let mut next = self.starts.clone();
        self.refs = vec![PrimId(0); settled.len()];
        for &(cell, prim) in settled {
            let place = &mut next[cell.index()];
            self.refs[*place as usize] = prim;
            *place += 1;
        }
    }
}
