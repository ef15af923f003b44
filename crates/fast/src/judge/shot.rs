//! A ray, made ready for lanes.

use glam::Vec4;
use raystep_accel::Ray;

use super::BOX;

/// A ray with what every box and every triangle needs of it, computed once.
#[derive(Clone, Copy, Debug)]
pub struct Shot<'a> {
    /// The ray itself.
    pub ray: &'a Ray,
    /// One over each component of the direction; a component of less than 2⁻³⁰ of the largest counts as that much.
    pub r: [f32; 3],
    /// What is added to b·r where the ray enters a slab.
    pub enter: [f32; 3],
    /// What is added to it where the ray leaves a slab.
    pub leave: [f32; 3],
    /// Whether the ray runs down each axis.
    pub down: [bool; 3],
    /// Whether no component of the direction counts as more than it is.
    pub steep: bool,
    /// The axes, the one with the largest component last.
    pub axes: [usize; 3],
    /// The origin along these axes.
    pub o: [f32; 3],
    /// One over the direction along these axes.
    pub sorted_r: [f32; 3],
    /// How far the ray runs along the last of these axes while t grows by one, and which way: 1 or −1.
    pub pace: f32,
    /// See `pace`.
    pub way: f32,
    /// How far the ray runs along the first two of these axes while it runs one along the last.
    pub shear: [f32; 2],
}

/// The proofs do not hold for this ray: it has to be walked carefully.
#[derive(Clone, Copy, Debug)]
pub struct NotOrdinary;

/// What lanes can bear: coordinates and directions.
pub(crate) const ORDINARY: std::ops::RangeInclusive<f32> = 1.0 / POWER_40..=POWER_40;
pub(crate) const STRAIGHT: std::ops::RangeInclusive<f32> = 1.0 / POWER_30..=POWER_30;
pub(crate) const POWER_30: f32 = (1u64 << 30) as f32;
const POWER_40: f32 = (1u64 << 40) as f32;

/// For each axis the two that follow it, and it.
static AXES: [[usize; 3]; 3] = [[1, 2, 0], [2, 0, 1], [0, 1, 2]];

impl<'a> Shot<'a> {
    /// The ray for a scene whose coordinates are at most `reach`.
    ///
    /// # Errors
    /// It is not an ordinary ray.
    #[inline(always)]
    pub(crate) fn new(ray: &'a Ray, reach: f32) -> Result<Shot<'a>, NotOrdinary> {
        Shot::with_margin(ray, reach, BOX)
    }

    /// The same where boxes are moved out by another part of S·|r|: for lanes that round otherwise.
    ///
    /// # Errors
    /// It is not an ordinary ray.
    #[inline(always)]
    pub fn with_margin(ray: &'a Ray, reach: f32, margin: f32) -> Result<Shot<'a>, NotOrdinary> {
        let (o, d) = (ray.o.extend(0.0), ray.d.extend(0.0));
        let size = d.abs();
        let largest = greater(greater(size.x, size.y), size.z);
        let far = o.abs();
        let reach = greater(greater(far.x, far.y), greater(far.z, reach));
        if !(ORDINARY.contains(&reach) && STRAIGHT.contains(&largest)) {
            return Err(NotOrdinary);
        }
        let least = largest * (1.0 / POWER_30);
        let r = Vec4::ONE / size.max(Vec4::splat(least)).copysign(d);
        let margin = r.abs() * (margin * reach);
        let start = -(o * r);
        // The same order as the judge's: the first of equals.
        let last = if size.y > size.x { 1 } else { 0 };
        let last = if size.z > greater(size.x, size.y) { 2 } else { last };
        let axes @ [i, j, k] = AXES[last];
        let (o, d, r) = (ray.o.to_array(), ray.d.to_array(), r.truncate().to_array());
        Ok(Shot {
            ray,
            r,
            enter: (start - margin).truncate().to_array(),
            leave: (start + margin).truncate().to_array(),
            down: d.map(f32::is_sign_negative),
            steep: size.x >= least && size.y >= least && size.z >= least,
            axes,
            o: [o[i], o[j], o[k]],
            sorted_r: [r[i], r[j], r[k]],
            pace: largest,
            way: 1f32.copysign(d[k]),
            shear: [d[i] * r[k], d[j] * r[k]],
        })
    }
}

/// The greater of two numbers, of which none is NaN: one instruction.
#[inline(always)]
fn greater(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}
