//! Heat maps instead of the picture of space, and the way from one of their pixels into a walk.

use raystep_accel::{Ray, Rule};
use raystep_figure::{Camera, Pixel};
use raystep_lesson::{Column, Counted, Entry, Plays, StageKind, Tape};

use super::{Landing, State};
use crate::shown::eye::aside;
use crate::shown::heat::sentence;
use crate::shown::view::{RayChoice, View};

impl State {
    /// What the heat map counts that stands where space does; nothing if none does.
    pub fn heat(&self) -> Option<Column> {
        self.heat.filter(|_| self.can_heat())
    }

    /// Whether what is shown has a solid picture that a heat map can stand for.
    pub(crate) fn can_heat(&self) -> bool {
        self.playback.as_ref().is_some_and(|playback| {
            !playback.play.scene.flat
                && matches!(playback.play.tape.plays(), Plays::Walk | Plays::Packet | Plays::Build)
        })
    }

    /// Shows a heat map, or space again. A slide that stands on its flat stage goes to its solid one, and back to where it
    /// was.
    pub(super) fn toggle_heat(&mut self) {
        if self.heat.is_some() {
            self.heat = None;
            if std::mem::take(&mut self.led_to_heat) {
                self.show_stage(StageKind::Flat);
            }
            return;
        }
        let solid =
            self.slide().is_some_and(|slide| slide.plays != Plays::Board && slide.stage(StageKind::Solid).is_some());
        self.led_to_heat = !self.can_heat() && solid;
        if self.led_to_heat {
            self.show_stage(StageKind::Solid);
            self.heat = Some(Column::Tests);
        }
        if self.can_heat() {
            self.heat = Some(Column::Tests);
        }
    }

    /// Something else is counted in the heat map.
    pub(crate) fn count(&mut self, of: Column) {
        self.heat = Some(of);
    }

    /// A pixel's ray walks from now on, seen from aside. Says whether one can walk here.
    pub(crate) fn step_ray(&mut self, ray: Ray, camera: Camera) -> bool {
        if self.slide().is_some_and(|slide| slide.plays == Plays::Walk) {
            self.keep();
            self.heat = None;
            let view = View { ray: RayChoice::Own(ray), camera: Some(camera), part: None, ..self.target().clone() };
            self.want(view, Landing::Opening);
            return true;
        }
        let Some(playback) = self.playback.clone() else { return false };
        self.open_walk(&playback.play.scene.name, &playback.rule, ray, camera)
    }

    /// Opens the walk of a pixel's ray, of a board's heat map. Where no slide has such a walk, a sentence says its number
    /// and the ray.
    pub(crate) fn open_pixel(&mut self, pixel: &Pixel) -> Option<String> {
        let playback = self.playback.clone()?;
        let Tape::Board(filled) = &playback.play.tape else { return None };
        let Entry::Map(map, of) = filled.board.entry(*filled.places.get(pixel.entry)?)? else { return None };
        let scene = &playback.play.scene;
        let ray = Counted::ray(scene, pixel.size, pixel.at).ok()?;
        let view = scene.close_view();
        let (eye, target, up, fov_degrees) = (view.eye, view.target, view.up, view.fov_degrees);
        let camera = aside(&Camera::Solid { eye, target, up, fov_degrees });
        let rule = map.plan.as_ref().and_then(|plan| plan.at(&filled.numbers).rule(false).ok());
        let opens = rule.is_some_and(|rule| self.open_walk(&scene.name, &rule, ray, camera));
        (!opens).then(|| sentence(pixel.count, of, &ray))
    }

    /// Goes to the slide on which a ray walks through such a structure over a solid scene, with this ray: to the one
    /// whose parameters differ least. Says whether there is one.
    pub(crate) fn open_walk(&mut self, scene: &str, rule: &Rule, ray: Ray, camera: Camera) -> bool {
        let mesh = self.target().mesh.clone();
        let found = self.library.slides.iter().enumerate().filter_map(|(index, slide)| {
            let stage = slide.stage(StageKind::Solid).filter(|_| slide.plays == Plays::Walk)?;
            let own = stage.plan.rule(false).ok().filter(|own| own.kind() == rule.kind())?;
            let settings = rule.differences(&own);
            (mesh.is_some() || stage.scene == scene).then_some((index, settings))
        });
        let here = self.target().slide;
        let nearest = found.min_by_key(|(index, settings)| (settings.len(), index.abs_diff(here)));
        let Some((slide, settings)) = nearest else { return false };
        let settings = settings.into_iter().map(|(key, value)| (key.to_owned(), value)).collect();
        self.keep();
        self.heat = None;
        let view = View::of_slide(slide, StageKind::Solid);
        self.wished = StageKind::Solid;
        let view = View { ray: RayChoice::Own(ray), settings, camera: Some(camera), mesh, ..view };
        self.want(view, Landing::Opening);
        true
    }
}
