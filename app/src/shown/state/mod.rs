//! The window's state: pure data that commands change. It knows no widget, file or clock.

mod answering;
mod choosing;
mod comparing;
#[cfg(test)]
mod given_away;
mod heat;
mod held;
mod lecturing;
mod linking;
mod looking;
mod stepping;
mod undoing;
mod wanting;

use std::collections::HashMap;
use std::sync::Arc;

use raystep_accel::{Grain, Interval, NodeId, Place};
use raystep_fast::FastKind;
use raystep_figure::{Camera, Depth};
use raystep_lesson::{Column, Library, Slide, Stage, StageKind};

use super::beside::{Beside, Pace, Rivals};
use super::command::{Command, QUARTERS};
use super::history::History;
use super::lecture::Lecture;
use super::playback::Playback;
use super::steps::coarser;
use super::view::View;

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
    /// Whether a slide was led to its solid stage for the heat map alone.
    led_to_heat: bool,
    /// Where one was on the stage that was left for the slide's other one.
    other_stage: Option<View>,
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
    /// What was asked and answered at the step that is wanted.
    asked: Asked,
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

/// What has been asked and answered at a step.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Asked {
    /// Whether the question that waits behind the beat has been called for.
    pub open: bool,
    /// The places of the last answers: a wrong one, and the one after it.
    pub answers: Vec<usize>,
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
            led_to_heat: false,
            other_stage: None,
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
            asked: Asked::default(),
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
