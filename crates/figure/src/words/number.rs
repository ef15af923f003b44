//! The one formatter of numbers: three significant digits, everywhere.

use std::borrow::Cow;

use raystep_accel::{Lanes, Value};

/// What stands before a number that few rays have told: nobody should quote it.
pub const ROUGH: &str = "\u{2248}";

/// A number as it stands on every page: three significant digits, whole from 1000 on, no idle zeros, and from 10,000 on
/// with commas between the thousands.
pub fn number(x: f32) -> String {
    digits(x, 3)
}

/// The same with so many significant digits, where a sum takes more of them.
pub(crate) fn digits(x: f32, count: usize) -> String {
    if x.is_nan() {
        return "NaN".to_owned();
    }
    if x.is_infinite() {
        return if x > 0.0 { "∞".to_owned() } else { "−∞".to_owned() };
    }
    let size = f64::from(x).abs();
    let digits = if size == 0.0 {
        "0".to_owned()
    } else if !(9.995e-5..999_999.5).contains(&size) {
        scientific(size)
    } else {
        // Digits after the point so that three count: 5.14, 0.328, 0.00123.
        let (_, exponent) = parts(size);
        let digits = trimmed(&format!("{:.*}", (count as i32 - 1 - exponent).max(0) as usize, size));
        if digits.contains('.') { digits } else { grouped(digits) }
    };
    if x < 0.0 { format!("−{digits}") } else { digits }
}

/// A count as it stands on every page: 9999, and 10,000 from there on.
pub fn whole(n: u64) -> String {
    grouped(n.to_string())
}

/// With commas between the thousands where there are five digits or more.
fn grouped(digits: String) -> String {
    if digits.len() < 5 {
        return digits;
    }
    let comma = |(index, digit): (usize, char)| {
        let before = (index > 0 && (digits.len() - index).is_multiple_of(3)).then_some(',');
        before.into_iter().chain([digit])
    };
    digits.chars().enumerate().flat_map(comma).collect()
}

/// The value of a field of an event, in words where it is not a number.
pub fn value(value: &Value) -> String {
    match *value {
        Value::Number(x) => number(x),
        Value::Count(n) => whole(n.into()),
        Value::Flag(true) => "yes".to_owned(),
        Value::Flag(false) => "no".to_owned(),
        Value::Axis(axis) => axis.name().to_owned(),
        // Why a walk ends, as one would say it.
        Value::Word("exhausted", _) => "nothing is left".to_owned(),
        Value::Word(word, _) => word.to_owned(),
        Value::Place(place) => place.to_string(),
        Value::Lanes(lanes) => mask(lanes),
        Value::Box(bounds) => bounds.extent().to_array().map(number).join(" × "),
    }
}

/// Which rays of a packet take part, a square each: `■■□■` are all of four but the third.
pub(crate) fn mask(lanes: Lanes) -> String {
    (0..lanes.width()).map(|lane| if lanes.has(lane) { '■' } else { '□' }).collect()
}

/// A count with its noun: `1 node`, `2 nodes`.
pub fn counted(count: u64, one: &str, many: &str) -> String {
    format!("{} {}", whole(count), if count == 1 { one } else { many })
}

/// A noun behind a count, as one and as many of it: `leaf|leaves` says both, of another one the plural is regular.
pub(crate) fn one_or_many(one: bool, noun: &str) -> Cow<'_, str> {
    match noun.split_once('|') {
        Some((single, many)) => Cow::Borrowed(if one { single } else { many }),
        None if one => Cow::Borrowed(noun),
        None if noun.ends_with(['s', 'x']) || noun.ends_with("ch") || noun.ends_with("sh") => {
            Cow::Owned(format!("{noun}es"))
        }
        None => Cow::Owned(format!("{noun}s")),
    }
}

/// Mantissa with three digits and exponent, rounded as they are printed.
fn parts(size: f64) -> (String, i32) {
    let printed = format!("{size:.2e}");
    let (mantissa, exponent) = printed.split_once('e').unwrap_or((&printed, "0"));
    (trimmed(mantissa), exponent.parse().unwrap_or(0))
}

fn scientific(size: f64) -> String {
    const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let (mantissa, exponent) = parts(size);
    let sign = if exponent < 0 { "⁻" } else { "" };
    let digits = exponent.unsigned_abs().to_string();
    let raised: String = digits.bytes().map(|digit| RAISED[usize::from(digit - b'0')]).collect();
    format!("{mantissa}·10{sign}{raised}")
}

fn trimmed(digits: &str) -> String {
    if digits.contains('.') { digits.trim_end_matches('0').trim_end_matches('.').to_owned() } else { digits.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thousands_are_set_apart_from_five_digits_on() {
        let table = [(0, "0"), (999, "999"), (9999, "9999"), (10_000, "10,000"), (123_456_789, "123,456,789")];
        for (n, text) in table {
            assert_eq!(whole(n), text);
        }
    }

    #[test]
    fn three_digits_count() {
        let table = [
            (3.6612, "3.66"),
            (0.3278, "0.328"),
            (0.53, "0.53"),
            (5.0, "5"),
            (-2.0, "−2"),
            (-0.0, "0"),
            (9.996, "10"),
            (99.96, "100"),
            (999.7, "1000"),
            (9999.4, "9999"),
            (12_345.6, "12,346"),
            (599_048.0, "599,048"),
            (1.5e7, "1.5·10⁷"),
            (0.000_123_4, "0.000123"),
            (0.000_012_34, "1.23·10⁻⁵"),
            (f32::INFINITY, "∞"),
            (f32::NEG_INFINITY, "−∞"),
            (f32::NAN, "NaN"),
        ];
        for (x, text) in table {
            assert_eq!(number(x), text);
        }
    }

    #[test]
    fn rays_that_take_part_are_filled_squares() {
        assert_eq!(value(&Value::Lanes(Lanes::of(4, |lane| lane != 2))), "■■□■");
        assert_eq!(value(&Value::Lanes(Lanes::none(8))), "□□□□□□□□");
    }
}
