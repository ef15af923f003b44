//! All that is under way beside the UI thread.

use std::sync::Arc;

use raystep_paint::Mesh;

use super::errands::Errands;
use super::heating::{Heating, Level};
use super::judging::Judging;
use super::making::{Failure, Made};
use super::second::Second;
use super::task::Task;
use super::workshop::Workshop;
use crate::shown::beside::Beside;
use crate::shown::heat::Wish;
use crate::shown::playback::Playback;
use crate::shown::state::State;

/// Where walks are made for the state, and errands run.
pub(crate) struct Underway {
    workshop: Workshop,
    second: Second,
    heating: Heating,
    mesh: Option<Arc<Mesh>>,
    /// The draft that is not to be refined.
    left: Option<Arc<Playback>>,
    /// All structures, measured one after the other.
    pub(crate) judging: Judging,
    /// What happens outside the window.
    pub(crate) errands: Errands,
}

impl Underway {
    pub(crate) fn new(context: &egui::Context) -> Underway {
        Underway {
            workshop: Workshop::new(context.clone()),
            second: Second::new(context),
            heating: Heating::new(context),
            mesh: None,
            left: None,
            judging: Judging::new(context),
            errands: Errands::new(context.clone()),
        }
    }

    /// Uploads solid scenes to this device from now on, the one that is shown at once; or to none.
    pub(crate) fn upload_to(&mut self, device: Option<wgpu::Device>, shown: Option<&Arc<Playback>>) {
        self.mesh = None;
        self.workshop.upload_to(device);
        if let Some(playback) = shown {
            self.workshop.upload(&playback.play.scene);
        }
    }

    /// The solid scene of the walk that is shown, on the GPU, where there is one.
    pub(crate) fn mesh(&self) -> Option<&Arc<Mesh>> {
        self.mesh.as_ref()
    }

    /// The walk beside, once it is there.
    pub(crate) fn beside(&self) -> Option<&Arc<Playback>> {
        self.second.shown()
    }

    /// Whether a walk is being made.
    pub(crate) fn is_making(&self) -> bool {
        self.workshop.task().is_some()
    }

    /// Whether nothing is built or counted any more, not even what was given up.
    pub(crate) fn is_idle(&self) -> bool {
        self.workshop.is_idle() && self.heating.is_idle() && self.judging.is_idle()
    }

    /// The heat map as far as it is counted, and whether a finer one is on its way.
    pub(crate) fn heat(&self) -> (Option<&Level>, bool) {
        (self.heating.shown(), self.heating.is_underway())
    }

    /// Counts the heat map that is wished for, as far as it is not there.
    pub(crate) fn catch_up_heat(&mut self, wish: Option<Wish>) {
        self.heating.catch_up(wish);
    }

    /// Makes the walk that the state asks for, as far as it is not there. Says what went wrong.
    pub(crate) fn catch_up(&mut self, state: &mut State) -> Option<String> {
        let is_shown = |scene| state.playback().is_some_and(|shown| Arc::ptr_eq(&shown.play.scene, scene));
        if let Some((scene, mesh)) = self.workshop.uploaded()
            && is_shown(&scene)
        {
            self.mesh = Some(mesh);
        }
        let wrong = self.collect(state);
        match state.wanted() {
            Some(wanted) => {
                self.workshop.ask(wanted, &state.library);
                self.collect(state)
            }
            None => {
                match state.playback().filter(|shown| shown.is_draft() && !self.is_left_so(shown)) {
                    Some(draft) => self.workshop.refine(draft, &state.library),
                    None => _ = self.workshop.cancel(),
                }
                wrong
            }
        }
    }

    /// Whether somebody has given up to refine a draft.
    fn is_left_so(&self, draft: &Arc<Playback>) -> bool {
        self.left.as_ref().is_some_and(|left| Arc::ptr_eq(left, draft))
    }

    /// Takes the walk that was made. Says what went wrong.
    fn collect(&mut self, state: &mut State) -> Option<String> {
        match self.workshop.collect()? {
            Ok(Made { playback, mesh }) => {
                let playback = Arc::new(playback);
                if state.refine(&playback) || state.arrive(playback) {
                    self.mesh = mesh;
                }
                None
            }
            Err(failure) => {
                self.give_up(state);
                match failure {
                    Failure::Wrong(sentence) => Some(sentence),
                    Failure::Cancelled => None,
                }
            }
        }
    }

    /// Makes the walk that is shown beside the other, if one is wanted. Says what went wrong.
    pub(crate) fn catch_up_beside(&mut self, state: &mut State) -> Option<String> {
        self.second.catch_up(state)
    }

    /// Looks for a ray on which a mistake shows, to show it beside the walk; or shows none. Says what to expect.
    pub(crate) fn break_it(&mut self, state: &mut State, mistake: Option<usize>) -> Option<String> {
        self.second.break_it(state, mistake)
    }

    /// Everything that is under way.
    pub(crate) fn tasks(&mut self) -> Vec<Arc<Task>> {
        let mut tasks = self.errands.tasks().to_vec();
        let making = self.workshop.task().into_iter().chain(self.second.task());
        tasks.extend(making.chain(self.heating.task()).cloned());
        tasks
    }

    /// Gives up one piece of work.
    pub(crate) fn stop(&mut self, task: &Arc<Task>, state: &mut State) {
        let is = |other: Option<&Arc<Task>>| other.is_some_and(|other| Arc::ptr_eq(other, task));
        let (making, beside) = (is(self.workshop.task()), is(self.second.task()));
        if making {
            self.stop_making(state);
        }
        if beside {
            self.stop_beside(state);
        }
        if is(self.heating.task()) {
            self.heating.cancel();
        }
        task.stop();
    }

    /// Gives up everything that is under way: what is shown stays.
    pub(crate) fn stop_all(&mut self, state: &mut State) {
        for task in self.errands.tasks() {
            task.stop();
        }
        self.stop_making(state);
        self.stop_beside(state);
        self.heating.cancel();
    }

    fn stop_making(&mut self, state: &mut State) {
        if self.workshop.cancel() {
            self.give_up(state);
        }
    }

    /// What was wanted is not; what was to be refined stays a draft.
    fn give_up(&mut self, state: &mut State) {
        match state.wanted() {
            Some(_) => state.refuse(),
            None => self.left = state.playback().cloned(),
        }
    }

    fn stop_beside(&mut self, state: &mut State) {
        if self.second.cancel() {
            state.beside = Beside::Nothing;
        }
    }

    /// Other lessons: what is being made is made for them.
    pub(crate) fn renew(&mut self) {
        self.workshop.cancel();
    }
}
