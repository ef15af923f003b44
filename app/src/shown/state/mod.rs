//! The window's state: pure data that commands change. It knows no widget, file or clock.

mod answering;
#[cfg(test)]
mod given_away;
mod heat;
mod held;
mod lecturing;
mod linking;
mod stepping;
mod wanting;

use std::collections::HashMap;
use std::sync::Arc;

use raystep_accel::{Grain, Interval, Mistake, NodeId, Place, Rule};
use raystep_fast::FastKind;
use raystep_figure::{Camera, Depth};
use raystep_lesson::{Act, Column, Library, Slide, Stage, StageKind};
use raystep_scene::Scene;

use super::beside::{Beside, Pace, Rivals};
use super::command::{Command, QUARTERS};
use super::history::History;
use super::lecture::Lecture;
use super::playback::Playback;
use super::steps::coarser;
use super::view::{RayChoice, View};

/// Everything that a command can change.
#[derive(Clone, Debug)]
pub struct State {
    /// All slides.
    pub library: Arc<Library>,
    /// What is shown: always a step of the walk that is there.
    pub view: View,
    /// Where playing and the arrow keys stop.
    pub grain: Grain,
    /// How fast playing is, in quarters of the usual speed: 1 to 36.
    pub speed: u8,
    /// Whether the walk plays by itself.
    pub playing: bool,
    /// Whether questions are asked before the step that answers them.
    pub predict: bool,
    /// Whether it is shown how one step becomes the next.
    pub motion: bool,
    /// Whether the next step waits at an open question.
    pub locked: bool,
    /// What is shown beside the walk.
    pub beside: Beside,
    /// The structures that are compared with when nothing else is said; of a solid scene the first one.
    rivals: Rivals,
    /// How the walk beside keeps in step.
    pub pace: Pace,
    /// What a heat map counts that is shown instead of space, where space is solid.
    heat: Option<Column>,
    /// Which structure at full speed a heat map shows beside, where the scene is made of triangles.
    pub quick: Option<FastKind>,
    /// Whether what can be set by hand stands below the lesson.
    pub by_hand: bool,
    /// Whether the presenter's page is shown.
    pub present: bool,
    /// What is set for the class, while it is.
    pub lecture: Lecture,
    /// Whether the question that waits behind the beat of this step has been called for.
    asking: bool,
    /// The answer given to the question that is open, or was just answered.
    pub answered: Option<Answered>,
    /// The place that was clicked on last; it stays lit.
    pub picked: Option<Place>,
    playback: Option<Arc<Playback>>,
    /// The build with a cut that is tried weighed at this step.
    trial: Option<Arc<Playback>>,
    /// Where a change that is under way began: its walks stand at the same decision, as far as they come to it.
    anchor: Option<(Arc<Playback>, usize)>,
    /// What shall be shown instead, as soon as its walk is there.
    wanted: Option<View>,
    landing: Landing,
    history: History,
    /// Where one was on the slides that were left, by their places.
    left: HashMap<usize, View>,
    /// What was shown until lessons were read again, while nothing of them is shown.
    before: Option<Before>,
    waited: f32,
    /// The kind of stage that was asked for: on it slides open that do not say on which.
    wished: StageKind,
}

/// What was shown, whole.
#[derive(Clone, Debug)]
struct Before {
    library: Arc<Library>,
    view: View,
    playback: Arc<Playback>,
}

/// An answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Answered {
    /// The beat that asked.
    pub beat: usize,
    /// The place of the chosen answer.
    pub choice: usize,
    /// Whether it was right.
    pub right: bool,
    /// The wrong answer that was given before it.
    pub before: Option<usize>,
}

impl Answered {
    /// The wrong answer that was given last.
    pub fn wrong(&self) -> Option<usize> {
        if self.right { self.before } else { Some(self.choice) }
    }
}

/// Everything that decides what a frame looks like.
#[derive(PartialEq)]
pub(crate) struct Stamp {
    walk: Option<*const Playback>,
    step: usize,
    look: (Option<Camera>, Option<Depth>, Option<Interval>),
    waits: bool,
    beside: (Beside, Pace),
    modes: [bool; 5],
    lecture: Lecture,
    heat: Option<(Column, Option<FastKind>)>,
    answered: Option<Answered>,
}

/// Where to stand in a walk that has just been made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Landing {
    /// At its first decision.
    Opening,
    /// At the decision of before; else at the step of before, as far as the walk goes.
    Keep,
    /// At the step that its view names.
    Named,
    /// Where this node is divided.
    Split(NodeId),
    /// Where something is said for the last time.
    LastBeat,
}

impl State {
    /// The first slide, or the one asked for.
    pub fn new(library: Arc<Library>, slide: usize) -> State {
        let slide = slide.min(library.slides.len().saturating_sub(1));
        let wished = StageKind::Flat;
        let view = View::of_slide(slide, opening_stage(&library, slide, wished));
        State {
            library,
            wanted: Some(view.clone()),
            view,
            grain: Grain::Decision,
            speed: QUARTERS,
            playing: false,
            predict: true,
            motion: false,
            locked: false,
            beside: Beside::Nothing,
            rivals: Rivals::of(["list"]),
            pace: Pace::Event,
            heat: None,
            quick: None,
            by_hand: false,
            present: false,
            lecture: Lecture::default(),
            asking: false,
            answered: None,
            picked: None,
            playback: None,
            trial: None,
            anchor: None,
            landing: Landing::Opening,
            history: History::default(),
            left: HashMap::new(),
            before: None,
            waited: 0.0,
            wished,
        }
    }

    /// The slide shown; nothing when the library is empty.
    pub fn slide(&self) -> Option<&Slide> {
        self.library.slides.get(self.view.slide)
    }

    /// The stage shown.
    pub fn stage(&self) -> Option<&Stage> {
        let slide = self.slide()?;
        slide.stage(self.view.stage).or(slide.stages.first())
    }

    /// The walk shown, once it is there.
    pub fn playback(&self) -> Option<&Arc<Playback>> {
        self.trial.as_ref().or(self.playback.as_ref())
    }

    /// The walk shown, without what is only tried in it.
    pub fn made(&self) -> Option<&Arc<Playback>> {
        self.playback.as_ref()
    }

    /// What a frame that is drawn now shows.
    pub(crate) fn stamp(&self) -> Stamp {
        Stamp {
            walk: self.playback().map(Arc::as_ptr),
            step: self.view.step,
            look: (self.view.camera, self.view.depth, self.view.part),
            waits: self.wanted.is_some(),
            beside: (self.beside, self.pace),
            modes: [self.playing, self.predict, self.locked, self.present, self.asking],
            lecture: self.lecture.clone(),
            heat: self.heat.map(|of| (of, self.quick)),
            answered: self.answered,
        }
    }

    /// Does what a command says; those that concern the window itself change nothing here.
    pub fn apply(&mut self, command: Command) {
        if self.present && self.lecture(command) {
            return;
        }
        match command {
            Command::Play => {
                self.playing = !self.playing;
                self.waited = 0.0;
                if self.playing && self.playback.as_ref().is_some_and(|p| self.view.step == p.steps().last()) {
                    self.go(0);
                    self.playing = true;
                }
            }
            Command::Next => self.forward(self.grain),
            Command::NextCoarse => self.forward(coarser(self.grain)),
            Command::Previous => self.back(self.grain),
            Command::PreviousCoarse => self.back(coarser(self.grain)),
            Command::First => self.go(0),
            Command::Last => self.go(usize::MAX),
            Command::Onward => self.onward(),
            Command::Backward => self.backward(),
            Command::NextSlide => self.show_slide(self.target().slide + 1),
            Command::PreviousSlide => self.show_slide(self.target().slide.wrapping_sub(1)),
            Command::Speed(speed) => self.speed = speed.clamp(1, 9 * QUARTERS),
            Command::Grain(grain) => self.grain = grain,
            Command::Predict => {
                self.predict = !self.predict;
                self.answered = None;
            }
            Command::Answer(choice) => self.answer(usize::from(choice)),
            Command::Offer(offer) => self.take_up(usize::from(offer)),
            Command::Skip => self.skip(),
            Command::Lock => self.locked = !self.locked,
            Command::Motion => self.motion = !self.motion,
            Command::Restore => self.restore(),
            Command::Undo => self.undo(),
            Command::Redo => self.redo(),
            Command::Flat => self.show_stage(StageKind::Flat),
            Command::Solid => self.show_stage(StageKind::Solid),
            Command::OtherStage => self.turn_stage(),
            Command::NextRay => self.turn_ray(false),
            Command::PreviousRay => self.turn_ray(true),
            Command::Compare => {
                let on = matches!(self.beside, Beside::Structure(_) | Beside::Abreast(_));
                self.compare_all(if on { Rivals::default() } else { self.rivals });
            }
            Command::Heat => self.toggle_heat(),
            Command::ByHand => self.by_hand = !self.by_hand,
            Command::Present => self.present(),
            Command::Speaker => self.speak(),
            Command::ResetCamera => self.look(None),
            Command::Deeper => self.step_depth(true),
            Command::Shallower => self.step_depth(false),
            Command::WholeRay if self.view.part.is_some() => {
                self.keep();
                self.show_part(None);
            }
            Command::ResetScene => self.reset_scene(),
            Command::CutHere => self.cut_here(),
            _ => {}
        }
    }

    /// To another slide.
    pub fn show_slide(&mut self, slide: usize) {
        if slide >= self.library.slides.len() || slide == self.target().slide {
            return;
        }
        self.leave();
        let stage = opening_stage(&self.library, slide, self.wished);
        self.want(View::of_slide(slide, stage), Landing::Opening);
    }

    /// What is shown is left for another slide.
    fn leave(&mut self) {
        self.keep();
        self.left.insert(self.view.slide, self.view.clone());
        self.beside = Beside::Nothing;
        self.heat = None;
    }

    /// To the slide's other stage.
    pub fn show_stage(&mut self, stage: StageKind) {
        let View { slide, stage: now, .. } = *self.target();
        let offered = self.library.slides.get(slide).is_some_and(|slide| slide.stage(stage).is_some());
        if offered && stage != now {
            self.wished = stage;
            self.heat = None;
            self.keep();
            self.want(View::of_slide(slide, stage), Landing::Opening);
        }
    }

    /// Another ray; `drag` says that it belongs to a change that is under way.
    pub fn show_ray(&mut self, ray: RayChoice, drag: bool) {
        if ray == self.target().ray {
            return;
        }
        if !drag {
            self.keep();
        }
        let landing = if matches!(ray, RayChoice::Named(_)) { Landing::Opening } else { Landing::Keep };
        self.want(View { ray, part: None, ..self.target().clone() }, landing);
    }

    /// The ray of that name, on whichever stage it walks.
    pub fn show_named_ray(&mut self, name: &str) {
        let index = |stage: &Stage| stage.rays.iter().position(|ray| ray.name == name);
        let Some(slide) = self.slide() else { return };
        let mut stages = self.stage().into_iter().chain(&slide.stages);
        let found = stages.find_map(|stage| Some((stage.kind, index(stage)?)));
        if let Some((stage, ray)) = found {
            self.show_stage(stage);
            self.show_ray(RayChoice::Named(ray), true);
        }
    }

    /// How the structure is built that is shown, or asked for over the same scene.
    pub fn rule(&self) -> Option<Rule> {
        let mut rule = self.playback.as_ref()?.rule;
        let target = self.target();
        if target.same_scene(&self.view) {
            for (key, value) in &target.settings {
                // What cannot be set is said when the structure is built.
                let _ = rule.set(key, value);
            }
        }
        Some(rule)
    }

    /// A parameter of the structure, as part of a change that is under way.
    pub fn set(&mut self, key: &str, value: &str) {
        self.set_and_stand(key, value, Landing::Keep);
    }

    fn set_and_stand(&mut self, key: &str, value: &str, landing: Landing) {
        let mut view = self.target().clone();
        view.settings.retain(|(known, _)| known != key);
        view.settings.push((key.to_owned(), value.to_owned()));
        self.want(view, landing);
    }

    /// Does what the beat offers, if it does.
    fn take_up(&mut self, offer: usize) {
        let Some(act) = self.offers().get(offer).map(|offer| offer.act.clone()) else { return };
        match act {
            Act::Set(settings) => {
                // Several parameters are one change.
                self.keep();
                for (key, value) in &settings {
                    self.set(key, value);
                }
            }
            Act::Compare(kind) => self.compare(kind),
            // It stands over the page, which is no matter of what is shown.
            Act::Best => {}
            Act::Slide(id) => {
                let slide = self.library.slide(&id).map(|slide| &slide.file);
                let index = self.library.slides.iter().position(|other| Some(&other.file) == slide);
                if let Some(index) = index {
                    self.show_slide(index);
                }
            }
        }
    }

    /// Whether what a beat offers with this number is to measure all structures.
    pub fn offers_best(&self, offer: u8) -> bool {
        self.offers().get(usize::from(offer)).is_some_and(|offer| offer.act == Act::Best)
    }

    /// A mesh instead of the slide's scene, with a ray through it.
    pub fn show_mesh(&mut self, mesh: Arc<Scene>, ray: raystep_accel::Ray) {
        self.keep();
        let (stage, ray) = (StageKind::Solid, RayChoice::Own(ray));
        let (mesh, own, camera, part) = (Some(mesh), None, None, None);
        let view = View { stage, ray, mesh, own, example: None, camera, part, ..self.target().clone() };
        self.want(view, Landing::Opening);
    }

    /// The small scene and the ray on which a mistake shows.
    pub fn show_example(&mut self, mistake: Mistake) {
        self.keep();
        let view = View::of_slide(self.view.slide, self.view.stage);
        let ray = RayChoice::Own(mistake.example().ray);
        self.want(View { ray, example: Some(mistake), ..view }, Landing::Opening);
    }

    /// Another structure beside the walk.
    pub fn compare(&mut self, kind: &'static str) {
        self.compare_all(Rivals::of([kind]));
    }

    /// Other structures beside the walk: in a flat scene all of them, in a solid one the first.
    pub fn compare_all(&mut self, rivals: Rivals) {
        // A packet is compared with one structure at a time.
        let flat = self.playback.as_ref().is_none_or(|playback| {
            playback.play.scene.flat && playback.play.tape.plays() != raystep_lesson::Plays::Packet
        });
        self.beside = match rivals.kinds().next() {
            None => Beside::Nothing,
            Some(first) => {
                self.rivals = rivals;
                if rivals.count() > 1 && flat { Beside::Abreast(rivals) } else { Beside::Structure(first) }
            }
        };
    }

    /// Another place to look from, as part of a change that is under way.
    pub fn turn(&mut self, camera: Camera) {
        self.see(Some(camera));
    }

    /// Another place to look from; nothing for the slide's own.
    pub fn look(&mut self, camera: Option<Camera>) {
        if camera != self.view.camera {
            self.keep();
            self.see(camera);
        }
    }

    fn see(&mut self, camera: Option<Camera>) {
        self.change_look(|view| view.camera = camera);
    }

    /// How many boxes of a tree are drawn in space.
    pub fn depth(&self) -> Depth {
        let own = self.stage().and_then(|stage| stage.levels).map_or(Depth::Path, Depth::Down);
        self.view.depth.unwrap_or(own)
    }

    /// So many boxes of a tree in space, as part of a change that is under way.
    pub fn show_depth(&mut self, depth: Depth) {
        self.change_look(|view| view.depth = Some(depth));
    }

    /// The boxes of one level more, or of one less; above the first there is the path alone.
    fn step_depth(&mut self, deeper: bool) {
        let Some(deepest) = self.playback.as_ref().and_then(|playback| playback.reel().deepest()) else { return };
        let now = match self.depth() {
            Depth::Path => 0,
            Depth::Down(level) => level.min(deepest),
        };
        let level = if deeper { (now + 1).min(deepest) } else { now.saturating_sub(1) };
        if level != now {
            self.keep();
            self.show_depth(if level == 0 { Depth::Path } else { Depth::Down(level) });
        }
    }

    /// A part of the ray on the ruler, or all of it; as part of a change that is under way.
    pub fn show_part(&mut self, part: Option<Interval>) {
        self.change_look(|view| view.part = part);
    }

    /// Changes how what is shown, and what shall be shown of the same scene, is looked at.
    fn change_look(&mut self, change: impl Fn(&mut View)) {
        change(&mut self.view);
        if let Some(wanted) = &mut self.wanted
            && wanted.same_scene(&self.view)
        {
            change(wanted);
        }
    }

    /// Remembers the view before a change that undo shall take back in one.
    pub fn keep(&mut self) {
        self.anchor = None;
        // What was asked for last counts, also where its walk is not there yet.
        self.history.keep((self.wanted.as_ref().unwrap_or(&self.view), self.opens()));
    }

    /// Whether there is something to undo, and to redo.
    pub fn undoable(&self) -> (bool, bool) {
        self.history.available()
    }

    fn restore(&mut self) {
        let View { slide, stage, .. } = *self.target();
        let own = View::of_slide(slide, first_stage(&self.library, slide, stage));
        if !own.same_walk(self.target()) {
            self.keep();
            self.want(own, Landing::Opening);
        } else if !self.view.looks_its_own() {
            self.keep();
            self.change_look(|view| *view = view.clone().looking_as(&own));
        }
        (self.view.tried, self.trial) = (None, None);
        self.beside = Beside::Nothing;
        self.heat = None;
    }

    /// Whether what is wanted is to open where its slide does, and does not stand there yet.
    fn opens(&self) -> bool {
        self.wanted.is_some() && self.landing == Landing::Opening
    }

    fn undo(&mut self) {
        let now = (self.target().clone(), self.opens());
        if let Some((view, opens)) = self.history.undo(now) {
            self.want(view, if opens { Landing::Opening } else { Landing::Named });
        }
    }

    fn redo(&mut self) {
        let now = (self.target().clone(), self.opens());
        if let Some((view, opens)) = self.history.redo(now) {
            self.want(view, if opens { Landing::Opening } else { Landing::Named });
        }
    }
}

/// The stage a slide opens on: the one that it says, else the wished one if it has it.
fn opening_stage(library: &Library, slide: usize, wished: StageKind) -> StageKind {
    let stage = library.slides.get(slide).and_then(|slide| slide.opening_stage(wished));
    stage.map_or(StageKind::Flat, |stage| stage.kind)
}

/// The wanted stage if the slide has it, else its first.
fn first_stage(library: &Library, slide: usize, wanted: StageKind) -> StageKind {
    let stages = library.slides.get(slide).map_or(&[][..], |slide| slide.stages.as_slice());
    let wanted = stages.iter().find(|stage| stage.kind == wanted);
    wanted.or(stages.first()).map_or(StageKind::Flat, |stage| stage.kind)
}
