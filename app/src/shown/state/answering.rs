//! Questions: which one is open, and what an answer does.

use raystep_accel::Place;
use raystep_figure::Symbol;
use raystep_lesson::{Beat, Facts, Listing, Offer, Tape};

use super::{Answered, Asked, State};
use crate::shown::playback::{Playback, Posed};

impl State {
    /// The question that is open now: it is answered by the next step. Where a beat speaks at this step it is heard
    /// first, and the question opens when one goes on; before a class a slide does not open with one either. Elsewhere
    /// the step before the answer is never shown without its question: it may give the answer away.
    pub fn question(&self) -> Option<&Posed> {
        self.posed_here().filter(|_| self.asking || !(self.speaks() || self.present && self.begins()))
    }

    /// The question that waits until the beat of this step has been read.
    pub(crate) fn question_waits(&self) -> bool {
        self.posed_here().is_some() && self.question().is_none()
    }

    fn posed_here(&self) -> Option<&Posed> {
        let playback = self.playback.as_ref().filter(|_| self.predict)?;
        playback.posed.iter().find(|posed| posed.before == self.view.step)
    }

    /// The last step of which anything may be told in advance: behind it a question is asked that it would answer.
    pub(crate) fn told(&self) -> usize {
        let playback = self.playback.as_ref().filter(|_| self.predict);
        let ahead = playback.into_iter().flat_map(|playback| &playback.posed).map(|posed| posed.before);
        ahead.filter(|before| *before >= self.view.step).min().unwrap_or(usize::MAX)
    }

    /// Whether nothing was said or asked on this slide before this step.
    fn begins(&self) -> bool {
        self.stops().into_iter().all(|step| step >= self.view.step)
    }

    /// Whether a beat stands at this very step.
    fn speaks(&self) -> bool {
        self.playback.as_ref().is_some_and(|playback| playback.play.beats.contains(&Some(self.view.step)))
    }

    /// The question that was just answered by this step.
    pub fn settled(&self) -> Option<(&Posed, Answered)> {
        let answered = self.answered?;
        let posed = self.playback.as_ref()?.posed.iter().find(|posed| posed.beat == answered.beat)?;
        (posed.step == self.view.step).then_some((posed, answered))
    }

    /// The beat that this step belongs to, with the step it waited for.
    pub fn beat(&self) -> Option<(&Beat, usize)> {
        let playback = self.playback.as_ref()?;
        let (beat, step) = playback.beat_at(self.view.step)?;
        Some((self.slide()?.beats.get(beat)?, step))
    }

    /// A click on a place: an answer, or the step at which the walk meets it next, or `back` where it last did.
    pub fn pick(&mut self, place: Option<Place>, back: bool) {
        if let Some(place) = place.filter(|_| self.question().is_some())
            && self.answer_place(place)
        {
            return;
        }
        self.picked = place.filter(|place| *place != Place::World);
        let laid = self.picked.and_then(|place| self.laid_out(place));
        if let Some(step) = laid {
            // It is shown now: nothing need stay lit.
            self.picked = None;
            self.playing = false;
            self.go(step);
        } else if let Some(place) = self.picked {
            self.run_to(|playback| playback.reel().steps_at(place), back);
        }
    }

    /// Where the pair of a cell of the matrix is laid out; of the pair that is shown, its other arrangement.
    fn laid_out(&self, place: Place) -> Option<usize> {
        let (Place::Cell(cell), Tape::Pairs(pairs)) = (place, &self.made()?.play.tape) else { return None };
        let now = self.view.step.checked_sub(1).and_then(|index| pairs.events.get(index));
        pairs.events.iter().enumerate().find_map(|(index, trial)| {
            let here = now.is_some_and(|now| (now.pair, now.case) == (trial.pair, trial.case));
            (trial.step.is_none() && trial.pair == cell.0 && !here).then_some(index + 1)
        })
    }

    /// To the next step that the line of the listing shows, or the one before.
    pub fn run_to_line(&mut self, line: usize, back: bool) {
        let library = self.library.clone();
        let Some(code) = self.slide().and_then(|slide| library.listing(&slide.listing)) else { return };
        self.run_to(|playback| steps_of_line(code, playback, line), back);
    }

    /// To the next step with this symbol on the timeline, or the one before.
    pub fn run_to_symbol(&mut self, symbol: &Symbol, back: bool) {
        self.run_to(|playback| playback.reel().steps_with(symbol), back);
    }

    /// To the next of some steps, or `back` to the last one before; past the end it begins anew. An open question
    /// is not passed by.
    fn run_to(&mut self, steps: impl Fn(&Playback) -> Vec<usize>, back: bool) {
        let Some(playback) = self.playback.clone().filter(|_| self.question().is_none()) else { return };
        let (now, steps) = (self.view.step, steps(&playback));
        let (before, after) = (steps.iter().rfind(|step| **step < now), steps.iter().find(|step| **step > now));
        let to = if back { before.or(steps.last()) } else { after.or(steps.first()) };
        if let Some(&step) = to {
            self.playing = false;
            self.go(step);
        }
    }

    /// What the beat that this step belongs to offers to do, on the slide's own scene.
    pub fn offers(&self) -> Vec<&Offer> {
        let beat = self.beat().filter(|_| !self.view.is_elsewhere());
        let known = beat.zip(self.playback.as_ref());
        let facts = known.and_then(|((beat, step), playback)| Some((beat, Facts::at(&playback.play, step)?)));
        facts.map_or_else(Vec::new, |(beat, facts)| beat.offers(&facts).collect())
    }

    /// Answers the open question by a click on a place, if that is an answer.
    pub fn answer_place(&mut self, place: Place) -> bool {
        let choices = self.question().map(|posed| &posed.choices);
        let choice = choices.and_then(|choices| choices.iter().position(|choice| choice.place == Some(place)));
        if let Some(choice) = choice {
            self.answer(choice);
        }
        choice.is_some()
    }

    /// Answers the open question; a right answer takes its step.
    pub(super) fn answer(&mut self, choice: usize) {
        let Some(posed) = self.question() else { return };
        let Some(right) = posed.choices.get(choice).map(|choice| choice.right) else { return };
        let (beat, step) = (posed.beat, posed.step);
        if right {
            self.view.step = step;
            self.asking = false;
        }
        let before = self.answered.filter(|answered| answered.beat == beat).and_then(|answered| answered.wrong());
        self.answered = Some(Answered { beat, choice, right, before });
    }

    /// What has been asked and answered at this step.
    pub fn asked(&self) -> Asked {
        let answered = self.answered.iter();
        let answers = answered.flat_map(|answered| answered.before.into_iter().chain([answered.choice])).collect();
        Asked { open: self.asking, answers }
    }

    /// Asks again what was asked when the place was kept, with the answers of then.
    pub(super) fn ask_again(&mut self) {
        let Asked { open, answers } = std::mem::take(&mut self.asked);
        self.asking = open && self.posed_here().is_some();
        let posed = self.made().and_then(|made| {
            let here = |posed: &&Posed| posed.step == self.view.step;
            self.question().or(made.posed.iter().find(here)).map(|posed| (posed, posed.before == self.view.step))
        });
        let Some((posed, open)) = posed else { return };
        let right = |choice: usize| posed.choices.get(choice).map(|choice| choice.right);
        let answered = answers.iter().try_fold(None, |before: Option<Answered>, &choice| {
            let right = right(choice)?;
            Some(Some(Answered { beat: posed.beat, choice, right, before: before.and_then(|before| before.wrong()) }))
        });
        // The right answer takes its step.
        self.answered = answered.flatten().filter(|answered| answered.right != open);
    }

    /// Takes the step of the open question without an answer.
    pub(super) fn skip(&mut self) {
        if let Some(step) = self.question().map(|posed| posed.step) {
            self.go(step);
        }
    }
}

/// The steps whose events a line of a listing shows.
fn steps_of_line(code: &Listing, playback: &Playback, line: usize) -> Vec<usize> {
    let line_of = |step: usize| Facts::at(&playback.play, step).and_then(|facts| code.line_of(&facts));
    let shows = |step: &usize| line_of(*step) == Some(line);
    (1..=playback.steps().last()).filter(|step| playback.steps().shows(*step)).filter(shows).collect()
}
