//! Four triangles in three cache lines.

use bytemuck::{Pod, Zeroable};
use glam::Vec3;
use raystep_accel::{Mesh, PrimId, Triangle};

/// Up to four triangles. Where there are fewer, the last one stands in the lanes that are left: tested twice, it gives
/// the same answer twice.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C, align(64))]
pub(crate) struct Four {
    /// For each axis the coordinates of the first corners, the second and the third; a lane for each triangle. Behind
    /// them, so that an axis can be looked up without a branch, the rest: sizes and ids.
    pub(crate) rows: [[[f32; 4]; 3]; 4],
}

/// The row behind those of the axes, and what stands there.
const REST: usize = 3;
const SIZES: usize = 0;
const IDS: usize = 1;
const COUNT: usize = 2;

impl Four {
    /// How many lanes there are.
    pub(crate) const LANES: usize = 4;

    /// One to four triangles of a mesh.
    pub(crate) fn of(mesh: &Mesh, prims: &[u32]) -> Four {
        let mut four = Four::zeroed();
        for lane in 0..Four::LANES {
            let prim = prims[lane.min(prims.len() - 1)];
            let Triangle { a, b, c } = mesh.triangle(PrimId(prim));
            for (axis, row) in four.rows.iter_mut().enumerate().take(3) {
                for (corner, point) in [a, b, c].into_iter().enumerate() {
                    row[corner][lane] = point[axis];
                }
            }
            // Its longest side, rounded up.
            let size = (a.max(b).max(c) - a.min(b).min(c)).max_element();
            four.rows[REST][SIZES][lane] = size.next_up();
            four.rows[REST][IDS][lane] = f32::from_bits(prim);
        }
        four.rows[REST][COUNT][0] = f32::from_bits(prims.len() as u32);
        four
    }

    /// How many different triangles there are.
    #[inline(always)]
    pub(crate) fn count(&self) -> u32 {
        self.rows[REST][COUNT][0].to_bits()
    }

    /// The longest sides of their boxes.
    #[inline(always)]
    pub(crate) fn sizes(&self) -> &[f32; 4] {
        &self.rows[REST][SIZES]
    }

    /// The number of the triangle in a lane.
    #[inline(always)]
    pub(crate) fn prim(&self, lane: usize) -> u32 {
        self.rows[REST][IDS][lane & 3].to_bits()
    }

    /// The triangle in a lane.
    #[inline(always)]
    pub(crate) fn triangle(&self, lane: usize) -> Triangle {
        let [x, y, z, _] = &self.rows;
        let [a, b, c] = [0, 1, 2].map(|i| Vec3::new(x[i][lane & 3], y[i][lane & 3], z[i][lane & 3]));
        Triangle { a, b, c }
    }
}
