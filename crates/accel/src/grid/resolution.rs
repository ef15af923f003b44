//! How many cells, slide 17.

use super::Grid;
use crate::{Aabb, Axes, Axis, GridRule, Resolution};

/// No grid has more cells than this.
const MOST_CELLS: u64 = 1 << 24;
/// No grid has more references than this.
const MOST_REFERENCES: u64 = 1 << 24;

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

impl Grid {
    /// Halves the finest axis until the grid fits into memory, its references included.
    pub(super) fn coarsen(&mut self, reaches: &[Aabb]) {
        loop {
            let cells: u64 = self.resolution.iter().map(|&n| u64::from(n)).product();
            if cells <= MOST_CELLS && self.candidates(reaches) <= MOST_REFERENCES.max(reaches.len() as u64) {
                return;
            }
            let finest = self.resolution.iter_mut().max().expect("a grid has three axes");
            if *finest == 1 {
                return;
            }
            *finest = finest.div_ceil(2);
        }
    }

    /// How many cells the boxes touch, all together.
    fn candidates(&self, reaches: &[Aabb]) -> u64 {
        let touched = |reach: &Aabb| -> u64 {
            self.rasterise(reach).map(|range| u64::from(range.end() - range.start() + 1)).iter().product()
        };
        reaches.iter().map(touched).fold(0, u64::saturating_add)
    }
}
