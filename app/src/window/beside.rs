//! The walk beside the walk: through another structure, or with a mistake made.

use std::sync::Arc;

use egui::Ui;
use raystep_accel::{Cancelled, Cost, Primitives, Ray, Rule};
use raystep_figure::Space;
use raystep_lesson::Plays;

use super::app::App;
use super::bench::{Bench, Broken};
use super::playback::{Built, Playback, cost};
use super::state::{Beside, Pace};
use super::task::Task;
use super::view::{RayChoice, View};
use super::workshop::{Failure, build, builds_quickly, walks_quickly};

/// The second walk, and the search for a ray on which a mistake shows.
pub(super) struct Second {
    shown: Option<Arc<Playback>>,
    /// Its picture at the step of last time.
    drawn: Option<Drawn>,
    bench: Bench<(View, Beside), Result<Playback, Failure>>,
    search: Bench<usize, Result<Shows, Cancelled>>,
}

/// A walk beside at a step.
#[derive(Clone)]
pub(super) struct Drawn {
    walk: usize,
    step: usize,
    /// What space shows.
    pub(super) space: Arc<Space>,
    /// What it has cost so far.
    pub(super) cost: Option<Cost>,
}

/// Where a mistake shows.
enum Shows {
    /// On the ray that walks.
    Here,
    /// On a ray of the slide, by its place.
    Ray(usize),
    /// On none of them.
    Elsewhere,
}

impl Broken for Result<Shows, Cancelled> {
    /// The sentence stands on the standard error; it is as if nobody had searched.
    fn broken(_: String) -> Result<Shows, Cancelled> {
        Err(Cancelled)
    }
}

impl Second {
    pub(super) fn new(context: &egui::Context) -> Second {
        Second { shown: None, drawn: None, bench: Bench::new(context.clone()), search: Bench::new(context.clone()) }
    }

    /// The second walk, once it is there.
    pub(super) fn shown(&self) -> Option<&Arc<Playback>> {
        self.shown.as_ref()
    }

    /// A walk beside at a step: folded once, and kept while nothing has moved.
    pub(super) fn at(&mut self, beside: &Arc<Playback>, step: usize) -> Drawn {
        let walk = Arc::as_ptr(beside) as usize;
        if let Some(drawn) = self.drawn.as_ref().filter(|drawn| (drawn.walk, drawn.step) == (walk, step)) {
            return drawn.clone();
        }
        let instant = beside.instant(step);
        let space = Arc::new(beside.reel().still(&instant).space());
        let drawn = Drawn { walk, step, space, cost: cost(&instant) };
        self.drawn = Some(drawn.clone());
        drawn
    }

    /// What is being made.
    pub(super) fn task(&self) -> Option<&Arc<Task>> {
        self.bench.task().or(self.search.task())
    }

    /// Gives up what is being made. Returns whether there was anything.
    pub(super) fn cancel(&mut self) -> bool {
        self.bench.cancel() | self.search.cancel()
    }
}

impl App {
    /// The walk beside, once it is there.
    pub fn beside(&self) -> Option<&Arc<Playback>> {
        self.second.shown()
    }

    /// The step of the walk beside that goes with the step of the walk shown.
    pub(super) fn beside_step(&self, beside: &Playback) -> usize {
        let (step, last) = (self.state.view.step, beside.steps().last());
        match (self.state.pace, self.state.playback()) {
            (Pace::T, Some(playback)) if step > 0 => {
                let at = beside.step_at(playback.reached(step));
                if step == playback.steps().last() { last } else { at }
            }
            _ => step.min(last),
        }
    }

    /// Makes the walk that is shown beside the other, if one is wanted.
    pub(super) fn catch_up_beside(&mut self, ui: &Ui) {
        while let Some((index, Ok(shows))) = self.second.search.collect() {
            self.found(index, &shows);
        }
        self.arrive_beside(ui);
        let beside = self.state.beside;
        let Some(playback) = self.state.playback().filter(|_| beside != Beside::Nothing).cloned() else {
            self.second.shown = None;
            self.second.bench.cancel();
            return;
        };
        let fits = |view: &View, kind: Beside| kind == beside && view.same_walk(&playback.view);
        if self.second.shown.as_ref().is_some_and(|shown| fits(&shown.view, shown.kind))
            || self.second.bench.wanted().is_some_and(|(view, kind)| fits(view, *kind))
        {
            return;
        }
        // A second ray through a structure that stands already only walks.
        let stands = self
            .second
            .shown
            .as_ref()
            .filter(|shown| shown.kind == beside && Arc::ptr_eq(&shown.play.scene, &playback.play.scene));
        let stands = stands.map(|shown| shown.built());
        let prims = playback.play.scene.prims.len();
        let at_once = match (&stands, beside) {
            (Some(built), _) => walks_quickly(&built.structure, prims),
            (None, Beside::Mistake(_)) => walks_quickly(&playback.play.structure, prims),
            (None, _) => builds_quickly(prims),
        };
        self.second.shown.take_if(|_| stands.is_none());
        let task = Task::new("Walking beside", "references");
        let key = (playback.view.clone(), beside);
        self.second.bench.begin(key, task, at_once, move |task| made(&playback, beside, stands, task));
        self.arrive_beside(ui);
    }

    fn arrive_beside(&mut self, ui: &Ui) {
        match self.second.bench.collect() {
            Some((_, Ok(made))) => self.second.shown = Some(Arc::new(made)),
            Some((_, Err(failure))) => {
                self.state.beside = Beside::Nothing;
                if let Failure::Wrong(sentence) = failure {
                    self.toasts.say(ui, sentence);
                }
            }
            None => {}
        }
    }

    /// Shows a mistake beside the walk, on a ray where it shows; or none.
    pub(super) fn break_it(&mut self, ui: &Ui, mistake: Option<usize>) {
        self.state.beside = Beside::Nothing;
        self.second.search.cancel();
        let (Some(index), Some(playback)) = (mistake, self.state.playback().cloned()) else { return };
        let Some(mistake) = playback.mistakes.get(index) else {
            self.toasts.say(ui, "There is nothing to break in this structure.");
            return;
        };
        self.toasts.say(ui, mistake.consequence());
        let elsewhere = playback.view.is_elsewhere();
        let rays: Vec<Ray> = match self.state.stage() {
            Some(stage) if !elsewhere => stage.rays.iter().map(|named| named.ray).collect(),
            _ => Vec::new(),
        };
        let quick = walks_quickly(&playback.play.structure, playback.play.scene.prims.len());
        let task = Task::new("Looking for a ray that shows it", "");
        self.second.search.begin(index, task, quick, move |task| search(&playback, index, &rays, task));
        self.catch_up_beside(ui);
    }

    fn found(&mut self, index: usize, shows: &Shows) {
        let mistake = self.state.playback().and_then(|playback| playback.mistakes.get(index).copied());
        match (shows, mistake) {
            (Shows::Here, _) => {}
            (Shows::Ray(ray), _) => self.state.show_ray(RayChoice::Named(*ray), false),
            (Shows::Elsewhere, Some(mistake)) => self.state.show_example(mistake),
            (Shows::Elsewhere, None) => return,
        }
        self.state.beside = Beside::Mistake(index);
    }
}

/// The walk beside.
fn made(playback: &Playback, beside: Beside, stands: Option<Built>, task: &Task) -> Result<Playback, Failure> {
    match beside {
        Beside::Mistake(index) => {
            let wrong = || Failure::Wrong("There is nothing to break in this structure.".to_owned());
            playback.mistaken(index).ok_or_else(wrong)
        }
        Beside::Nothing => Err(Failure::Cancelled),
        Beside::Structure(kind) => {
            let built = match stands {
                Some(built) => built,
                None => {
                    let rule = Rule::default_for(kind).map_err(|error| Failure::Wrong(error.to_string()))?;
                    let scene = playback.play.scene.clone();
                    let rule = if scene.flat { rule.flat() } else { rule };
                    build(scene, rule, Plays::Walk, task)?
                }
            };
            let none = || Failure::Wrong("A build has no ray to compare: go to a slide on which one walks.".to_owned());
            playback.through(built).ok_or_else(none)
        }
    }
}

/// Where a mistake shows: on the ray that walks, on another of these, or on none.
fn search(playback: &Playback, index: usize, rays: &[Ray], task: &Task) -> Result<Shows, Cancelled> {
    if playback.play.tape.ray().is_some_and(|ray| playback.shows(index, &ray)) {
        return Ok(Shows::Here);
    }
    for (ray, named) in rays.iter().enumerate() {
        if task.is_stopped() {
            return Err(Cancelled);
        }
        if playback.shows(index, named) {
            return Ok(Shows::Ray(ray));
        }
    }
    Ok(Shows::Elsewhere)
}
