//! What undo brings back: everything that decides which walk is shown, how far, and from where.

use std::sync::Arc;

use raystep_accel::Ray;
use raystep_figure::Camera;
use raystep_lesson::StageKind;
use raystep_scene::Scene;

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
    /// A mesh opened instead of the slide's scene.
    pub mesh: Option<Arc<Scene>>,
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
        View { slide, stage, ray: RayChoice::Named(0), settings: Vec::new(), camera: None, mesh: None, step: 0 }
    }

    /// Whether both show the same walk of the same ray, wherever they stand in it.
    pub fn same_walk(&self, other: &View) -> bool {
        self.slide == other.slide
            && self.stage == other.stage
            && self.ray == other.ray
            && self.settings == other.settings
            && same_mesh(self.mesh.as_ref(), other.mesh.as_ref())
    }
}

fn same_mesh(a: Option<&Arc<Scene>>, b: Option<&Arc<Scene>>) -> bool {
    match (a, b) {
        (None, None) => true,
        (Some(a), Some(b)) => Arc::ptr_eq(a, b),
        _ => false,
    }
}
