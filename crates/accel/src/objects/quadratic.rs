//! The equation behind everything round (Press et al., "Numerical Recipes", section 5.6).

use super::{Part, Probe};
use crate::Observer;

/// The solutions `t1 ≤ t2` of `a·t² + 2·b·t + c = 0`. The caller knows a better way to the discriminant
/// than `b² − a·c`, in which rounding would cancel.
#[inline]
pub(super) fn solve(
    of: Part,
    [a, b, c]: [f64; 3],
    discriminant: f64,
    watch: &mut impl Observer<Probe>,
) -> Option<[f64; 2]> {
    let real = discriminant >= 0.0;
    let mut t = [f64::NAN; 2];
    if real {
        // The root that adds, so that nothing cancels; the other follows from their product.
        let q = -(b + discriminant.sqrt().copysign(b));
        let (t1, t2) = (q / a, if q == 0.0 { 0.0 } else { c / q });
        t = if t1 <= t2 { [t1, t2] } else { [t2, t1] };
    }
    let [t1, t2] = t.map(|t| t as f32);
    let (fa, fb, fc) = (a as f32, b as f32, c as f32);
    watch.on(Probe::Quadratic { of, a: fa, b: fb, c: fc, discriminant: discriminant as f32, t1, t2, real });
    real.then_some(t)
}
