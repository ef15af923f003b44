//! What undo brings back: everything that decides which walk is shown, how far, and from where.

use std::sync::Arc;

use raystep_accel::{Interval, Mistake, Ray};
use raystep_figure::{Camera, Depth};
use raystep_lesson::StageKind;
use raystep_scene::Scene;

use super::own::{OwnScene, Tried};

/// Which walk is shown, how far, and from where.
#[derive(Clone, Debug)]
pub struct View {
    /// The slide's place in the library.
    pub slide: usize,
    /// The stage it plays on.
    pub stage: StageKind,
    /// The ray that walks.
    pub ray: RayChoice,
    /// Parameters that differ from the slide's own: key and value.
    pub settings: Vec<(String, String)>,
    /// Where it is seen from, if not from the slide's own place.
    pub camera: Option<Camera>,
    /// How many boxes of a tree are drawn in space, if not as many as the slide says.
    pub depth: Option<Depth>,
    /// The part of the ray that the ruler shows, if not all of it.
    pub part: Option<Interval>,
    /// A mesh opened instead of the slide's scene.
    pub mesh: Option<Arc<Scene>>,
    /// The slide's scene as somebody has changed it by hand.
    pub own: Option<OwnScene>,
    /// A cut that is tried at this step.
    pub tried: Option<Tried>,
    /// The mistake whose own scene and ray are shown instead of the slide's.
    pub example: Option<Mistake>,
    /// How many events have happened.
    pub step: usize,
}

/// The ray that walks.
#[derive(Clone, Debug, PartialEq)]
pub enum RayChoice {
    /// The slide's ray with this place in its list.
    Named(usize),
    /// One that the user has drawn.
    Own(Ray),
}

impl View {
    /// The beginning of a slide.
    pub fn of_slide(slide: usize, stage: StageKind) -> View {
        let (ray, settings) = (RayChoice::Named(0), Vec::new());
        let (camera, depth, part) = (None, None, None);
        let (mesh, own, tried) = (None, None, None);
        View { slide, stage, ray, settings, camera, depth, part, mesh, own, tried, example: None, step: 0 }
    }

    /// Whether both show the very same page.
    pub fn same_page(&self, other: &View) -> bool {
        self.step == other.step && self.tried == other.tried && self.looks_as(other) && self.same_walk(other)
    }

    /// Whether both are looked at in the same way.
    fn looks_as(&self, other: &View) -> bool {
        self.camera == other.camera && self.depth == other.depth && self.part == other.part
    }

    /// Whether it is looked at as the slide says.
    pub fn looks_its_own(&self) -> bool {
        self.looks_as(&View::of_slide(self.slide, self.stage))
    }

    /// The same, looked at as another one is.
    pub fn looking_as(self, other: &View) -> View {
        View { camera: other.camera, depth: other.depth, part: other.part, ..self }
    }

    /// Whether both show the same walk of the same ray, wherever they stand in it.
    pub fn same_walk(&self, other: &View) -> bool {
        self.ray == other.ray && self.same_structure(other)
    }

    /// Whether both show the same, but for what somebody may have in the hand: a ray that was drawn, shapes that were
    /// moved, nodes that were cut.
    pub fn same_but_held(&self, other: &View) -> bool {
        let own_ray = |view: &View| matches!(view.ray, RayChoice::Own(_));
        let kept = |view: &View| view.settings.iter().filter(|(key, _)| key != "cut").cloned().collect::<Vec<_>>();
        self.same_place(other)
            && (self.ray == other.ray || own_ray(self) && own_ray(other))
            && self.own.is_some() == other.own.is_some()
            && kept(self) == kept(other)
    }

    /// Whether the rays of both walk through the same structure.
    pub fn same_structure(&self, other: &View) -> bool {
        self.settings == other.settings && self.same_scene(other)
    }

    /// Whether both show the same primitives on the same slide.
    pub fn same_scene(&self, other: &View) -> bool {
        self.own == other.own && self.same_place(other)
    }

    /// Whether both show the same slide on the same stage, or the same scene instead.
    fn same_place(&self, other: &View) -> bool {
        self.slide == other.slide
            && self.stage == other.stage
            && self.example == other.example
            && same_mesh(self.mesh.as_ref(), other.mesh.as_ref())
    }

    /// Whether the scene is not the slide's own.
    pub fn is_elsewhere(&self) -> bool {
        self.mesh.is_some() || self.example.is_some()
    }
}

fn same_mesh(a: Option<&Arc<Scene>>, b: Option<&Arc<Scene>>) -> bool {
    match (a, b) {
        (None, None) => true,
        (Some(a), Some(b)) => Arc::ptr_eq(a, b),
        _ => false,
    }
}
