//! The uniform grid, slides 16-21: space in equal cells, each referring to the primitives that reach into it.

mod build;
mod resolution;
mod walk;

pub(crate) use walk::Crossing;

use std::ops::RangeInclusive;

use glam::Vec3;

use crate::{Aabb, Axis, CellId, Margin, PrimId};

/// A box in equal cells. The references of all cells lie in one array, one cell after the other.
#[derive(Clone, Debug, PartialEq)]
pub struct Grid {
    /// The box around all primitives; empty if there are none.
    pub bounds: Aabb,
    /// The number of cells along x, y and z.
    pub resolution: [u32; 3],
    /// Where each cell's references begin in `refs`, and at last where they all end.
    starts: Vec<u32>,
    refs: Vec<PrimId>,
    margin: Margin,
    /// Whether a ray remembers which primitives it tested.
    pub(crate) mailbox: bool,
}

impl Grid {
    /// The number of cells.
    pub fn cell_count(&self) -> usize {
        self.starts.len() - 1
    }

    /// The number of references from cells to primitives.
    pub fn reference_count(&self) -> usize {
        self.refs.len()
    }

    /// The primitives that a cell refers to.
    #[inline]
    pub fn cell_prims(&self, cell: CellId) -> &[PrimId] {
        &self.refs[self.starts[cell.index()] as usize..self.starts[cell.index() + 1] as usize]
    }

    /// The cell at a place counted in cells.
    #[inline]
    pub fn cell_at(&self, x: u32, y: u32, z: u32) -> CellId {
        let [nx, ny, _] = self.resolution;
        CellId(x + nx * (y + ny * z))
    }

    /// A cell's place, counted in cells.
    pub fn cell_place(&self, cell: CellId) -> [u32; 3] {
        let [nx, ny, _] = self.resolution;
        [cell.0 % nx, cell.0 / nx % ny, cell.0 / nx / ny]
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
    pub(crate) fn locate(&self, axis: Axis, p: f32) -> u32 {
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

    /// The cells along each axis that `reach` touches.
    fn rasterise(&self, reach: &Aabb) -> [RangeInclusive<u32>; 3] {
        Axis::ALL.map(|axis| self.locate(axis, reach.min[axis])..=self.locate(axis, reach.max[axis]))
    }

    /// How much memory it takes.
    pub fn bytes(&self) -> usize {
        size_of::<Grid>() + size_of_val(&*self.starts) + size_of_val(&*self.refs)
    }
}
