//! Text with `{{field}}` in it.

use crate::Plays;
use crate::facts::check_fact;
use crate::reading::Reading;
use crate::vocabulary::check_field;

/// Checks every `{{field}}` of a piece of text that begins at byte `at`: closed, and a field of `event`.
pub(crate) fn check(text: &str, at: usize, event: &str, reading: &mut Reading<'_>) {
    for (field, found_at) in read(text, at, reading) {
        // What belongs to one answer: a plane to cut at, as it was weighed.
        match field.strip_prefix("own.").filter(|_| reading.plays == Plays::Build) {
            Some(own) => check_field("weigh", own, found_at, reading),
            None => check_field(event, field, found_at, reading),
        }
    }
}

/// Checks every `{{fact}}` of a piece of text that begins at byte `at` and is said once `event` has happened.
pub(crate) fn check_said(text: &str, at: usize, event: &str, reading: &mut Reading<'_>) {
    for (fact, found_at) in read(text, at, reading) {
        check_fact(event, fact, found_at, reading);
    }
}

/// What a text names between double braces, as far as they are closed.
pub(crate) fn named(text: &str) -> impl Iterator<Item = &str> {
    let pieces = text.split("{{").skip(1).filter_map(|piece| piece.split_once("}}"));
    pieces.map(|(inside, _)| name(inside))
}

/// The name in `{{ name noun }}`: a noun that follows it is counted.
fn name(inside: &str) -> &str {
    inside.trim().split(' ').next().unwrap_or_default()
}

/// Every name between double braces, with the byte where it stands; says so if one is not closed.
fn read<'a>(text: &'a str, at: usize, reading: &mut Reading<'_>) -> Vec<(&'a str, usize)> {
    let (mut found, mut from) = (Vec::new(), 0);
    while let Some(open) = text[from..].find("{{").map(|found| from + found) {
        let inside = open + 2;
        let Some(close) = text[inside..].find("}}").map(|found| inside + found) else {
            reading.problem(at + open, "`{{` is not closed by `}}` on its line");
            break;
        };
        let piece = &text[inside..close];
        found.push((name(piece), at + inside + piece.len() - piece.trim_start().len()));
        from = close + 2;
    }
    found
}
