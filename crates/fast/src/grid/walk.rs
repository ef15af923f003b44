//! The walk, from cell to cell (Amanatides and Woo 1987).

use raystep_accel::{Axis, Hit, Lattice, Place, Ray, Want, slab};

use crate::judge::{Count, Nearest, NotOrdinary, Shot};
use crate::lanes::stamped;
use crate::leaf::Four;

/// The cell along an axis in which a place lies; the first or the last if it lies outside.
#[inline(always)]
fn locate(lattice: &Lattice, axis: Axis, place: f32) -> u32 {
    let (low, high, n) = (lattice.bounds.min[axis], lattice.bounds.max[axis], lattice.resolution[axis.index()]);
    // A quotient that is not a number (no cell has a width) becomes 0.
    (((place - low) / (high - low) * n as f32) as u32).min(n - 1)
}

macro_rules! walk {
    ($(#[$features:meta])* $isa:ident) => {
        use super::*;
        use crate::leaf::$isa as leaf;

        /// Walks an ordinary ray.
        $(#[$features])*
        pub(in crate::grid) fn walk(
            lattice: &Lattice,
            starts: &[u32],
            cells: &[Four],
            ray: &Ray,
            reach: f32,
            want: Want,
            count: &mut impl Count,
        ) -> Result<Option<Hit>, NotOrdinary> {
            let shot = &Shot::new(ray, reach)?;
            let mut best = Nearest::before(ray.t_max);
            if lattice.bounds.is_empty() {
                return Ok(None);
            }
            let live = slab(&lattice.bounds, ray, ray.range(), Place::World, &mut ());
            if live.is_empty() {
                return Ok(None);
            }
            let [nx, ny, _] = lattice.resolution.map(|n| n as usize);
            let rows = [1, nx, nx * ny];
            // Along each axis: the t of the next plane, the t between planes, the cells still to come, and how far the next
            // one lies in the list of cells.
            let (mut next, mut delta) = ([f32::INFINITY; 3], [0.0f32; 3]);
            let (mut left, mut stride) = ([0u32; 3], [0isize; 3]);
            let mut cell = 0usize;
            for axis in Axis::ALL {
                let (i, n) = (axis.index(), lattice.resolution[axis.index()]);
                let place = locate(lattice, axis, ray.o[axis] + live.near * ray.d[axis]);
                cell += rows[i] * place as usize;
                let width = (lattice.bounds.max[axis] - lattice.bounds.min[axis]) / n as f32;
                // One that runs so slowly along an axis that it counts as faster never leaves its cells there.
                if 1.0 / ray.d[axis].abs() == shot.r[i].abs() {
                    let plane = lattice.plane(axis, place + u32::from(!shot.down[i]));
                    next[i] = (plane - ray.o[axis]) * shot.r[i];
                }
                delta[i] = width * shot.r[i].abs();
                (left[i], stride[i]) =
                    if shot.down[i] { (place, -(rows[i] as isize)) } else { (n - 1 - place, rows[i] as isize) };
            }
            let first = next;
            let mut steps = [0.0f32; 3];
            loop {
                count.node(1);
                for four in &cells[starts[cell] as usize..starts[cell + 1] as usize] {
                    leaf::meet(four, shot, &mut best, count);
                }
                if want == Want::Any && best.is_some() {
                    break;
                }
                // On over the face that comes first, unless the best hit lies before it.
                let [x, y, z] = next;
                let axis = if x <= y && x <= z {
                    0
                } else if y <= z {
                    1
                } else {
                    2
                };
                let t = next[axis];
                if left[axis] == 0 || best.t < t || t > live.far || t == f32::INFINITY {
                    break;
                }
                left[axis] -= 1;
                cell = cell.wrapping_add_signed(stride[axis]);
                // From the first plane, so that no error piles up on the way.
                steps[axis] += 1.0;
                next[axis] = steps[axis] * delta[axis] + first[axis];
            }
            Ok(best.hit())
        }
    };
}

stamped!(walk);
