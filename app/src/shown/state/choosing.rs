//! What is chosen to be shown: a slide, its stage, a ray, a mesh, a parameter of the structure.

use std::sync::Arc;

use raystep_accel::{Mistake, Rule};
use raystep_lesson::{Plays, Stage, StageKind};
use raystep_scene::Scene;

use super::{Landing, State, opening_stage};
use crate::shown::beside::Beside;
use crate::shown::view::{RayChoice, View};

impl State {
    /// To another slide.
    pub fn show_slide(&mut self, slide: usize) {
        if slide < self.library.slides.len() && slide != self.target().slide {
            self.open_slide(slide);
        }
    }

    /// Shows a slide from where it opens, with its own ray and structure, also if it is shown already.
    pub(super) fn open_slide(&mut self, slide: usize) {
        self.leave();
        let stage = opening_stage(&self.library, slide, self.wished);
        self.want(View::of_slide(slide, stage), Landing::Opening);
    }

    /// What is shown is left for another slide.
    pub(super) fn leave(&mut self) {
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
            let other = self.other_stage.take().filter(|other| (other.slide, other.stage) == (slide, stage));
            // A mesh of one's own, too, waits until its stage is shown again.
            self.other_stage = Some(self.target().clone());
            match other {
                Some(other) => self.want(other, Landing::Named),
                None => self.want(View::of_slide(slide, stage), Landing::Opening),
            }
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

    /// Back to a view that was left for another, at its step: if nothing else was done since, as if it had not been left.
    pub(crate) fn return_to(&mut self, view: View) {
        if !self.history.forget(&view) {
            self.keep();
        }
        self.want(view, Landing::Named);
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

    pub(super) fn set_and_stand(&mut self, key: &str, value: &str, landing: Landing) {
        let mut view = self.target().clone();
        view.settings.retain(|(known, _)| known != key);
        view.settings.push((key.to_owned(), value.to_owned()));
        self.want(view, landing);
    }

    /// Whether the slide can show a mesh of one's own instead of its scene: what it has on a board or in pairs is its own.
    pub fn shows_meshes(&self) -> bool {
        self.slide().is_some_and(|slide| !matches!(slide.plays, Plays::Board | Plays::Pairs))
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
}
