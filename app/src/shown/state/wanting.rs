//! What shall be shown next: wanted, then there; or given up. Until it is there the page stays as it is.

use std::sync::Arc;

use raystep_lesson::{Library, Plays};

use super::{Asked, Before, Landing, State, first_stage};
use crate::shown::history::History;
use crate::shown::playback::Playback;
use crate::shown::view::{RayChoice, View};

impl State {
    /// Whether everything that is wanted is shown.
    pub fn is_current(&self) -> bool {
        self.playback.is_some() && self.wanted.is_none()
    }

    /// What shall be shown, while its walk is not there.
    pub fn wanted(&self) -> Option<&View> {
        self.wanted.as_ref()
    }

    /// Whether another slide or stage than the one shown is wanted, and not there yet.
    pub(crate) fn leaves(&self) -> bool {
        let shown = (self.view.slide, self.view.stage);
        self.playback.is_some() && self.wanted.as_ref().is_some_and(|wanted| (wanted.slide, wanted.stage) != shown)
    }

    /// What is shown as soon as everything wanted is there.
    pub fn target(&self) -> &View {
        self.wanted.as_ref().unwrap_or(&self.view)
    }

    /// Opens a view that was kept from another time, at its step as far as its walk goes, with what was asked there.
    pub fn reopen(&mut self, view: View, asked: Asked) {
        self.wished = view.stage;
        self.want(view, Landing::Named);
        self.asked = asked;
        if self.wanted.is_none() {
            self.ask_again();
        }
    }

    /// Asks for another view; at once there if only the step or the camera differ.
    pub(super) fn want(&mut self, view: View, landing: Landing) {
        self.playing = false;
        self.answered = None;
        self.asking = false;
        self.asked = Asked::default();
        self.waited = 0.0;
        match self.playback.clone().filter(|_| view.same_walk(&self.view)) {
            Some(playback) => {
                let step = self.landed(&playback, view.step, landing);
                self.view = View { step, ..view };
                self.wanted = None;
                self.renew_trial();
            }
            None => {
                if landing == Landing::Keep && self.anchor.is_none() {
                    self.anchor = self.playback.clone().map(|playback| (playback, self.view.step));
                }
                self.wanted = Some(view);
                self.landing = landing;
            }
        }
    }

    /// A walk was made: it is shown from now on, unless something else is wanted by now. Says whether it is.
    pub fn arrive(&mut self, playback: Arc<Playback>) -> bool {
        let Some(wanted) = &self.wanted else { return false };
        let exactly = playback.view.same_walk(wanted);
        // What a meter moves is seen to move: it arrives one after the other, as what is held does.
        let metered = self.plays_board(wanted.slide) && playback.view.same_scene(wanted);
        if !exactly && !metered && !playback.view.same_but_held(wanted) {
            return false;
        }
        let tried = wanted.tried;
        let step = self.landed(&playback, wanted.step, self.landing);
        self.view = View { step, tried, ..playback.view.clone() }.looking_as(wanted);
        self.playback = Some(playback);
        self.renew_trial();
        self.before = None;
        self.answered = None;
        self.asking = false;
        if exactly {
            self.wanted = None;
            self.ask_again();
        }
        true
    }

    /// A draft that is shown was refined: it takes its place, at the same step. Says whether it does.
    pub fn refine(&mut self, playback: &Arc<Playback>) -> bool {
        let draft = self.playback.as_ref().filter(|shown| self.wanted.is_none() && shown.is_draft());
        let refined =
            draft.is_some_and(|draft| playback.view.same_walk(&draft.view) && playback.fineness() > draft.fineness());
        if refined {
            self.playback = Some(playback.clone());
        }
        refined
    }

    /// Whether a slide plays a board.
    fn plays_board(&self, slide: usize) -> bool {
        self.library.slides.get(slide).is_some_and(|slide| slide.plays == Plays::Board)
    }

    fn landed(&self, playback: &Playback, named: usize, landing: Landing) -> usize {
        let step = match landing {
            Landing::Opening => playback.opening(self.predict),
            Landing::Keep => match &self.anchor {
                Some((before, step)) => playback.like(before, *step).unwrap_or(*step),
                None => self.view.step,
            },
            Landing::Named => named,
            Landing::LastBeat => playback.play.beats.iter().flatten().copied().max().unwrap_or(named),
            Landing::Split(node) => playback.split_of(node).unwrap_or(self.view.step),
        };
        step.min(playback.steps().last())
    }

    /// What is wanted is given up, or cannot be made: what is shown stays. Of lessons that were read again nothing is
    /// shown yet: then it is what was shown before.
    pub fn refuse(&mut self) {
        self.wanted = None;
        match self.before.take() {
            Some(before) => {
                self.library = before.library;
                self.view = before.view;
                self.playback = Some(before.playback);
            }
            None => _ = self.history.forget(&self.view),
        }
    }

    /// Other lessons: the same slide at the same step. What cannot be read in them stays as it was.
    pub fn renew(&mut self, library: Library) {
        let library = Arc::new(library.keeping(&self.library, self.slide()));
        let view = moved(&self.view, &self.library, &library);
        let wanted = self.wanted.take().map(|wanted| moved(&wanted, &self.library, &library));
        if let Some(playback) = self.playback.take() {
            self.before = Some(Before { library: self.library.clone(), view: self.view.clone(), playback });
        }
        self.library = library;
        self.history = History::default();
        self.left.clear();
        // What was on its way still is.
        if wanted.is_none() {
            self.landing = Landing::Named;
        }
        self.wanted = Some(wanted.unwrap_or_else(|| view.clone()));
        self.view = view;
    }
}

/// A view of the old lessons in the new ones: the slide and the ray by their names.
fn moved(view: &View, old: &Library, new: &Library) -> View {
    let Some(before) = old.slides.get(view.slide) else { return view.clone() };
    let slide = new.place_of(before, view.slide);
    let stage = first_stage(new, slide, view.stage);
    let rays = |library: &Library, slide: usize| {
        let slide = library.slides.get(slide)?;
        Some(slide.stage(stage)?.rays.iter().map(|ray| ray.name.clone()).collect::<Vec<_>>())
    };
    let ray = match view.ray {
        RayChoice::Named(index) => {
            let name = rays(old, view.slide).and_then(|rays| rays.get(index).cloned());
            let same = |rays: Vec<String>| rays.iter().position(|ray| Some(ray) == name.as_ref());
            RayChoice::Named(rays(new, slide).and_then(same).unwrap_or(0))
        }
        RayChoice::Own(ray) => RayChoice::Own(ray),
    };
    View { slide, stage, ray, tried: None, ..view.clone() }
}
