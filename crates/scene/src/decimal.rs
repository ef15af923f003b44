//! Numbers as text.

/// The number that `word` spells, in double precision. Rounded to single precision it is the number that reading
/// `word` in single precision gives, so that a mesh and a ray that name the same point meet.
pub fn decimal(word: &str) -> Option<f64> {
    let number: f64 = word.parse().ok()?;
    let single: f32 = word.parse().ok()?;
    // Rounding twice may make a tie of what was none: a step towards the right side of it.
    let twice = number as f32;
    Some(if single > twice {
        number.next_up()
    } else if single < twice {
        number.next_down()
    } else {
        number
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounds_to_what_single_precision_reads() {
        for word in ["0.1", "-1e18", "1e-46", "inf", "5247903.25", "5247903.25000000000001", "5247903.24999999999999"] {
            assert_eq!(decimal(word).unwrap() as f32, word.parse::<f32>().unwrap(), "{word}");
        }
        assert_eq!(decimal("5247903.21"), Some(5247903.21));
        assert!(decimal("nan").unwrap().is_nan());
        assert_eq!((decimal("-1.#IND00"), decimal("1,5"), decimal("")), (None, None, None));
    }
}
