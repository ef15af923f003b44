//! How many cells, slide 17.

use super::Lattice;
use crate::events::patiently;
use crate::{Aabb, Axes, Axis, Cancelled, GridRule, Grow, Observer, Resolution};

/// No grid has more cells than this, nor have all the grids within its cells.
const MOST_CELLS: u64 = 1 << 24;
/// No grid has more references than this, unless there are more primitives.
const MOST_REFERENCES: u64 = 1 << 24;

/// A grid with at most so many references costs little, even if it separates nothing.
pub(super) const FEW_REFERENCES: u64 = 1 << 16;

/// The number of cells that `rule` asks for along each axis of a box with `prims` primitives in it.
pub(super) fn asked(rule: &GridRule, bounds: &Aabb, prims: usize) -> [u32; 3] {
    let extent = bounds.extent();
    // Axes along which there is something to divide.
    let wide = |axis: Axis| rule.axes.list().contains(&axis) && extent[axis] > 0.0 && extent[axis].is_finite();
    let across_longest = f64::from(rule.factor) * libm::cbrt(prims as f64);
    let cells = |axis: Axis| match rule.resolution {
        Resolution::Cubic => across_longest,
        Resolution::Longest => across_longest * f64::from(extent[axis] / extent[bounds.longest(rule.axes)]),
        Resolution::Density => {
            f64::from(extent[axis]) / cube_side(bounds, rule.axes, f64::from(rule.factor) * prims as f64)
        }
    };
    Axis::ALL.map(|axis| match rule.cells[axis.index()] {
        _ if !wide(axis) => 1,
        0 => cells(axis).round().clamp(1.0, 4096.0) as u32,
        n => n,
    })
}

/// The side of a cube (a square, where only two axes have any length) of which `count` fill the box.
fn cube_side(bounds: &Aabb, axes: Axes, count: f64) -> f64 {
    let sides = axes.list().iter().map(|&axis| f64::from(bounds.extent()[axis])).filter(|&side| side > 0.0);
    let (dimensions, volume) = sides.fold((0, 1.0), |(n, volume), side| (n + 1, volume * side));
    match dimensions {
        3 => libm::cbrt(volume / count),
        2 => (volume / count).sqrt(),
        _ => volume / count,
    }
}

/// How many cells and references there may still be.
pub(super) struct Room {
    cells: u64,
    references: u64,
}

impl Room {
    /// The room for a scene of so many primitives.
    pub(super) fn over(prims: usize) -> Room {
        Room { cells: MOST_CELLS, references: MOST_REFERENCES.max(prims as u64) }
    }

    /// The room for all grids within the cells of the one over everything: in proportion to the scene, since
    /// primitives that no grid can separate would fill any room.
    pub(super) fn within(prims: usize) -> Room {
        let share = |each: u64, most: u64| (each * prims as u64 + (1 << 16)).min(most);
        Room { cells: share(128, MOST_CELLS), references: share(128, MOST_REFERENCES) }
    }

    /// The room for a grid that separates nothing.
    pub(super) fn few() -> Room {
        Room { cells: FEW_REFERENCES, references: FEW_REFERENCES }
    }

    /// Halves the finest axis until the cells and the references of primitives that reach so far have room, or
    /// there is one cell. Returns how many cells the primitives' boxes touch, all together.
    pub(super) fn fit(
        &self,
        lattice: &mut Lattice,
        reaches: &[Aabb],
        watch: &impl Observer<Grow>,
    ) -> Result<u64, Cancelled> {
        // Each primitive touches a cell: where there is no room for that, nothing is counted.
        if reaches.len() as u64 > self.references {
            lattice.resolution = [1; 3];
        }
        loop {
            let cells: u64 = lattice.resolution.iter().map(|&n| u64::from(n)).product();
            let most = if cells > self.cells { 0 } else { self.references };
            let touched = lattice.touched(reaches, most, watch)?;
            let finest = lattice.resolution.iter_mut().max().expect("a grid has three axes");
            if *finest == 1 || (cells <= self.cells && touched <= self.references) {
                return Ok(touched);
            }
            *finest = finest.div_ceil(2);
        }
    }

    /// Gives room to a grid whose primitives touch so many cells; `false` if there is none to divide anything.
    pub(super) fn give(&mut self, lattice: &Lattice, touched: u64) -> bool {
        let cells = lattice.cell_count() as u64;
        let fits = (2..=self.cells).contains(&cells) && touched <= self.references;
        if fits {
            self.cells -= cells;
            self.references -= touched;
        }
        fits
    }
}

impl Lattice {
    /// How many cells the boxes touch, all together; where there are more than `most`, it stops counting.
    fn touched(&self, reaches: &[Aabb], most: u64, watch: &impl Observer<Grow>) -> Result<u64, Cancelled> {
        if self.resolution == [1; 3] {
            return Ok(reaches.len() as u64);
        }
        let mut touched = 0;
        for reach in patiently(reaches, watch) {
            let along = self.rasterise(reach?).map(|range| u64::from(range.end() - range.start() + 1));
            touched += along.iter().product::<u64>();
            if touched > most {
                break;
            }
        }
        Ok(touched)
    }
}
