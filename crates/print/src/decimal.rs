//! Coordinates as they stand in a file: two decimals, no idle zeros, no negative zero.

/// A rounded number.
pub(crate) fn decimal(x: f32) -> String {
    // Nothing sensible lies that far out, and a file with "inf" in it opens nowhere.
    let x = if x.is_finite() { x.clamp(-1e6, 1e6) } else { 0.0 };
    let text = format!("{x:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::decimal;

    #[test]
    fn two_decimals_are_kept() {
        for (x, text) in [(1.0, "1"), (0.256, "0.26"), (-0.001, "0"), (-3.5, "-3.5"), (f32::NAN, "0"), (100.0, "100")] {
            assert_eq!(decimal(x), text);
        }
    }
}
