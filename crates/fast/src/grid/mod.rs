//! The grid, slides 16-22, at production speed: three additions to a step, and cells whose triangles stand in lanes.

mod walk;

use raystep_accel::{AnyGrid, CellId, Grid as Textbook, GridRule, Hit, Lattice, Margin, Mesh, Primitives, Ray, Want};

use crate::fast::Fast;
use crate::judge::{Count, NotOrdinary};
use crate::lanes::{Isa, dispatch};
use crate::leaf::{Four, any_ray};

/// A uniform grid: the textbook's, packed.
#[derive(Clone, Debug)]
pub struct Grid {
    lattice: Lattice,
    margin: Margin,
    /// Where the fours of each cell begin, and at last where they all end.
    starts: Vec<u32>,
    cells: Vec<Four>,
    reach: f32,
    isa: Isa,
}

impl Grid {
    /// Builds it as the textbook does, and packs it.
    pub fn build(mesh: &Mesh) -> Grid {
        let grid = match Textbook::build(mesh, &GridRule::default(), &mut ()) {
            Ok(grid) => grid,
            Err(cancelled) => unreachable!("nobody asks to give up: {cancelled}"),
        };
        let (mut starts, mut cells) = (vec![0], Vec::new());
        for cell in (0..grid.cell_count() as u32).map(CellId) {
            let prims: Vec<u32> = grid.cell_prims(cell).iter().map(|prim| prim.0).collect();
            cells.extend(prims.chunks(Four::LANES).map(|prims| Four::of(mesh, prims)));
            starts.push(cells.len() as u32);
        }
        let lattice = grid.lattice().clone();
        let bounds = lattice.bounds;
        let reach = if bounds.is_empty() { 0.0 } else { bounds.min.abs().max(bounds.max.abs()).max_element() };
        Grid { margin: Margin::of(&bounds, mesh.len()), lattice, starts, cells, reach, isa: Isa::best() }
    }

    /// The same with other instructions.
    #[must_use]
    pub fn with(self, isa: Isa) -> Grid {
        Grid { isa, ..self }
    }
}

impl Fast for Grid {
    fn walk(&self, ray: &Ray, want: Want, count: &mut impl Count) -> Option<Hit> {
        // As in the textbook, a ray from too far away cannot be told which cells it meets.
        let walked = if self.margin.bars(ray).is_some() {
            Err(NotOrdinary)
        } else {
            let Grid { lattice, starts, cells, reach, .. } = self;
            dispatch!(self.isa, walk::walk(lattice, starts, cells, ray, *reach, want, count))
        };
        walked.unwrap_or_else(|NotOrdinary| any_ray(&self.cells, ray, want, count))
    }

    fn bytes(&self) -> usize {
        size_of_val(&*self.starts) + size_of_val(&*self.cells)
    }
}
