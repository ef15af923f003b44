//! A question, asked before the step that answers it.

use raystep_accel::{Place, Value};

use crate::Spot;

/// A question. Its right answer is read off the walk, so it is right for every ray.
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
}

/// What answers a question.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum About {
    /// A field of the coming event.
    Field(String),
    /// How many such events the whole walk has.
    Count(String),
    /// Which of these events comes.
    Event(Vec<String>),
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
    /// Why it is not: Markdown with `{{field}}` of the event.
    pub reason: Option<String>,
}
