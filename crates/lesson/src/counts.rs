//! What heads of slides have in common: names that are not too long, lists that end, promises.

use crate::keys::At;
use crate::reading::Reading;
use crate::{limits, wait};

/// Says so if a name is too long to be shown anywhere.
pub(crate) fn check_length(what: &str, at: usize, text: &str, reading: &mut Reading<'_>) {
    let letters = text.chars().count();
    if letters > limits::TITLE {
        reading.problem(at, format!("{what} has {letters} letters: at most {} can be shown", limits::TITLE));
    }
}

/// Says so if a list is longer than anything that is read or played.
pub(crate) fn check_count(what: &str, at: usize, count: usize, most: usize, reading: &mut Reading<'_>) -> bool {
    let good = count <= most;
    if !good {
        reading.problem(at, format!("here are {count} {what}: at most {most} are allowed"));
    }
    good
}

/// Events that a walk must contain.
pub(crate) fn promises((at, texts): At<Vec<String>>, reading: &mut Reading<'_>) -> Vec<wait::Wait> {
    check_count("promises", at, texts.len(), limits::ENTRIES, reading);
    texts.iter().take(limits::ENTRIES).filter_map(|text| wait::parse(text, at, reading)).collect()
}
