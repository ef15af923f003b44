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
    // Without t in it the equation says of all t the same: along the side of a cone the line stays as far from it.
    let constant = a == 0.0 && b == 0.0;
    let real = if constant { c <= 0.0 } else { discriminant >= 0.0 };
    let mut t = [f64::NAN; 2];
    if real && constant {
        t = [f64::NEG_INFINITY, f64::INFINITY];
    } else if real {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_equation_without_t_holds_always_or_never() {
        let check = |[a, b, c]: [f64; 3], t| {
            assert_eq!(solve(Part::Surface, [a, b, c], b * b - a * c, &mut ()), t, "{a} {b} {c}");
        };
        check([0.0, 0.0, 1.0], None);
        check([0.0, 0.0, -1.0], Some([f64::NEG_INFINITY, f64::INFINITY]));
        check([0.0, 0.5, 1.0], Some([f64::NEG_INFINITY, -1.0]));
        check([0.0, -0.5, 1.0], Some([1.0, f64::INFINITY]));
        check([1.0, 0.0, -4.0], Some([-2.0, 2.0]));
        check([1.0, 0.0, 1.0], None);
    }
}
