//! A span of steps, as it is written on the command line.

use std::ops::RangeInclusive;

/// `3..9` or `5`: the first and the last step.
pub(crate) fn span(text: &str) -> Result<RangeInclusive<usize>, String> {
    let number = |text: &str| text.trim().parse::<usize>().ok();
    let range = match text.split_once("..") {
        Some((first, last)) => number(first).zip(number(last.trim_start_matches('='))),
        None => number(text).map(|only| (only, only)),
    };
    let (first, last) = range.ok_or("write the first and the last step, as in 3..9, or one step")?;
    if first > last {
        return Err(format!("step {first} comes after step {last}: write the smaller one first"));
    }
    Ok(first..=last)
}
