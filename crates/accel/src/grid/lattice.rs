//! Equal cells: where their planes lie and how they are numbered, whatever they hold.

use std::ops::RangeInclusive;

use glam::Vec3;

use crate::{Aabb, Axis, CellId};

/// A box in equal cells.
#[derive(Clone, Debug, PartialEq)]
pub struct Lattice {
    /// The box; empty if there is nothing to hold.
    pub bounds: Aabb,
    /// The number of cells along x, y and z.
    pub resolution: [u32; 3],
    /// The id of the first cell: 0, but in grids within cells.
    pub first: CellId,
}

impl Lattice {
    /// The number of cells.
    pub fn cell_count(&self) -> usize {
        self.resolution.iter().map(|&n| n as usize).product()
    }

    /// The cell at a place counted in cells.
    #[inline]
    pub fn cell_at(&self, x: u32, y: u32, z: u32) -> CellId {
        let [nx, ny, _] = self.resolution;
        CellId(self.first.0 + x + nx * (y + ny * z))
    }

    /// A cell's place, counted in cells.
    pub fn cell_place(&self, cell: CellId) -> [u32; 3] {
        let [nx, ny, _] = self.resolution;
        let index = cell.0 - self.first.0;
        [index % nx, index / nx % ny, index / nx / ny]
    }

    /// A cell's box.
    pub fn cell_bounds(&self, cell: CellId) -> Aabb {
        let place = self.cell_place(cell);
        let corner = |up: u32| {
            let on = |axis: Axis| self.plane(axis, place[axis.index()] + up);
            Vec3::new(on(Axis::X), on(Axis::Y), on(Axis::Z))
        };
        Aabb::new(corner(0), corner(1))
    }

    /// The plane below cell `index` along `axis`: from the index, so that no error piles up on the way.
    #[inline]
    pub fn plane(&self, axis: Axis, index: u32) -> f32 {
        let (n, low, high) = (self.resolution[axis.index()], self.bounds.min[axis], self.bounds.max[axis]);
        if index == 0 {
            low
        } else if index == n {
            high
        } else {
            low + (high - low) * index as f32 / n as f32
        }
    }

    /// The cell along `axis` in which `p` lies; the first or the last if it lies outside.
    #[inline]
    pub(super) fn locate(&self, axis: Axis, p: f32) -> u32 {
        let n = self.resolution[axis.index()];
        let (low, high) = (self.bounds.min[axis], self.bounds.max[axis]);
        // A quotient that is not a number (no cell has a width) becomes 0.
        let mut index = ((p - low) / (high - low) * n as f32) as u32;
        index = index.min(n - 1);
        // The planes decide where rounding does not.
        while index > 0 && p < self.plane(axis, index) {
            index -= 1;
        }
        while index + 1 < n && p >= self.plane(axis, index + 1) {
            index += 1;
        }
        index
    }

    /// The cells that a box touches, row by row.
    pub(super) fn cells_of(&self, reach: &Aabb) -> impl Iterator<Item = CellId> {
        let [xs, ys, zs] = self.rasterise(reach);
        let rows = zs.flat_map(move |z| ys.clone().map(move |y| (y, z)));
        rows.flat_map(move |(y, z)| xs.clone().map(move |x| self.cell_at(x, y, z)))
    }

    /// The cells along each axis that `reach` touches.
    pub(super) fn rasterise(&self, reach: &Aabb) -> [RangeInclusive<u32>; 3] {
        Axis::ALL.map(|axis| self.locate(axis, reach.min[axis])..=self.locate(axis, reach.max[axis]))
    }
}
