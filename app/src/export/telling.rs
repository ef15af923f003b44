//! What a beat says and asks, as text for pages that are read.

use raystep_figure::{Answer, Fact, told};
use raystep_lesson::Choice;

use super::Session;
use crate::shown::words::label;

/// What a beat says, where it stands on its walk.
pub(crate) struct Telling {
    /// Its heading.
    pub(crate) heading: String,
    /// What it says: Markdown with formulas, its numbers filled in.
    pub(crate) text: String,
    /// What the step shows, in one sentence.
    pub(crate) shows: String,
    /// What it asks.
    pub(crate) asked: Option<Asked>,
}

/// A question with its answers.
pub(crate) struct Asked {
    /// The question: Markdown.
    pub(crate) question: String,
    /// The step before the one that answers it: the picture in which it is asked.
    pub(crate) before: usize,
    /// The answers, in order.
    pub(crate) answers: Vec<Answered>,
}

/// One answer.
pub(crate) struct Answered {
    /// What it says: Markdown.
    pub(crate) label: String,
    /// Whether it is right.
    pub(crate) right: bool,
    /// Why it is wrong, if the slide says so: Markdown.
    pub(crate) reason: Option<String>,
}

impl Session<'_> {
    /// The name of the ray that walks; none where a build is played.
    pub(crate) fn ray_name(&self) -> Option<&str> {
        self.ray.as_deref()
    }

    /// What a beat says and asks; nothing if this walk does not come to it.
    pub(crate) fn telling(&self, beat: usize) -> Option<Telling> {
        let step = self.step_of(beat)?;
        let event = self.play.event(step);
        let (heading, text) = self.said(event.as_ref(), step, Some(beat));
        Some(Telling { heading, text, shows: self.shows(step), asked: self.asked(beat, step) })
    }

    /// What a step shows, in one sentence.
    pub(crate) fn shows(&self, step: usize) -> String {
        let event = self.play.event(step);
        let says = |event: &dyn Fact| self.reel().sentence(step, event).replace("**", "");
        event.map_or_else(|| self.said(None, step, None).1.replace("**", ""), |event| says(&event))
    }

    fn asked(&self, beat: usize, step: usize) -> Option<Asked> {
        let ask = self.ground.beats.get(beat)?.ask.as_ref()?;
        let coming = self.play.event(step)?;
        let choices = ask.choices(&self.play, step);
        if choices.len() < 2 || step == 0 {
            return None;
        }
        let answer = |choice: &Choice| Answered {
            label: label(choice),
            right: choice.right,
            reason: choice.reason.as_ref().map(|why| told(why, &Answer { coming, own: choice.own })),
        };
        let before = self.stops().previous(step, raystep_accel::Grain::Arithmetic);
        Some(Asked { question: told(&ask.question, &coming), before, answers: choices.iter().map(answer).collect() })
    }
}
