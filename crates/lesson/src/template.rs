//! Text with `{{field}}` in it.

use crate::Plays;
use crate::reading::Reading;
use crate::vocabulary::check_field;

/// Checks every `{{field}}` of a piece of text that begins at byte `at`: closed, and a field of `event`.
pub(crate) fn check(text: &str, at: usize, event: &str, reading: &mut Reading<'_>) {
    let mut from = 0;
    while let Some(open) = text[from..].find("{{").map(|found| from + found) {
        let inside = open + 2;
        let Some(close) = text[inside..].find("}}").map(|found| inside + found) else {
            reading.problem(at + open, "`{{` is not closed by `}}` on its line");
            return;
        };
        // A noun may follow: it is counted.
        let field = text[inside..close].trim().split(' ').next().unwrap_or_default();
        let found_at = at + inside + (text[inside..close].len() - text[inside..close].trim_start().len());
        // What belongs to one answer: a plane to cut at, as it was weighed.
        match field.strip_prefix("own.").filter(|_| reading.plays == Plays::Build) {
            Some(own) => check_field("weigh", own, found_at, reading),
            None => check_field(event, field, found_at, reading),
        }
        from = close + 2;
    }
}
