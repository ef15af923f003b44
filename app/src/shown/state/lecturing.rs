//! Before a class: from beat to beat and across slides, one thing at a time; other rays; slides by their numbers.

use raystep_lesson::StageKind;

use super::{Answered, Landing, State};
use crate::shown::command::Command;
use crate::shown::lecture::{Cover, InHand};
use crate::shown::view::{RayChoice, View};

impl State {
    /// Does what a lecturer asks for; says whether that was all there is to do.
    pub(super) fn lecture(&mut self, command: Command) -> bool {
        let lecture = &mut self.lecture;
        if !matches!(command, Command::Type(_) | Command::Skip) {
            lecture.typed.clear();
        }
        match command {
            Command::Black => lecture.cover(Cover::Black),
            Command::White => lecture.cover(Cover::White),
            // What goes on uncovers the page first.
            _ if moves(command) && lecture.cover.take().is_some() => {}
            Command::Pointer => lecture.take(InHand::Pointer),
            Command::Pen => lecture.take(InHand::Pen),
            Command::Panes => lecture.turn += 1,
            // Whoever has a window for the notes has them there, not on the wall.
            Command::Notes => lecture.notes = !lecture.notes && !lecture.speaker,
            Command::Freeze => lecture.frozen = !lecture.frozen,
            Command::Type(letter) => lecture.type_letter(letter),
            Command::Skip if !lecture.typed.is_empty() => self.go_to_typed(),
            _ => return false,
        }
        true
    }

    /// The presenter's page, or the study. What was set for one class is not set for the next.
    pub(super) fn present(&mut self) {
        self.present = !self.present;
        self.lecture = Default::default();
        self.answered = None;
    }

    /// The speaker's window beside the presenter's page, or no longer.
    pub(super) fn speak(&mut self) {
        if !self.present {
            self.present();
        }
        self.lecture.speaker = !self.lecture.speaker;
        self.lecture.notes = false;
    }

    /// The letters with which the number that is being typed goes on: `b` after `40`, as in `40b`.
    pub(crate) fn letters_of_number(&self) -> Vec<char> {
        let typed = &self.lecture.typed;
        let number = typed.rsplit_once('/').map_or(typed.as_str(), |(_, number)| number);
        if !self.present || number.is_empty() {
            return Vec::new();
        }
        let numbers = self.library.slides.iter().flat_map(|slide| &slide.numbers);
        let next = numbers.filter_map(|known| known.strip_prefix(number)?.chars().next());
        next.filter(char::is_ascii_alphabetic).collect()
    }

    /// To the slide whose number was typed, if there is one.
    fn go_to_typed(&mut self) {
        let typed = std::mem::take(&mut self.lecture.typed);
        if let Some(slide) = self.library.numbered(&typed) {
            // Also the one that is shown: it begins anew.
            self.open_slide(slide);
        }
    }

    /// The next thing that is said or asked: what an answer means, the question behind a beat, its answer, the next
    /// beat, the next slide.
    pub(super) fn onward(&mut self) {
        // What is on its way is waited for: no slide is passed by.
        if self.leaves() {
            return;
        }
        if self.opens_or_closes_a_question() {
            return;
        }
        let now = self.view.step;
        match self.stops().into_iter().filter(|step| *step > now).min() {
            Some(step) => self.go(step),
            None => self.show_slide(self.target().slide + 1),
        }
    }

    /// The thing before; on the slide before where one was.
    pub(super) fn backward(&mut self) {
        if self.leaves() {
            return;
        }
        if self.asking || self.is_settled() {
            (self.asking, self.answered) = (false, None);
            return;
        }
        let now = self.view.step;
        match self.stops().into_iter().filter(|step| *step < now).max() {
            Some(step) => self.go(step),
            None => self.return_to_slide(self.target().slide.wrapping_sub(1)),
        }
    }

    /// Whether the answer to a question is shown, which was answered before a class: what the beat says comes after.
    pub fn is_settled(&self) -> bool {
        self.present && self.settled().is_some()
    }

    /// Goes on where a question is about to open, is open, or was answered; says whether it did.
    pub(super) fn opens_or_closes_a_question(&mut self) -> bool {
        if self.is_settled() {
            self.answered = None;
        } else if self.question_waits() {
            self.asking = true;
        } else if self.question().is_some() && self.locked {
            // It waits for an answer.
        } else if let Some(posed) = self.question() {
            let (beat, step) = (posed.beat, posed.step);
            let right = posed.choices.iter().position(|choice| choice.right);
            let wrong = self.answered.filter(|answered| answered.beat == beat).and_then(|answered| answered.wrong());
            self.go(step);
            self.answered = right.map(|choice| Answered { beat, choice, right: true, before: wrong });
        } else {
            return false;
        }
        true
    }

    /// The steps at which something is said or asked.
    pub(super) fn stops(&self) -> Vec<usize> {
        let Some(playback) = &self.playback else { return Vec::new() };
        let asked = playback.posed.iter().filter(|_| self.predict).map(|posed| posed.before);
        playback.play.beats.iter().flatten().copied().chain(asked).collect()
    }

    /// Back to a slide: where one was on it, else where it speaks last.
    fn return_to_slide(&mut self, slide: usize) {
        if slide >= self.library.slides.len() {
            return;
        }
        let left = self.left.get(&slide).cloned();
        self.leave();
        match left {
            Some(view) => self.want(view, Landing::Named),
            None => self.want(
                View::of_slide(slide, super::opening_stage(&self.library, slide, self.wished)),
                Landing::LastBeat,
            ),
        }
    }

    /// The slide's next ray, or the one before; after the last comes the first.
    pub(super) fn turn_ray(&mut self, back: bool) {
        let many = self.stage().map_or(0, |stage| stage.rays.len());
        if many == 0 {
            return;
        }
        let now = match self.target().ray {
            RayChoice::Named(index) => Some(index),
            RayChoice::Own(_) => None,
        };
        let next = match (now, back) {
            (Some(now), false) => (now + 1) % many,
            (Some(now), true) => (now + many - 1) % many,
            (None, _) => 0,
        };
        self.show_ray(RayChoice::Named(next), false);
    }

    /// The slide's other stage, if it has two.
    pub(super) fn turn_stage(&mut self) {
        self.show_stage(match self.target().stage {
            StageKind::Flat => StageKind::Solid,
            StageKind::Solid => StageKind::Flat,
        });
    }
}

/// Whether a command changes what the class sees on its page.
fn moves(command: Command) -> bool {
    matches!(
        command,
        Command::Onward
            | Command::Backward
            | Command::Next
            | Command::Previous
            | Command::NextCoarse
            | Command::PreviousCoarse
            | Command::Play
            | Command::First
            | Command::Last
            | Command::NextSlide
            | Command::PreviousSlide
            | Command::NextRay
            | Command::PreviousRay
            | Command::OtherStage
            | Command::Skip
    )
}
