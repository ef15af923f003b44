//! What is said about a walk in short: structures, questions and answers by name.

use raystep_accel::{Event, Grow};
use raystep_figure::{Answer, coordinate, told, value};
use raystep_lesson::Choice;

use super::playback::Posed;
use super::state::State;

/// The question with the numbers of the coming event that it names.
pub(crate) fn question_text(state: &State, posed: &Posed) -> String {
    let ask = state.slide().and_then(|slide| slide.beats.get(posed.beat)?.ask.as_ref());
    let event = state.playback().and_then(|playback| playback.event(posed.step));
    match (ask, event) {
        (Some(ask), Some(event)) => told(&ask.question, &event),
        _ => String::new(),
    }
}

/// Why an answer is wrong, in this step's numbers.
pub(crate) fn reason(state: &State, posed: &Posed, choice: &Choice) -> String {
    let event = state.playback().and_then(|playback| playback.event(posed.step));
    match (&choice.reason, event) {
        (Some(reason), Some(event)) => told(reason, &Answer { coming: event, own: choice.own }),
        _ => "Look at the numbers of this step and try again.".to_owned(),
    }
}

/// What stands on an answer's button.
pub(crate) fn label(choice: &Choice) -> String {
    let cut = match choice.own {
        Some(Event::Build(Grow::Weigh { axis, .. })) => {
            let at = format!("{} = {}", coordinate(axis), value(&choice.value));
            Some(shares(choice).map_or(at.clone(), |shares| format!("{shares}, at {at}")))
        }
        _ => None,
    };
    choice.label.clone().or(cut).unwrap_or_else(|| value(&choice.value))
}

/// Where an answer cuts a list: how many go to each part.
pub(crate) fn shares(choice: &Choice) -> Option<String> {
    match choice.own {
        Some(Event::Build(Grow::Weigh { below, above, .. })) if choice.of_list => Some(format!("{below} | {above}")),
        _ => None,
    }
}
