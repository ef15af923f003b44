//! How a talk goes against its plan: the minutes that the slides' notes give, and those that have passed.

use raystep_lesson::{Library, Slide};

use super::state::State;

/// A talk from its first slide on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Talk {
    /// When it began, in seconds of any clock.
    began: f64,
    /// The slide it began with.
    from: usize,
    /// How many minutes there are, once the lecturer has said so.
    length: Option<f32>,
    /// Where the talk stood last, how many minutes were planned for that (nothing before it stood anywhere), and by how many
    /// the plan was moved: by jumps, and because it began in the middle of a slide.
    stood: usize,
    planned: Option<f32>,
    moved: f32,
}

/// What a slide takes whose notes say nothing, in minutes.
const USUAL: f32 = 3.0;

/// By how many minutes a talk is made longer or shorter.
const STEP: f32 = 5.0;

/// The minutes that a talk can have.
pub(crate) const LENGTHS: std::ops::RangeInclusive<f32> = 5.0..=600.0;

impl Talk {
    /// A talk begins now with a slide.
    pub fn begin(now: f64, from: usize) -> Talk {
        Talk { began: now, from, length: None, stood: from, planned: None, moved: 0.0 }
    }

    /// The same talk from this slide on, its time from now on.
    pub fn anew(&self, now: f64, from: usize) -> Talk {
        Talk { length: self.length, ..Talk::begin(now, from) }
    }

    /// How many minutes have passed.
    pub fn passed(&self, now: f64) -> f32 {
        ((now - self.began) / 60.0).max(0.0) as f32
    }

    /// How many minutes the talk has: until the end of the section in which it began, or as the lecturer has set it.
    pub fn length(&self, library: &Library) -> f32 {
        self.length.unwrap_or_else(|| {
            let section = library.slides.get(self.from).map(|slide| slide.section.as_str());
            let rest =
                library.slides.iter().skip(self.from).take_while(|slide| Some(slide.section.as_str()) == section);
            rest.map(minutes).sum()
        })
    }

    /// Makes it longer by five minutes, or shorter.
    pub fn lengthen(&mut self, library: &Library, longer: bool) {
        let now = self.length(library);
        let rounded = (now / STEP).round() * STEP;
        self.set_length(rounded + if longer { STEP } else { -STEP });
    }

    /// Makes it so many minutes long.
    pub fn set_length(&mut self, minutes: f32) {
        self.length = Some(minutes.clamp(*LENGTHS.start(), *LENGTHS.end()));
    }

    /// Takes in where the talk stands. A jump to a slide that is no neighbour leaves it as far behind its plan as it was:
    /// what is passed over was not to be taught.
    pub fn follow(&mut self, state: &State) {
        let here = state.view.slide;
        let before = match self.planned {
            None => Some(0.0),
            planned => planned.filter(|_| here.abs_diff(self.stood) > 1),
        };
        if let Some(before) = before {
            self.moved += before - self.planned_here(state);
        }
        (self.stood, self.planned) = (here, Some(self.planned_here(state)));
    }

    /// The minutes from the first slide to another one; less than none where that comes before it.
    fn before(&self, state: &State, slide: usize) -> f32 {
        let slides = &state.library.slides;
        let between = |from: usize, to: usize| slides.iter().take(to).skip(from).map(minutes).sum::<f32>();
        between(self.from, slide) - between(slide, self.from)
    }

    /// How many minutes should have passed where the talk stands: those of the slides before, and of this one as many as
    /// of its beats are over.
    pub fn planned(&self, state: &State) -> f32 {
        self.planned_here(state).max(0.0)
    }

    fn planned_here(&self, state: &State) -> f32 {
        let slides = &state.library.slides;
        let here = state.view.slide;
        let before = self.before(state, here) + self.moved;
        let beats = state.playback().map_or(&[][..], |playback| playback.play.beats.as_slice());
        let all = beats.iter().flatten().count();
        let over = beats.iter().flatten().filter(|step| **step < state.view.step).count();
        let part = if all > 0 { over as f32 / all as f32 } else { 0.0 };
        let now = slides.get(here).map_or(0.0, minutes);
        before + part * now
    }
}

/// How many minutes a slide takes.
pub(crate) fn minutes(slide: &Slide) -> f32 {
    slide.minutes().unwrap_or(USUAL)
}

/// Minutes as they stand on a clock: `"27:10"`.
pub(crate) fn clock(minutes: f32) -> String {
    let seconds = (minutes * 60.0).round() as u32;
    match seconds / 3600 {
        0 => format!("{}:{:02}", seconds / 60, seconds % 60),
        hours => format!("{hours}:{:02}:{:02}", seconds / 60 % 60, seconds % 60),
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;

    #[test]
    fn a_talk_is_as_long_as_its_slides_and_can_be_made_longer() {
        let library = Arc::new(Library::embedded());
        let first = library.slides.iter().position(|slide| slide.id() == "5/33").unwrap();
        let mut talk = Talk::begin(100.0, first);
        let section: f32 =
            library.slides[first..].iter().filter(|slide| slide.section == "05-kd-tree").map(minutes).sum();
        assert_eq!(talk.length(&library), section);
        talk.lengthen(&library, true);
        assert_eq!(talk.length(&library), (section / 5.0).round() * 5.0 + 5.0);
        assert_eq!((talk.passed(100.0), talk.passed(1730.0)), (0.0, 1630.0 / 60.0));
        talk.follow(&State::new(library.clone(), first));
        let state = State::new(library.clone(), first + 1);
        assert_eq!(talk.planned(&state), minutes(&library.slides[first]));
        assert_eq!(talk.planned(&State::new(library.clone(), first - 1)), 0.0);
        talk.set_length(90.0);
        assert_eq!((talk.anew(7.0, 3).length(&library), talk.anew(7.0, 3).passed(67.0)), (90.0, 1.0));
        // A jump far ahead is no hurry, and one back no delay.
        for slide in [first + 9, first - 9] {
            let there = State::new(library.clone(), slide);
            talk.follow(&there);
            assert_eq!(talk.planned(&there), 0.0);
        }
        assert_eq!((clock(27.1667), clock(0.0), clock(61.5)), ("27:10".into(), "0:00".into(), "1:01:30".into()));
    }

    #[test]
    fn every_shipped_slide_says_how_long_it_takes() {
        for slide in &Library::embedded().slides {
            assert!(slide.minutes().is_some(), "{}: its notes name no minutes", slide.file);
        }
    }
}
