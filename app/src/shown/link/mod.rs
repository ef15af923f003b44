//! A place in the lecture and all that is set there, as one line of text: `5/33?ray=from%20the%20right&step=13`.

#[cfg(test)]
mod tests;
mod text;

use glam::{Vec2, Vec3};
use raystep_accel::{Grain, HandCut, Interval, Mistake, Ray, Rule};
use raystep_fast::FastKind;
use raystep_figure::{Camera, Depth};
use raystep_lesson::{Column, Library, Plays, Slide, Stage, StageKind};

use super::beside::{Beside, Pace, Rivals};
use super::command::QUARTERS;
use super::own::{OwnScene, Tried};
use super::playback::mistakes;
use super::state::{Asked, State};
use super::unknown::{no_ray, no_slide};
use super::view::{RayChoice, View};

/// A place, by the names that people know: of a slide, of a ray.
#[derive(Clone, Debug, PartialEq)]
pub struct Link {
    /// The slide's id, or its file's name.
    pub slide: String,
    /// The stage, if it is said.
    pub stage: Option<StageKind>,
    /// The name of the slide's ray; without it, its first.
    pub ray: Option<String>,
    /// A ray of the user's own instead.
    pub own: Option<Ray>,
    /// How many events have happened; without it, where the slide opens.
    pub step: Option<usize>,
    /// Parameters of the structure, numbers of a meter and bodies of pairs that differ from the slide's own.
    pub set: Vec<(String, String)>,
    /// Shapes of the slide's scene that were moved by hand: which, and where they lie in numbers.
    pub shapes: Vec<(u32, Vec<f32>)>,
    /// The cut that is tried at this step.
    pub tried: Option<HandCut>,
    /// The mistake whose own small scene and ray are shown instead of the slide's.
    pub example: Option<Mistake>,
    /// Where it is seen from, and the aspect of the picture that this was chosen in.
    pub camera: Option<Camera>,
    /// The aspect of the picture.
    pub aspect: f32,
    /// How many boxes of a tree are drawn in space.
    pub depth: Option<Depth>,
    /// The part of the ray that the ruler shows.
    pub part: Option<Interval>,
    /// The kinds of structures beside.
    pub beside: Option<Rivals>,
    /// The mistake that is made beside instead.
    pub mistake: Option<Mistake>,
    /// How what stands beside keeps in step.
    pub pace: Pace,
    /// What a heat map counts that stands where space does.
    pub heat: Option<Column>,
    /// Which structure at full speed stands beside that heat map.
    pub fast: Option<FastKind>,
    /// Where the mesh lies that is shown instead of the slide's scene.
    pub mesh: Option<String>,
    /// Where playing and the arrow keys stop.
    pub grain: Grain,
    /// How fast playing is, in quarters of the usual speed.
    pub speed: u8,
    /// Whether the presenter's page is shown.
    pub present: bool,
    /// Whether what can be set by hand stands below the lesson.
    pub by_hand: bool,
    /// What has been asked and answered at the step.
    pub asked: Asked,
}

impl Default for Link {
    fn default() -> Link {
        Link {
            slide: String::new(),
            stage: None,
            ray: None,
            own: None,
            step: None,
            set: Vec::new(),
            shapes: Vec::new(),
            tried: None,
            example: None,
            camera: None,
            aspect: ASPECT,
            depth: None,
            part: None,
            beside: None,
            mistake: None,
            pace: Pace::Event,
            heat: None,
            fast: None,
            mesh: None,
            grain: Grain::Decision,
            speed: QUARTERS,
            present: false,
            by_hand: false,
            asked: Asked::default(),
        }
    }
}

/// The aspect of a picture of which nothing is known.
const ASPECT: f32 = 1.6;

impl Link {
    /// Where a window stands: what is shown, not what is still being made. `mesh` is where the mesh lies that is shown.
    pub fn of(state: &State, mesh: Option<String>, aspect: f32) -> Link {
        let beside = match state.beside {
            Beside::Structure(kind) => Some(Rivals::of([kind])),
            Beside::Abreast(rivals) => Some(rivals),
            Beside::Nothing | Beside::Mistake(_) => None,
        };
        let mistake = match (state.beside, state.playback()) {
            (Beside::Mistake(index), Some(playback)) => playback.mistakes.get(index).copied(),
            _ => None,
        };
        Link {
            beside,
            mistake,
            pace: state.pace,
            heat: state.heat(),
            fast: state.heat().and(state.quick),
            mesh,
            aspect: if state.view.camera.is_some() { aspect } else { ASPECT },
            grain: state.grain,
            speed: state.speed,
            present: state.present,
            by_hand: state.by_hand,
            asked: state.asked(),
            ..Link::of_view(&state.view, &state.library)
        }
    }

    /// The place of a view in these lessons.
    pub fn of_view(view: &View, library: &Library) -> Link {
        let slide = library.slides.get(view.slide);
        let stage = slide.and_then(|slide| slide.stage(view.stage).or(slide.stages.first()));
        let ray = match view.ray {
            RayChoice::Named(index) => stage.and_then(|stage| stage.rays.get(index)).map(|ray| ray.name.clone()),
            RayChoice::Own(_) => None,
        };
        // The small scene of a mistake has a ray that goes with it.
        let given = view.example.map(|mistake| mistake.example().ray);
        let own = match view.ray {
            RayChoice::Own(ray) if given != Some(ray) => Some(ray),
            _ => None,
        };
        Link {
            slide: slide.map(Slide::id).unwrap_or_default(),
            stage: Some(view.stage),
            ray,
            own,
            step: Some(view.step),
            set: view.settings.clone(),
            shapes: view.own.as_ref().map(OwnScene::shapes).unwrap_or_default(),
            tried: view.tried.map(|tried| tried.cut),
            example: view.example,
            camera: view.camera,
            depth: view.depth,
            part: view.part,
            ..Link::default()
        }
    }

    /// The view in these lessons, without its mesh, and a sentence for all that is not there; no view where the slide
    /// is not in them.
    pub fn view(&self, library: &Library) -> (Option<View>, Vec<String>) {
        let mut wrong = Vec::new();
        let Some(found) = library.slide(&self.slide) else {
            wrong.push(no_slide(library, &self.slide));
            return (None, wrong);
        };
        let place = library.slides.iter().position(|other| std::ptr::eq(other, found)).unwrap_or(0);
        let id = found.id();
        let wished = self.stage.and_then(|kind| found.stage(kind));
        if let (Some(kind), None, None) = (self.stage, wished, &self.mesh) {
            wrong.push(format!("slide {id} has no {} stage", kind.name()));
        }
        // A ray is looked for on every stage, unless one is named.
        let has = |stage: &&Stage| self.ray.as_deref().is_none_or(|name| stage.ray(name).is_some());
        let named = found.stages.iter().find(has).filter(|_| self.stage.is_none() && self.ray.is_some());
        let stage = wished.or(named).or(found.opening_stage(StageKind::Flat));
        // A mesh is solid, whatever the slide has.
        let kind = match (&self.mesh, stage) {
            (Some(_), _) => StageKind::Solid,
            (None, Some(stage)) => stage.kind,
            (None, None) => {
                wrong.push(format!("slide {id} has no stage"));
                return (None, wrong);
            }
        };
        let made_here = |mistake: &Mistake| not_made(found, stage, *mistake).is_none();
        let example = self.example.filter(|_| self.mesh.is_none()).filter(made_here);
        let ray = match (self.own.or(example.map(|mistake| mistake.example().ray)), &self.ray) {
            (Some(own), _) => RayChoice::Own(own),
            (None, Some(name)) => {
                let index = stage.and_then(|stage| stage.rays.iter().position(|ray| ray.name == *name));
                if index.is_none() {
                    wrong.push(no_ray(found, name));
                }
                RayChoice::Named(index.unwrap_or(0))
            }
            (None, None) => RayChoice::Named(0),
        };
        let mut rule = match example {
            Some(mistake) => Some(mistake.example().rule),
            None => stage.and_then(|stage| stage.plan.rule(kind == StageKind::Flat).ok()),
        };
        let mut settings = Vec::new();
        for (key, value) in &self.set {
            match set(stage, rule.as_mut(), key, value) {
                Ok(()) => settings.push((key.clone(), value.clone())),
                Err(why) => wrong.push(why),
            }
        }
        let (camera, depth, part, step) = (self.camera, self.depth, self.part, self.step.unwrap_or(0));
        // The small scene of a mistake is flat, whatever the slide's is.
        let seen = if example.is_some() { StageKind::Flat } else { kind };
        let flat = |camera: &Camera| matches!(camera, Camera::Flat { .. });
        if camera.as_ref().is_some_and(|camera| flat(camera) != (seen == StageKind::Flat)) {
            wrong.push(format!("the camera is not one of a {} stage", seen.name()));
        }
        let camera = camera.filter(|camera| flat(camera) == (seen == StageKind::Flat));
        let own = self.own_scene(stage.filter(|_| self.mesh.is_none() && self.example.is_none()), &mut wrong);
        let tried = self.tried.map(|cut| Tried { step, cut });
        wrong
            .extend(self.example.into_iter().chain(self.mistake).filter_map(|mistake| not_made(found, stage, mistake)));
        let view =
            View { ray, settings, camera, depth, part, own, tried, example, step, ..View::of_slide(place, kind) };
        (Some(view), wrong)
    }

    /// The stage's scene with the shapes that were moved.
    fn own_scene(&self, stage: Option<&Stage>, wrong: &mut Vec<String>) -> Option<OwnScene> {
        if self.shapes.is_empty() {
            return None;
        }
        let Some(scene) = stage.and_then(|stage| stage.scenes.named(&stage.scene).ok()) else {
            wrong.push("shapes are moved in the slide's own scene, and in no other".to_owned());
            return None;
        };
        let (own, why) = OwnScene::restored(&scene, &self.shapes);
        wrong.extend(why);
        own
    }

    /// Opens the place in a window, with its mesh if that has been read; says what is not there.
    pub fn open(&self, state: &mut State, mesh: Option<std::sync::Arc<raystep_scene::Scene>>) -> Vec<String> {
        let (view, mut wrong) = self.view(&state.library);
        let Some(view) = view else { return wrong };
        let (beside, heat) = (self.stands_beside(state, &view, &mut wrong), self.heat_of(state, &view, &mut wrong));
        // Without the mesh its ray and its step mean nothing.
        let lost = self.mesh.is_some() && mesh.is_none();
        let view = if lost { View::of_slide(view.slide, view.stage) } else { View { mesh, ..view } };
        (state.grain, state.speed, state.present, state.by_hand) = (self.grain, self.speed, self.present, self.by_hand);
        match self.step {
            None if !lost => state.arrive_at(view),
            _ => state.reopen(view, if lost { Asked::default() } else { self.asked.clone() }),
        }
        state.accompany(beside, self.pace, heat);
        if self.fast.is_some() && heat.is_none() {
            wrong.push("a structure at full speed stands beside a heat map alone, and there is none".to_owned());
        }
        state.quick = heat.and(self.fast);
        wrong
    }

    /// What stands beside the walk of a view.
    fn stands_beside(&self, state: &State, view: &View, wrong: &mut Vec<String>) -> Beside {
        let rivals = self.beside.unwrap_or_default();
        if let Some(mistake) = self.mistake {
            if rivals.count() > 0 {
                wrong.push("either structures stand beside, or a mistake".to_owned());
            }
            let slide = state.library.slides.get(view.slide);
            let stage = slide.and_then(|slide| slide.stage(view.stage).or(slide.stages.first()));
            let known = slide.zip(stage).map(|(slide, stage)| mistakes(&stage.plan.kind, slide.plays));
            let index = known.and_then(|known| known.iter().position(|other| *other == mistake));
            return index.map_or(Beside::Nothing, Beside::Mistake);
        }
        match rivals.kinds().next() {
            None => Beside::Nothing,
            Some(_) if rivals.count() > 1 => Beside::Abreast(rivals),
            Some(only) => Beside::Structure(only),
        }
    }

    /// What a heat map counts in a view, if one can stand there.
    fn heat_of(&self, state: &State, view: &View, wrong: &mut Vec<String>) -> Option<Column> {
        let of = self.heat?;
        let plays = state.library.slides.get(view.slide).map(|slide| slide.plays);
        let solid = view.stage == StageKind::Solid && view.example.is_none();
        let hot = solid && matches!(plays, Some(Plays::Walk | Plays::Packet | Plays::Build));
        if !hot {
            wrong.push("a heat map needs a solid scene and a structure".to_owned());
        }
        Some(of).filter(|_| hot)
    }
}

/// Why a mistake cannot be made on a slide; nothing if it can.
fn not_made(slide: &Slide, stage: Option<&Stage>, mistake: Mistake) -> Option<String> {
    let known = stage.map(|stage| mistakes(&stage.plan.kind, slide.plays)).unwrap_or_default();
    if known.contains(&mistake) {
        return None;
    }
    let names: Vec<&str> = known.iter().map(|mistake| mistake.name()).collect();
    let there = if names.is_empty() { "there are none".to_owned() } else { format!("there are {}", names.join(", ")) };
    Some(format!("slide {} has no mistake \"{}\"; {there}", slide.id(), mistake.name()))
}

/// Sets a parameter or a number, or says why that cannot be.
fn set(stage: Option<&Stage>, rule: Option<&mut Rule>, key: &str, value: &str) -> Result<(), String> {
    match (stage.and_then(|stage| stage.own_setting(key, value)), rule) {
        (Some(own), _) => own,
        (None, Some(rule)) => rule.set(key, value).map_err(|error| error.to_string()),
        (None, None) => Err(format!("nothing is built that has a parameter \"{key}\"")),
    }
}

/// Whether a camera looks somewhere.
fn looks(camera: &Camera) -> bool {
    match *camera {
        Camera::Flat { half_height, .. } => half_height > 0.0,
        Camera::Solid { eye, target, up, .. } => (target - eye).cross(up).try_normalize().is_some(),
    }
}

/// The numbers of a camera: three of a flat one, ten of a solid one.
fn numbers(camera: &Camera) -> Vec<f32> {
    match *camera {
        Camera::Flat { center, half_height } => vec![center.x, center.y, half_height],
        Camera::Solid { eye, target, up, fov_degrees } => {
            let points = [eye, target, up].into_iter().flat_map(|point| point.to_array());
            points.chain([fov_degrees]).collect()
        }
    }
}

/// The camera of so many numbers.
fn camera(numbers: &[f32]) -> Option<Camera> {
    let camera = match *numbers {
        [x, y, half_height] => Camera::Flat { center: Vec2::new(x, y), half_height },
        [a, b, c, d, e, f, g, h, i, fov_degrees @ 0.01..=179.0] => {
            Camera::Solid { eye: Vec3::new(a, b, c), target: Vec3::new(d, e, f), up: Vec3::new(g, h, i), fov_degrees }
        }
        _ => return None,
    };
    (numbers.iter().all(|number| number.abs() <= LARGEST) && looks(&camera)).then_some(camera)
}

/// Larger is nothing that is looked at.
const LARGEST: f32 = 1e30;
