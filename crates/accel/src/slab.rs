//! The slab test of slide 13: a box is the common part of three slabs.

use crate::{Aabb, Axis, Direction, Interval, Observer, Place, Ray, Visit};

/// More than the three roundings of `(b − o) / d` and of the product below can amount to.
const ROUNDING: f32 = 4.0 * f32::EPSILON;

/// The part of `within` for which the ray lies in `bounds`; empty if it misses. `bounds` must not be empty.
///
/// Slide 13, with two repairs. The deck hits if `t_min < t_max`, which loses every flat box: intervals
/// here are closed. And it divides by `d` whatever `d` is: a ray parallel to a slab gets a branch of its own.
///
/// `fl((b − o) / d)` is monotone in `b`, so a box inside another never gets the longer interval. That is
/// what lets every structure answer exactly as brute force does.
#[inline(always)]
pub fn slab(bounds: &Aabb, ray: &Ray, within: Interval, place: Place, watch: &mut impl Observer<Visit>) -> Interval {
    let mut live = within;
    for axis in Axis::ALL {
        let cut =
            Slab { across: axis.into(), o: ray.o[axis], d: ray.d[axis], low: bounds.min[axis], high: bounds.max[axis] };
        live = cut.narrow(live, place, watch);
    }
    live
}

/// One slab and the ray along its direction.
pub(crate) struct Slab {
    /// The direction across which its two planes stand.
    pub(crate) across: Direction,
    /// The ray's origin along that direction.
    pub(crate) o: f32,
    /// The ray's direction along that direction.
    pub(crate) d: f32,
    /// The lower plane.
    pub(crate) low: f32,
    /// The upper plane.
    pub(crate) high: f32,
}

impl Slab {
    /// What the slab leaves of `live`. Axis-aligned boxes, oriented ones and k-DOPs differ only in how many
    /// slabs they have, and which.
    #[inline(always)]
    pub(crate) fn narrow(&self, live: Interval, place: Place, watch: &mut impl Observer<Visit>) -> Interval {
        let Slab { across: axis, o, d, low, high } = *self;
        let Interval { near: mut t_near, far: mut t_far } = live;

        let (t1, t2) = if d == 0.0 {
            // Parallel to the slab: inside it for ever or never.
            let inside = low <= o && o <= high;
            watch.on(Visit::Parallel { place, axis, o, low, high, inside });
            if inside { (f32::NEG_INFINITY, f32::INFINITY) } else { (f32::INFINITY, f32::NEG_INFINITY) }
        } else {
            // Solve o + t·d = low and o + t·d = high.
            let (t1, t2) = ((low - o) / d, (high - o) / d);
            watch.on(Visit::Divide { place, axis, o, d, low, high, t1, t2 });
            // Order them: the entry comes first.
            let swapped = t1 > t2;
            let (t1, t2) = if swapped { (t2, t1) } else { (t1, t2) };
            watch.on(Visit::Order { place, axis, t1, t2, swapped });
            // Rounded outward, so that a ray exactly through an edge or a corner is not lost.
            (earlier(t1), later(t2))
        };

        // The latest entry and the earliest exit so far.
        if t1 > t_near {
            t_near = t1;
        }
        if t2 < t_far {
            t_far = t2;
        }
        watch.on(Visit::Narrow { place, axis, t1, t2, t_near, t_far, empty: t_near > t_far });
        Interval::new(t_near, t_far)
    }
}

/// `t` moved towards −∞ by the rounding it may carry. Monotone, and infinities stay.
#[inline]
pub(crate) fn earlier(t: f32) -> f32 {
    if t > 0.0 { t * (1.0 - ROUNDING) } else { t * (1.0 + ROUNDING) }
}

/// `t` moved towards +∞ by the rounding it may carry.
#[inline]
pub(crate) fn later(t: f32) -> f32 {
    -earlier(-t)
}
