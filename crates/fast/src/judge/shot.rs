//! A ray, made ready for lanes.

use raystep_accel::Ray;

use super::BOX;

/// A ray with what every box and every triangle needs of it, computed once.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Shot<'a> {
    pub(crate) ray: &'a Ray,
    /// One over each component of the direction.
    pub(crate) r: [f32; 3],
    /// What is added to b·r where the ray enters a slab, and where it leaves it.
    pub(crate) enter: [f32; 3],
    pub(crate) leave: [f32; 3],
    /// Whether the ray runs down each axis.
    pub(crate) down: [bool; 3],
    /// The axes, the one with the largest component last.
    pub(crate) axes: [usize; 3],
    /// The origin along these axes.
    pub(crate) o: [f32; 3],
    /// How far the ray runs along the first two of these axes while it runs one along the last.
    pub(crate) shear: [f32; 2],
}

/// What lanes can bear: coordinates and directions.
const ORDINARY: std::ops::RangeInclusive<f32> = 1.0 / POWER_40..=POWER_40;
const STRAIGHT: std::ops::RangeInclusive<f32> = 1.0 / POWER_30..=POWER_30;
const POWER_30: f32 = (1u64 << 30) as f32;
const POWER_40: f32 = (1u64 << 40) as f32;

impl<'a> Shot<'a> {
    /// The ray for a scene whose coordinates are at most `reach`; nothing if it is not an ordinary one, and has to be
    /// walked carefully.
    #[inline(always)]
    pub(crate) fn new(ray: &'a Ray, reach: f32) -> Option<Shot<'a>> {
        let (o, d) = (ray.o.to_array(), ray.d.to_array());
        let [x, y, z] = d.map(f32::abs);
        let largest = x.max(y).max(z);
        let reach = o.map(f32::abs).into_iter().fold(reach, f32::max);
        if !(ORDINARY.contains(&reach) && STRAIGHT.contains(&largest)) {
            return None;
        }
        // The same order as the judge's: the first of equals.
        let axes = if x >= y && x >= z {
            [1, 2, 0]
        } else if y >= z {
            [2, 0, 1]
        } else {
            [0, 1, 2]
        };
        let least = largest * (1.0 / POWER_30);
        let r = d.map(|d| 1.0 / d.abs().max(least).copysign(d));
        let [ex, ey, ez] = r.map(|r| BOX * reach * r.abs());
        let [nx, ny, nz] = [o[0] * r[0], o[1] * r[1], o[2] * r[2]];
        let [i, j, k] = axes;
        Some(Shot {
            ray,
            r,
            enter: [-nx - ex, -ny - ey, -nz - ez],
            leave: [-nx + ex, -ny + ey, -nz + ez],
            down: d.map(f32::is_sign_negative),
            axes,
            o: [o[i], o[j], o[k]],
            shear: [d[i] * r[k], d[j] * r[k]],
        })
    }
}
