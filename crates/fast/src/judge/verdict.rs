//! The judge's last words about one triangle.

use raystep_accel::{Interval, Place, Ray, Shape, Triangle, slab};

use super::Nearest;

/// The part of its t by which a meeting may lie outside its triangle's own box: as `accel` has it.
const SLACK: f32 = 8.0 * f32::EPSILON;

/// The ray's line meets the triangle at `met`: moves that into the interval of the triangle's own box, and keeps it if
/// it counts and is better. The same comparisons as `Shape::intersect` makes; only what can be no better is left earlier.
#[inline(always)]
pub(crate) fn accept(triangle: &Triangle, prim: u32, met: f32, ray: &Ray, best: &mut Nearest) {
    if met - met.abs() * (2.0 * SLACK) > best.t {
        return;
    }
    let own = slab(&triangle.bounds(), ray, Interval::ALL, Place::World, &mut ());
    if own.is_empty() {
        return;
    }
    let t = own.clamp(met);
    if (t - met).abs() <= SLACK * met.abs() && met.is_finite() && ray.range().contains(t) {
        best.offer(t, prim);
    }
}

/// The textbook's own test, for rays that are not ordinary.
pub(crate) fn careful(triangle: Triangle, prim: u32, ray: &Ray, best: &mut Nearest) {
    if let Some(t) = Shape::Triangle(triangle).intersect(ray) {
        best.offer(t, prim);
    }
}
