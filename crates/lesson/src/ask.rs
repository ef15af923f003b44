//! A question, asked before the step that answers it.

use raystep_accel::{Event, Place, Value};

use crate::Spot;

/// A question. Its right answer is read off what is played, so it is right for every ray; only what no event tells is
/// said by the slide itself.
#[derive(Clone, Debug, PartialEq)]
pub struct Ask {
    /// The question: Markdown, with `{{field}}` of the coming event.
    pub question: String,
    /// What answers it.
    pub about: About,
    /// Of a question about a word: the words to choose from, if not all.
    pub options: Vec<String>,
    /// The wrong answers, each with its reason.
    pub reasons: Vec<Reason>,
    /// Where it stands.
    pub(crate) spot: Spot,
    /// Where each line of the question begins.
    pub(crate) lines: Vec<Spot>,
}

/// What answers a question.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum About {
    /// A field of the coming event.
    Field(String),
    /// How many such events the whole walk or build has.
    Count {
        /// The name of the events.
        event: String,
        /// Only those in which this field is what it is in the coming event.
        alike: Option<String>,
    },
    /// Which of these events comes.
    Event(Vec<String>),
    /// Of walks side by side, the one that has the fewest such events.
    Least(String),
    /// What no event tells: the slide says it.
    Said(String),
}

impl About {
    /// Whether it is asked how many there are in all: whatever counts them gives it away.
    pub fn is_total(&self) -> bool {
        match self {
            About::Count { .. } => true,
            About::Field(field) => ["references", "nodes", "cells"].contains(&field.as_str()),
            About::Event(_) | About::Least(_) | About::Said(_) => false,
        }
    }
}

/// Why an answer is wrong.
#[derive(Clone, Debug, PartialEq)]
pub struct Reason {
    /// The answer: a word, `yes`, an axis, a field of the same event, a number.
    pub answer: String,
    /// What stands on its button, if not the answer itself.
    pub label: Option<String>,
    /// Markdown, with `{{field}}` of the event.
    pub text: String,
    /// Where it stands.
    pub(crate) spot: Spot,
    /// Where each line of the text begins.
    pub(crate) lines: Vec<Spot>,
}

/// One possible answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    /// What stands on the button instead of the value: as the slide says, or `"lower"` for a child of a split.
    pub label: Option<String>,
    /// Its value, for the one formatter.
    pub value: Value,
    /// A click on this place gives this answer.
    pub place: Option<Place>,
    /// Whether it is right.
    pub right: bool,
    /// Why it is not: Markdown with `{{field}}` of the event, and `{{own.field}}` of [`Choice::own`].
    pub reason: Option<String>,
    /// The event that is this answer's own: of a plane to cut at, how it was weighed.
    pub own: Option<Event>,
    /// Whether it cuts a list and not space: then it says how many go to each part.
    pub of_list: bool,
}
