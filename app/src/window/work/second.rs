//! The walk beside the walk: through another structure, or with a mistake made.

use std::sync::Arc;

use raystep_accel::{Cancelled, Primitives, Ray, Rule};
use raystep_lesson::{Care, Plays};

use super::bench::{Bench, Broken};
use super::making::{Failure, build, builds_quickly, walks_quickly};
use super::task::Task;
use crate::shown::beside::Beside;
use crate::shown::playback::{Built, Playback};
use crate::shown::state::State;
use crate::shown::view::{RayChoice, View};

/// The second walk, and the search for a ray on which a mistake shows.
pub(crate) struct Second {
    shown: Option<Arc<Playback>>,
    bench: Bench<(View, Beside), Result<Playback, Failure>>,
    search: Bench<usize, Result<Shows, Cancelled>>,
    /// Where one was before a mistake led to a ray on which it shows, and where that was.
    led: Option<[View; 2]>,
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
    pub(crate) fn new(context: &egui::Context) -> Second {
        Second { shown: None, bench: Bench::new(context.clone()), search: Bench::new(context.clone()), led: None }
    }

    /// The second walk, once it is there.
    pub(crate) fn shown(&self) -> Option<&Arc<Playback>> {
        self.shown.as_ref()
    }

    /// What is being made.
    pub(crate) fn task(&self) -> Option<&Arc<Task>> {
        self.bench.task().or(self.search.task())
    }

    /// Gives up what is being made. Returns whether there was anything.
    pub(crate) fn cancel(&mut self) -> bool {
        self.bench.cancel() | self.search.cancel()
    }

    /// Makes the walk that is shown beside the other, if one is wanted. Says what went wrong, or what is shown instead of
    /// what was asked for.
    pub(crate) fn catch_up(&mut self, state: &mut State) -> Option<String> {
        let mut instead = None;
        while let Some((index, Ok(shows))) = self.search.collect() {
            let before = state.target().clone();
            instead = found(state, index, &shows);
            let again = self.led.as_ref().is_some_and(|[_, led]| led.same_walk(&before));
            match &mut self.led {
                _ if state.target().same_walk(&before) => {}
                Some([_, led]) if again => *led = state.target().clone(),
                _ => self.led = Some([before, state.target().clone()]),
            }
        }
        self.make(state).or(instead)
    }

    fn make(&mut self, state: &mut State) -> Option<String> {
        let wrong = self.arrive(state);
        // What stands beside another slide is made of that one's walk.
        if state.leaves() {
            return wrong;
        }
        // Only flat scenes are shown more than twice.
        if let (Beside::Abreast(rivals), Some(playback)) = (state.beside, state.playback())
            && !playback.play.scene.flat
        {
            state.compare_all(rivals);
        }
        let beside = state.beside;
        let Some(playback) = state.playback().filter(|_| beside != Beside::Nothing).cloned() else {
            self.shown = None;
            self.bench.cancel();
            return wrong;
        };
        let fits = |view: &View, kind: Beside| kind == beside && view.same_walk(&playback.view);
        if self.shown.as_ref().is_some_and(|shown| fits(&shown.view, shown.kind))
            || self.bench.wanted().is_some_and(|(view, kind)| fits(view, *kind))
        {
            return wrong;
        }
        // A second ray through a structure that stands already only walks.
        let over = |shown: &&Arc<Playback>| {
            // The walks side by side hold the structure that is shown as well.
            let own = Arc::ptr_eq(&shown.play.structure, &playback.play.structure);
            let whole = own || !matches!(beside, Beside::Abreast(_));
            shown.kind == beside && whole && Arc::ptr_eq(&shown.play.scene, &playback.play.scene)
        };
        let stands = self.shown.as_ref().filter(over).map(|shown| shown.built());
        let prims = playback.play.scene.prims.len();
        let at_once = match (&stands, beside) {
            (_, Beside::Abreast(_)) => builds_quickly(prims),
            (Some(built), _) => walks_quickly(&built.structure, prims),
            (None, Beside::Mistake(_)) => walks_quickly(&playback.play.structure, prims),
            (None, _) => builds_quickly(prims),
        };
        self.shown.take_if(|_| stands.is_none());
        let task = Task::new("Walking beside", "references");
        let key = (playback.view.clone(), beside);
        self.bench.begin(key, task, at_once, move |task| made(&playback, beside, stands, task));
        self.arrive(state)
    }

    /// Takes the walk that was made. Says what went wrong.
    fn arrive(&mut self, state: &mut State) -> Option<String> {
        match self.bench.collect()? {
            (_, Ok(made)) => {
                self.shown = Some(Arc::new(made));
                None
            }
            (_, Err(failure)) => {
                state.beside = Beside::Nothing;
                match failure {
                    Failure::Wrong(sentence) => Some(sentence),
                    Failure::Cancelled => None,
                }
            }
        }
    }

    /// Looks for a ray on which a mistake shows, to show it beside the walk; or shows none. Says what to expect.
    pub(crate) fn break_it(&mut self, state: &mut State, mistake: Option<usize>) -> Option<String> {
        let broken = matches!(std::mem::replace(&mut state.beside, Beside::Nothing), Beside::Mistake(_));
        self.search.cancel();
        let Some(index) = mistake else {
            // Back to the ray from which the mistake led here.
            let led = self.led.take().filter(|[_, led]| broken && led.same_walk(state.target()));
            if let Some([before, _]) = led {
                state.return_to(before);
            }
            return None;
        };
        let playback = state.playback()?.clone();
        let Some(mistake) = playback.mistakes.get(index) else {
            return Some("There is nothing to break in this structure.".to_owned());
        };
        let consequence = mistake.consequence().to_owned();
        let elsewhere = playback.view.is_elsewhere();
        let rays: Vec<Ray> = match state.stage() {
            Some(stage) if !elsewhere => stage.rays.iter().map(|named| named.ray).collect(),
            _ => Vec::new(),
        };
        let quick = walks_quickly(&playback.play.structure, playback.play.scene.prims.len());
        let task = Task::new("Looking for a ray that shows it", "");
        self.search.begin(index, task, quick, move |task| search(&playback, index, &rays, task));
        Some(consequence)
    }
}

/// Goes to where a mistake shows. Says so where that is not on the user's own ray.
fn found(state: &mut State, index: usize, shows: &Shows) -> Option<String> {
    let own = matches!(state.view.ray, RayChoice::Own(_));
    let named = |ray: usize| state.stage()?.rays.get(ray).map(|ray| ray.name.clone());
    let instead = match shows {
        Shows::Ray(ray) if own => named(*ray).map(|name| {
            format!("Your own ray does not show it; \u{201c}{name}\u{201d} does. Ctrl+Z goes back to your own.")
        }),
        _ => None,
    };
    let mistake = state.playback().and_then(|playback| playback.mistakes.get(index).copied());
    match (shows, mistake) {
        (Shows::Here, _) => {}
        (Shows::Ray(ray), _) => state.show_ray(RayChoice::Named(*ray), false),
        (Shows::Elsewhere, Some(mistake)) => state.show_example(mistake),
        (Shows::Elsewhere, None) => return None,
    }
    state.beside = Beside::Mistake(index);
    instead
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
                None => usual(playback, kind, task)?,
            };
            playback.through(built).ok_or_else(|| no_ray(playback))
        }
        Beside::Abreast(_) if playback.play.tape.plays() == Plays::Packet => Err(Failure::Wrong(
            "A packet is compared with one structure at a time: choose one kd-tree, BSP tree or hierarchy.".to_owned(),
        )),
        Beside::Abreast(rivals) => {
            let made = match stands {
                Some(built) => playback.abreast_of(built, rivals),
                None => {
                    let others: Result<Vec<Built>, Failure> =
                        rivals.kinds().map(|kind| usual(playback, kind, task)).collect();
                    playback.abreast(others?, rivals)
                }
            };
            made.ok_or_else(|| no_ray(playback))
        }
    }
}

/// A structure of this kind over the same scene, with the usual parameters.
fn usual(playback: &Playback, kind: &str, task: &Task) -> Result<Built, Failure> {
    let rule = Rule::default_for(kind).map_err(|error| Failure::Wrong(error.to_string()))?;
    let scene = playback.play.scene.clone();
    let rule = if scene.flat { rule.flat() } else { rule };
    build(scene, rule, Plays::Walk, None, Care::Full, task)
}

fn no_ray(playback: &Playback) -> Failure {
    let why = match playback.play.tape.plays() {
        Plays::Packet => "Packets walk kd-trees, BSP trees and hierarchies of volumes: compare with one of these.",
        _ => "No ray walks here that could be compared: go to a slide on which one does.",
    };
    Failure::Wrong(why.to_owned())
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
