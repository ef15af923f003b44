//! An axis: where a number lies on the page, and which round numbers stand on it.

/// A straight axis from `low` at `left` to `high` at `right`, in points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ticks {
    pub(crate) low: f32,
    pub(crate) high: f32,
    pub(crate) left: f32,
    pub(crate) right: f32,
}

impl Ticks {
    /// Where `value` lies on the page; NaN lies at the lower end, what is out of range at the nearer one.
    pub(crate) fn x(&self, value: f32) -> f32 {
        let part = (value - self.low) / (self.high - self.low);
        // Not clamp: NaN must end somewhere.
        let part = if part > 0.0 { part.min(1.0) } else { 0.0 };
        self.left + part * (self.right - self.left)
    }

    /// Whether the axis shows `value`.
    pub(crate) fn shows(&self, value: f32) -> bool {
        self.low <= value && value <= self.high
    }

    /// The round numbers on the axis, at least `apart` points from each other.
    pub(crate) fn marks(&self, apart: f32) -> Vec<f32> {
        let most = ((self.right - self.left) / apart).max(1.0);
        let (low, high) = (f64::from(self.low), f64::from(self.high));
        let step = round_step((high - low) / f64::from(most));
        let (first, last) = ((low / step).ceil(), (high / step).floor());
        if !(last - first).is_finite() || last - first > 1000.0 {
            return Vec::new();
        }
        (0..=(last - first) as i32).map(|i| ((first + f64::from(i)) * step) as f32).collect()
    }
}

/// The smallest of 1, 2 and 5 times a power of ten that is at least `least`.
fn round_step(least: f64) -> f64 {
    let least = if least.is_finite() && least > 0.0 { least } else { 1.0 };
    // Powers of ten from the exponent in steps, not from the mathematics library: the same everywhere.
    let (mut power, mut exponent) = (1.0_f64, 0);
    while power > least && exponent > -60 {
        exponent -= 1;
        power = ten_to(exponent);
    }
    while power * 10.0 <= least {
        exponent += 1;
        power = ten_to(exponent);
    }
    let factor = [1.0, 2.0, 5.0, 10.0].into_iter().find(|factor| factor * power >= least).unwrap_or(10.0);
    factor * power
}

fn ten_to(exponent: i32) -> f64 {
    let power = (0..exponent.unsigned_abs()).fold(1.0, |power, _| power * 10.0);
    if exponent < 0 { 1.0 / power } else { power }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(low: f32, high: f32, expected: &[f32]) {
        let axis = Ticks { low, high, left: 0.0, right: 500.0 };
        assert_eq!(axis.marks(50.0), expected, "{low}..{high}");
    }

    #[test]
    fn ticks_are_round_numbers() {
        check(0.0, 9.0, &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0]);
        check(-5.0, -2.0, &[-5.0, -4.5, -4.0, -3.5, -3.0, -2.5, -2.0]);
        check(0.0, 0.013, &[0.0, 0.002, 0.004, 0.006, 0.008, 0.01, 0.012]);
        check(0.0, 1e6, &[0.0, 1e5, 2e5, 3e5, 4e5, 5e5, 6e5, 7e5, 8e5, 9e5, 1e6]);
    }

    #[test]
    fn a_hopeless_axis_has_no_ticks_and_still_places_everything() {
        let axis = Ticks { low: 0.0, high: f32::INFINITY, left: 0.0, right: 500.0 };
        assert!(axis.marks(50.0).is_empty());
        for value in [f32::NAN, f32::INFINITY, -1e30, 3.0] {
            assert!((0.0..=500.0).contains(&axis.x(value)));
        }
    }
}
