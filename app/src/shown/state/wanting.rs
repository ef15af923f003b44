//! What shall be shown next: wanted, then there; or given up. Until it is there the page stays as it is.

use std::sync::Arc;

use raystep_lesson::{Library, Slide};

use super::{Landing, State, first_stage};
use crate::shown::history::History;
use crate::shown::playback::Playback;
use crate::shown::view::View;

impl State {
    /// Whether everything that is wanted is shown.
    pub fn is_current(&self) -> bool {
        self.playback.is_some() && self.wanted.is_none()
    }

    /// What shall be shown, while its walk is not there.
    pub fn wanted(&self) -> Option<&View> {
        self.wanted.as_ref()
    }

    /// What is shown as soon as everything wanted is there.
    pub fn target(&self) -> &View {
        self.wanted.as_ref().unwrap_or(&self.view)
    }

    /// Asks for another view; at once there if only the step or the camera differ.
    pub(super) fn want(&mut self, view: View, landing: Landing) {
        self.playing = false;
        self.answered = None;
        self.asking = false;
        self.waited = 0.0;
        match self.playback.clone().filter(|_| view.same_walk(&self.view)) {
            Some(playback) => {
                let step = self.landed(&playback, view.step, landing);
                self.view = View { step, ..view };
                self.wanted = None;
            }
            None => {
                self.wanted = Some(view);
                self.landing = landing;
            }
        }
    }

    /// A walk was made: it is shown from now on, unless something else is wanted by now. Says whether it is.
    pub fn arrive(&mut self, playback: Arc<Playback>) -> bool {
        let Some(wanted) = &self.wanted else { return false };
        let exactly = playback.view.same_walk(wanted);
        if !exactly && !playback.view.same_but_own_ray(wanted) {
            return false;
        }
        let (camera, named) = (wanted.camera, wanted.step);
        let step = self.landed(&playback, named, self.landing);
        self.view = View { step, camera, ..playback.view.clone() };
        self.playback = Some(playback);
        self.answered = None;
        self.asking = false;
        if exactly {
            self.wanted = None;
        }
        true
    }

    fn landed(&self, playback: &Playback, named: usize, landing: Landing) -> usize {
        let step = match landing {
            Landing::Opening => playback.opening(self.predict),
            Landing::Keep => self.view.step,
            Landing::Named => named,
        };
        step.min(playback.steps().last())
    }

    /// What is wanted is given up, or cannot be made: what is shown stays.
    pub fn refuse(&mut self) {
        self.wanted = None;
        self.history.forget(&self.view);
    }

    /// Other lessons: the same slide as far as it is still there, at the same step.
    pub fn renew(&mut self, library: Arc<Library>) {
        let name = self.slide().map(|slide| (slide.section.clone(), slide.name.clone()));
        let same = |slide: &Slide| name.as_ref() == Some(&(slide.section.clone(), slide.name.clone()));
        let slide = library.slides.iter().position(same).unwrap_or(0);
        self.library = library;
        self.view.slide = slide;
        self.view.stage = first_stage(&self.library, slide, self.view.stage);
        self.history = History::default();
        self.playback = None;
        self.wanted = Some(self.view.clone());
        self.landing = Landing::Named;
    }
}
