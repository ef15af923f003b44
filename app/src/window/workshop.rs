//! Where structures are built and rays walk: small ones at once, large ones beside the UI thread.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};

use raystep_accel::{Cancelled, Grow, Observer, Primitives, Ray, Rule};
use raystep_lesson::{BuildTape, Library, Plays, Slide, Stage};
use raystep_scene::Scene;

use super::playback::{Built, Playback};
use super::view::{RayChoice, View};

/// Scenes with at most so many primitives are built at once.
const SMALL: usize = 512;
/// Structures over at most so many primitives are walked at once.
const SHORT: usize = 50_000;

/// A view to be made into a walk.
struct Order {
    view: View,
    library: Arc<Library>,
    built: Option<Built>,
    stop: Arc<Progress>,
}

/// How far a builder is, and whether it should give up.
#[derive(Debug, Default)]
pub(super) struct Progress {
    cancelled: AtomicBool,
    done: AtomicU32,
}

/// What a worker sends back.
struct Answer {
    view: View,
    made: Result<Playback, Failure>,
}

/// Why there is no walk.
#[derive(Clone, Debug, PartialEq)]
enum Failure {
    Cancelled,
    Wrong(String),
}

/// Makes walks of views.
pub(super) struct Workshop {
    context: egui::Context,
    sender: Sender<Answer>,
    answers: Receiver<Answer>,
    underway: Option<(View, Arc<Progress>)>,
    kept: Vec<Built>,
}

/// What came of the view that was asked for.
pub(super) enum Came {
    /// A walk.
    Walk(Box<Playback>),
    /// It was given up.
    Cancelled,
    /// It cannot be made: a sentence.
    Wrong(String),
}

impl Workshop {
    pub(super) fn new(context: egui::Context) -> Workshop {
        let (sender, answers) = channel();
        Workshop { context, sender, answers, underway: None, kept: Vec::new() }
    }

    /// Asks for the walk of a view. It may be there at once; else it arrives some frames later.
    pub(super) fn ask(&mut self, view: &View, library: &Arc<Library>) -> Option<Came> {
        if self.underway.as_ref().is_some_and(|(wanted, _)| wanted.same_walk(view)) {
            return None;
        }
        self.cancel();
        let built = self.kept.iter().find(|built| fits(built, view, library)).cloned();
        let progress = Arc::new(Progress::default());
        let order = Order { view: view.clone(), library: library.clone(), built, stop: progress.clone() };
        if is_quick(&order) {
            let made = make(order);
            return Some(self.came(made));
        }
        self.underway = Some((view.clone(), progress));
        let (sender, context) = (self.sender.clone(), self.context.clone());
        std::thread::spawn(move || {
            let view = order.view.clone();
            let made = make(order);
            // The window may be gone; nobody waits then.
            let _ = sender.send(Answer { view, made });
            context.request_repaint();
        });
        None
    }

    /// What has arrived since the last call.
    pub(super) fn collect(&mut self) -> Option<Came> {
        let answer = self.answers.try_recv().ok()?;
        let wanted = self.underway.take_if(|(view, _)| view.same_walk(&answer.view));
        if wanted.is_none() && answer.made.is_err() {
            return None;
        }
        Some(self.came(answer.made))
    }

    /// What is being made, as the part of it that is done.
    pub(super) fn progress(&self) -> Option<u32> {
        self.underway.as_ref().map(|(_, progress)| progress.done.load(Ordering::Relaxed))
    }

    /// Gives up what is being made. Returns whether there was anything.
    pub(super) fn cancel(&mut self) -> bool {
        let underway = self.underway.take();
        if let Some((_, progress)) = &underway {
            progress.cancelled.store(true, Ordering::Relaxed);
        }
        underway.is_some()
    }

    fn came(&mut self, made: Result<Playback, Failure>) -> Came {
        match made {
            Ok(playback) => {
                let built = Built {
                    scene: playback.play.scene.clone(),
                    rule: playback.rule,
                    structure: playback.play.structure.clone(),
                    node_bounds: playback.node_bounds.clone(),
                    growth: playback.play.tape.growth(),
                };
                self.kept.retain(|kept| !same(kept, &built));
                self.kept.insert(0, built);
                self.kept.truncate(8);
                Came::Walk(Box::new(playback))
            }
            Err(Failure::Cancelled) => Came::Cancelled,
            Err(Failure::Wrong(sentence)) => Came::Wrong(sentence),
        }
    }
}

/// The ray that a view asks for; a build needs none.
pub(super) fn ray_of(view: &View, slide: &Slide, stage: &Stage) -> Result<Option<Ray>, String> {
    match (&view.ray, slide.plays) {
        (_, Plays::Build) => Ok(None),
        (RayChoice::Own(ray), _) => Ok(Some(*ray)),
        (RayChoice::Named(index), _) => {
            let named = stage.rays.get(*index).ok_or("The slide has no such ray.")?;
            Ok(Some(named.ray))
        }
    }
}

/// The rule that a view asks for, over a scene that is flat or not.
pub(super) fn rule_of(view: &View, stage: &Stage, flat: bool) -> Result<Rule, String> {
    let mut rule = stage.plan.rule(flat).map_err(|error| error.to_string())?;
    for (key, value) in &view.settings {
        rule.set(key, value).map_err(|error| error.to_string())?;
    }
    Ok(rule)
}

/// Whether the making takes less time than a frame.
fn is_quick(order: &Order) -> bool {
    let flat = |stage: &Stage| stage.scene.starts_with("flat");
    match (&order.built, &order.view.mesh) {
        (Some(built), _) => built.scene.prims.len() <= SHORT,
        (None, Some(mesh)) => mesh.prims.len() <= SMALL,
        (None, None) => order.stage().is_none_or(flat),
    }
}

impl Order {
    fn stage(&self) -> Option<&Stage> {
        let slide = self.library.slides.get(self.view.slide)?;
        slide.stage(self.view.stage).or(slide.stages.first())
    }
}

fn make(order: Order) -> Result<Playback, Failure> {
    let wrong = |sentence: String| Failure::Wrong(sentence);
    let library = order.library.clone();
    let slide = library.slides.get(order.view.slide).ok_or_else(|| wrong("There is no such slide.".to_owned()))?;
    let stage = order.stage().cloned().ok_or_else(|| wrong("The slide has no stage.".to_owned()))?;
    let ray = ray_of(&order.view, slide, &stage).map_err(wrong)?;
    let built = match &order.built {
        Some(built) => built.clone(),
        None => {
            let scene = match &order.view.mesh {
                Some(mesh) => mesh.clone(),
                None => Arc::new(Scene::named(&stage.scene).map_err(|error| wrong(error.to_string()))?),
            };
            let rule = rule_of(&order.view, &stage, scene.flat).map_err(wrong)?;
            let mut watch = Watch(&order.stop);
            let (structure, growth) =
                BuildTape::record(slide.plays, &scene, &rule, &mut watch).map_err(|Cancelled| Failure::Cancelled)?;
            let node_bounds = Arc::new(structure.node_bounds());
            Built { scene, rule, structure: Arc::new(structure), node_bounds, growth }
        }
    };
    if order.stop.cancelled.load(Ordering::Relaxed) {
        return Err(Failure::Cancelled);
    }
    Playback::new(order.view, built, ray, slide, &stage).ok_or_else(|| wrong("The slide has no ray.".to_owned()))
}

/// Counts what a builder has settled and asks it to give up.
struct Watch<'a>(&'a Progress);

impl Observer<Grow> for Watch<'_> {
    fn on(&mut self, event: Grow) {
        if let Grow::Settle { .. } = event {
            self.0.done.fetch_add(1, Ordering::Relaxed);
        }
    }

    fn cancelled(&self) -> bool {
        self.0.cancelled.load(Ordering::Relaxed)
    }
}

/// Whether a kept structure is the one that a view asks for.
fn fits(built: &Built, view: &View, library: &Library) -> bool {
    let Some(slide) = library.slides.get(view.slide) else { return false };
    let Some(stage) = slide.stage(view.stage).or(slide.stages.first()) else { return false };
    // How it was built is kept only where it is played.
    if built.growth.is_some() != (slide.plays == Plays::Build) {
        return false;
    }
    let same_scene = match &view.mesh {
        Some(mesh) => Arc::ptr_eq(mesh, &built.scene),
        None => built.scene.name == stage.scene,
    };
    same_scene && rule_of(view, stage, built.scene.flat).is_ok_and(|rule| rule == built.rule)
}

fn same(a: &Built, b: &Built) -> bool {
    a.rule == b.rule
        && a.growth.is_some() == b.growth.is_some()
        && (Arc::ptr_eq(&a.scene, &b.scene) || a.scene.name == b.scene.name)
}
