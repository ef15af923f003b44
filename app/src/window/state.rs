//! The window's state: pure data that commands change. It knows no widget, file or clock.

mod answering;
mod stepping;

use std::sync::Arc;

use raystep_accel::{Grain, Mistake};
use raystep_figure::Camera;
use raystep_lesson::{Library, Slide, Stage, StageKind};
use raystep_scene::Scene;

use super::command::Command;
use super::history::History;
use super::playback::Playback;
use super::steps::coarser;
use super::view::{RayChoice, View};

/// Everything that a command can change.
#[derive(Clone, Debug)]
pub struct State {
    /// All slides.
    pub library: Arc<Library>,
    /// What is shown.
    pub view: View,
    /// Where playing and the arrow keys stop.
    pub grain: Grain,
    /// How many times as fast playing is, 1 to 9.
    pub speed: u8,
    /// Whether the walk plays by itself.
    pub playing: bool,
    /// Whether questions are asked before the step that answers them.
    pub predict: bool,
    /// Whether the next step waits at an open question.
    pub locked: bool,
    /// What is shown beside the walk.
    pub beside: Beside,
    /// The structure that is compared with when nothing else is said.
    pub rival: &'static str,
    /// How the walk beside keeps in step.
    pub pace: Pace,
    /// Whether the presenter's page is shown.
    pub present: bool,
    /// The answer given to the question that is open, or was just answered.
    pub answered: Option<Answered>,
    playback: Option<Arc<Playback>>,
    landing: Landing,
    history: History,
    waited: f32,
}

/// What a second picture of space shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Beside {
    /// There is none.
    Nothing,
    /// The same ray through another structure: its kind.
    Structure(&'static str),
    /// The mistake with this place in the list of those that fit the structure.
    Mistake(usize),
}

/// How two walks keep in step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pace {
    /// Both have taken so many steps.
    Event,
    /// Both have come so far along the ray.
    T,
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
}

/// Where to stand in a walk that has just been made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Landing {
    /// At its first decision.
    Opening,
    /// At the step of before, as far as the walk goes.
    Keep,
}

impl State {
    /// The first slide, or the one asked for.
    pub fn new(library: Arc<Library>, slide: usize) -> State {
        let slide = slide.min(library.slides.len().saturating_sub(1));
        let stage = first_stage(&library, slide, StageKind::Flat);
        State {
            library,
            view: View::of_slide(slide, stage),
            grain: Grain::Decision,
            speed: 1,
            playing: false,
            predict: true,
            locked: false,
            beside: Beside::Nothing,
            rival: "list",
            pace: Pace::Event,
            present: false,
            answered: None,
            playback: None,
            landing: Landing::Opening,
            history: History::default(),
            waited: 0.0,
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
        self.playback.as_ref()
    }

    /// Whether the walk shown is the one that should be.
    pub fn is_current(&self) -> bool {
        self.playback.as_ref().is_some_and(|playback| playback.view.same_walk(&self.view))
    }

    /// A walk was made: it is shown from now on, unless something else is wanted by now.
    pub fn arrive(&mut self, playback: Arc<Playback>) {
        if !playback.view.same_walk(&self.view) && !playback.view.same_but_own_ray(&self.view) {
            return;
        }
        let last = playback.steps().last();
        self.view.step = match self.landing {
            Landing::Opening => playback.opening(self.predict),
            Landing::Keep => self.view.step.min(last),
        };
        self.playback = Some(playback);
        self.landing = Landing::Keep;
        self.answered = None;
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
        self.landing = Landing::Keep;
    }

    /// The walk asked for cannot be made: back to the one that is shown.
    pub fn refuse(&mut self) {
        if let Some(playback) = &self.playback {
            let step = self.view.step;
            self.view = View { step, camera: self.view.camera, ..playback.view.clone() };
        }
    }

    /// Does what a command says; those that concern the window itself change nothing here.
    pub fn apply(&mut self, command: Command) {
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
            Command::NextSlide => self.show_slide(self.view.slide + 1),
            Command::PreviousSlide => self.show_slide(self.view.slide.wrapping_sub(1)),
            Command::Speed(speed) => self.speed = speed.clamp(1, 9),
            Command::Grain(grain) => self.grain = grain,
            Command::Predict => {
                self.predict = !self.predict;
                self.answered = None;
            }
            Command::Answer(choice) => self.answer(usize::from(choice)),
            Command::Skip => self.skip(),
            Command::Lock => self.locked = !self.locked,
            Command::Restore => self.restore(),
            Command::Undo => self.undo(),
            Command::Redo => self.redo(),
            Command::Flat => self.show_stage(StageKind::Flat),
            Command::Solid => self.show_stage(StageKind::Solid),
            Command::Compare => {
                let on = matches!(self.beside, Beside::Structure(_));
                self.beside = if on { Beside::Nothing } else { Beside::Structure(self.rival) };
            }
            Command::Present => self.present = !self.present,
            Command::ResetCamera => self.look(None),
            _ => {}
        }
    }

    /// To another slide.
    pub fn show_slide(&mut self, slide: usize) {
        if slide >= self.library.slides.len() || slide == self.view.slide {
            return;
        }
        self.keep();
        let stage = first_stage(&self.library, slide, self.view.stage);
        self.view = View::of_slide(slide, stage);
        self.beside = Beside::Nothing;
        self.open();
    }

    /// To the slide's other stage.
    pub fn show_stage(&mut self, stage: StageKind) {
        let offered = self.slide().is_some_and(|slide| slide.stage(stage).is_some());
        if offered && stage != self.view.stage {
            self.keep();
            self.view = View::of_slide(self.view.slide, stage);
            self.open();
        }
    }

    /// Another ray; `drag` says that it belongs to a change that is under way.
    pub fn show_ray(&mut self, ray: RayChoice, drag: bool) {
        if ray == self.view.ray {
            return;
        }
        if !drag {
            self.keep();
        }
        self.landing = if matches!(ray, RayChoice::Named(_)) { Landing::Opening } else { Landing::Keep };
        self.view.ray = ray;
        self.playing = false;
        self.answered = None;
    }

    /// A parameter of the structure.
    pub fn set(&mut self, key: &str, value: &str) {
        self.keep();
        self.view.settings.retain(|(known, _)| known != key);
        self.view.settings.push((key.to_owned(), value.to_owned()));
        self.playing = false;
    }

    /// A mesh instead of the slide's scene, with a ray through it.
    pub fn show_mesh(&mut self, mesh: Arc<Scene>, ray: raystep_accel::Ray) {
        self.keep();
        self.view.mesh = Some(mesh);
        self.view.example = None;
        self.view.stage = StageKind::Solid;
        self.view.ray = RayChoice::Own(ray);
        self.view.camera = None;
        self.open();
    }

    /// The small scene and the ray on which a mistake shows.
    pub fn show_example(&mut self, mistake: Mistake) {
        self.keep();
        let view = View::of_slide(self.view.slide, self.view.stage);
        self.view = View { ray: RayChoice::Own(mistake.example().ray), example: Some(mistake), ..view };
        self.open();
    }

    /// Another structure beside the walk.
    pub fn compare(&mut self, kind: &'static str) {
        self.rival = kind;
        self.beside = Beside::Structure(kind);
    }

    /// Another place to look from, as part of a change that is under way.
    pub fn turn(&mut self, camera: Camera) {
        self.view.camera = Some(camera);
    }

    /// Another place to look from; nothing for the slide's own.
    pub fn look(&mut self, camera: Option<Camera>) {
        if camera != self.view.camera {
            self.keep();
            self.view.camera = camera;
        }
    }

    /// Remembers the view before a change that undo shall take back in one.
    pub fn keep(&mut self) {
        self.history.keep(self.view.clone());
    }

    /// Whether there is something to undo, and to redo.
    pub fn undoable(&self) -> (bool, bool) {
        self.history.available()
    }

    fn restore(&mut self) {
        let own = View { step: self.view.step, ..View::of_slide(self.view.slide, self.view.stage) };
        let offered = self.slide().is_some_and(|slide| slide.stage(own.stage).is_some());
        let stage = if offered { own.stage } else { first_stage(&self.library, own.slide, StageKind::Flat) };
        let own = View { stage, ..own };
        if !own.same_walk(&self.view) {
            self.keep();
            self.view = own;
            self.open();
        } else if self.view.camera.is_some() {
            self.look(None);
        }
        self.beside = Beside::Nothing;
    }

    fn undo(&mut self) {
        if let Some(view) = self.history.undo(&self.view) {
            self.bring_back(view);
        }
    }

    fn redo(&mut self) {
        if let Some(view) = self.history.redo(&self.view) {
            self.bring_back(view);
        }
    }

    fn bring_back(&mut self, view: View) {
        self.view = view;
        self.landing = Landing::Keep;
        self.playing = false;
        self.answered = None;
    }

    fn open(&mut self) {
        self.landing = Landing::Opening;
        self.playing = false;
        self.answered = None;
        self.waited = 0.0;
    }
}

/// The stage a slide opens on: the wanted one if it has it.
fn first_stage(library: &Library, slide: usize, wanted: StageKind) -> StageKind {
    let stages = library.slides.get(slide).map_or(&[][..], |slide| slide.stages.as_slice());
    let wanted = stages.iter().find(|stage| stage.kind == wanted);
    wanted.or(stages.first()).map_or(StageKind::Flat, |stage| stage.kind)
}
