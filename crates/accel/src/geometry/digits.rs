//! Where single precision runs out of digits: lengths that overflow when they are squared, numbers so small that
//! they are rounded to steps.

use glam::{DVec3, Vec3};

use super::Measure;

/// 64 of the steps in which the smallest numbers lie: more than sums, products and quotients of such numbers lose.
pub(crate) const STEPS: f32 = f32::from_bits(64);

/// Whether the square of a length keeps its digits in single precision.
#[inline]
fn is_square(squared: f32) -> bool {
    (1e-30..=1e38).contains(&squared)
}

/// The length of a vector, also if the squares of its components are no numbers of single precision.
#[inline]
pub(crate) fn length(v: Vec3) -> f32 {
    let squared = v.length_squared();
    if is_square(squared) { squared.sqrt() } else { (v.as_dvec3().length() as f32).min(f32::MAX) }
}

/// Of length one along `v`, however long that is; nothing of zero.
pub(crate) fn direction(v: Vec3) -> Option<Vec3> {
    if is_square(v.length_squared()) { v.try_normalize() } else { v.as_dvec3().try_normalize().map(DVec3::as_vec3) }
}

/// Whole powers of two by which sides are multiplied so that their products are numbers, and relations stay as they
/// are to the bit: 1 for all that are neither tiny nor huge.
pub(crate) fn unit(longest: f32) -> f32 {
    if (1e-12..=1e12).contains(&longest) || longest == 0.0 {
        return 1.0;
    }
    // One over the power of two below it: the exponents of the two sum to that of 1, twice.
    let exponent = (longest.to_bits() >> 23).clamp(1, 253);
    f32::from_bits((254 - exponent) << 23)
}

/// The size of a box whose sides were multiplied by a unit before they were measured, without that unit: to the bit
/// what measuring the sides themselves gives, where that is a number with all its digits.
#[inline]
pub(crate) fn in_world(size: f32, measure: Measure, unit: f32) -> f32 {
    match measure {
        Measure::Area => size / unit / unit,
        Measure::Perimeter => size / unit,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_and_units_are_found_at_both_ends_of_the_numbers() {
        for (v, expected) in [(3.0, 3.0), (1e-42, 1e-42), (1e-23, 1e-23), (1e30, 1e30), (3e38, f32::MAX)] {
            let length = length(Vec3::new(v, -v, 0.0));
            let exact = (f64::from(expected) * std::f64::consts::SQRT_2).min(f32::MAX.into());
            assert!((f64::from(length) - exact).abs() <= exact * 1e-6 + f64::from(STEPS), "{v}: {length}");
            let along = direction(Vec3::new(v, 0.0, -v)).unwrap();
            assert!((along - Vec3::new(0.5_f32.sqrt(), 0.0, -(0.5_f32.sqrt()))).length() < 1e-6, "{v}: {along}");
        }
        assert_eq!(direction(Vec3::ZERO), None);
        for longest in [0.0, 1e-12, 1.0, 1e12] {
            assert_eq!(unit(longest), 1.0);
        }
        for longest in [1e-45, 1e-38, 1e-13, 1.5e13, 1e18, 3e38] {
            let scaled = longest * unit(longest);
            assert!((1e-7..4.0).contains(&scaled), "{longest}: {scaled}");
            assert_eq!(scaled / unit(longest), longest);
        }
    }
}
