//! Steps: to one of them, on and back by a grain, and by themselves as time passes.

use raystep_accel::Grain;
use raystep_lesson::Tape;

use super::{Landing, State};
use crate::shown::beside::Pace;
use crate::shown::command::QUARTERS;
use crate::shown::playback::{Playback, Posed};
use crate::shown::view::View;

impl State {
    /// Stands at a step as soon as the walk is there.
    pub fn open_at(&mut self, step: usize) {
        let view = View { step, ..self.target().clone() };
        self.want(view, Landing::Named);
    }

    /// To a step; nothing is asked on the way.
    pub fn go(&mut self, step: usize) {
        if let Some(playback) = &self.playback {
            self.view.step = step.min(playback.steps().last());
            // What happens is seen in space.
            self.heat = None;
            self.anchor = None;
            self.view.tried = None;
            self.trial = None;
            self.answered = None;
            self.asking = false;
        }
    }

    /// Time passes: a playing walk goes on. Says after how many seconds it will again.
    pub fn tick(&mut self, seconds: f32) -> Option<f32> {
        if !self.playing {
            return None;
        }
        let period = 0.9 * f32::from(QUARTERS) / f32::from(self.speed);
        self.waited += seconds;
        if self.waited >= period {
            self.waited = 0.0;
            let before = self.view.step;
            if self.question().is_none() {
                self.forward(self.grain);
            }
            let last = self.playback.as_ref().map_or(0, |playback| playback.steps().last());
            self.playing = self.view.step != before && self.view.step < last && self.question().is_none();
        }
        self.playing.then_some(period - self.waited)
    }

    /// The step of a walk beside that goes with the step of the walk shown: when one is over, so is the other. While a
    /// question is open the walk beside waits at its beginning, since it may know the answer.
    pub fn beside_step(&self, beside: &Playback) -> usize {
        let (step, last) = (self.view.step, beside.steps().last());
        if let (Tape::Walks(walks), None) = (&beside.play.tape, self.question()) {
            return walks.step_with(0, step);
        }
        match self.playback() {
            _ if self.question().is_some() => 0,
            Some(playback) if step == playback.steps().last() => last,
            Some(playback) if self.pace == Pace::T && step > 0 => beside.step_at(playback.reached(step)),
            _ => step.min(last),
        }
    }

    pub(super) fn forward(&mut self, grain: Grain) {
        self.heat = None;
        let step = self.view.step;
        if self.present && self.opens_or_closes_a_question() {
            return;
        }
        let Some(playback) = &self.playback else { return };
        if self.question_waits() {
            self.asking = true;
            return;
        }
        if let Some(posed) = self.question() {
            // The step that answers the question, whatever its grain.
            let answer = posed.step;
            if !self.locked {
                self.go(answer);
            }
            return;
        }
        let next = playback.steps().next(step, grain);
        let asks = |posed: &&Posed| posed.before > step && posed.before <= next && posed.step > step;
        let question = playback.posed.iter().filter(|_| self.predict).filter(asks).map(|posed| posed.before).min();
        self.go(question.unwrap_or(next));
    }

    pub(super) fn back(&mut self, grain: Grain) {
        self.heat = None;
        if self.asking || self.is_settled() {
            // From the question back to what was said before it.
            self.asking = false;
            self.answered = None;
            return;
        }
        if let Some(playback) = &self.playback {
            let previous = playback.steps().previous(self.view.step, grain);
            self.go(previous);
        }
    }
}
