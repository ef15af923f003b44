//! What is still to come on a board of what is seen there.

use raystep_lesson::{BoardTape, Care, Entry, Tape};

use super::playback::Playback;

/// What is being made of what a board shows at a step, for whoever waits for it; nothing where all is there.
pub(crate) fn awaited(playback: &Playback, step: usize) -> Option<&'static str> {
    let Tape::Board(filled) = &playback.play.tape else { return None };
    let seen = || 0..step.min(filled.places.len());
    let is_traced = |entry: usize| matches!(filled.board.entry(filled.places[entry]), Some(Entry::Picture(_)));
    if seen().any(|entry| filled.care_of(entry) == Care::Bare && is_traced(entry)) {
        return Some("the picture is being made \u{2026}");
    }
    let measures = seen().any(|entry| filled.care_of(entry) < Care::Full) || times(filled, step);
    measures.then_some("more is being measured \u{2026}")
}

/// Whether something that is seen is still to be timed.
fn times(filled: &BoardTape, step: usize) -> bool {
    filled.is_clocked && filled.untimed().is_some_and(|entry| entry < step)
}
