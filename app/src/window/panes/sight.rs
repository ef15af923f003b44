//! How space is looked at: what draws it, and what the pointer has hold of.

use raystep_figure::{Camera, Space};
use raystep_scene::Scene;

use super::hold::Hold;
use super::solid::Solid;
use crate::shown::camera::Seen;
use crate::shown::eye;
use crate::shown::pictures::{Drawn, Pictures};
use crate::shown::state::State;

/// The stage between two frames.
pub(crate) struct Sight {
    pub(super) solid: Solid,
    pub(super) solid_beside: Solid,
    pub(super) solid_inset: Solid,
    /// What the pointer has hold of.
    pub(super) hold: Option<Hold>,
    /// Where space is seen from while something in it is dragged.
    pub(super) still: Option<Camera>,
    /// The walk beside, as it was drawn last.
    pub(super) beside: Option<Drawn>,
    /// The aspect (width / height) of the picture in which the camera was moved last.
    pub(crate) aspect: f32,
    /// The size of the picture of space.
    pub(crate) size: glam::Vec2,
}

impl Default for Sight {
    fn default() -> Sight {
        Sight {
            solid: Solid::default(),
            solid_beside: Solid::default(),
            solid_inset: Solid::default(),
            hold: None,
            still: None,
            beside: None,
            aspect: 1.6,
            size: glam::Vec2::new(1000.0, 625.0),
        }
    }
}

impl Sight {
    /// Lets go of what is being changed; says whether there was anything.
    pub(crate) fn let_go(&mut self) -> bool {
        self.hold.take_if(|hold| !matches!(hold, Hold::Turn | Hold::Shift)).is_some()
    }

    /// Draws solid stages with egui's own device.
    pub(super) fn draw_with(&mut self, state: &egui_wgpu::RenderState) {
        self.solid = Solid::new(state);
        self.solid_beside = self.solid.another();
        self.solid_inset = self.solid.another();
    }

    /// Lets go of egui's device.
    pub(super) fn draw_with_none(&mut self) {
        (self.solid, self.solid_beside, self.solid_inset) = Default::default();
    }

    /// Where the stage is seen from now, in a picture of this size.
    pub(super) fn camera(&self, state: &State, space: &Space, size: glam::Vec2) -> Camera {
        if let Some(camera) = self.still.filter(|_| self.hold.is_some()) {
            return camera;
        }
        // What somebody has set stays in the picture when that becomes narrower.
        if let Some(camera) = state.view.camera {
            return Seen { camera, aspect: self.aspect }.all_in(size);
        }
        Sight::home(state, space, size)
    }

    /// Where a scene's rays are shot from: from where it is seen now, if it is, else from near by.
    pub(crate) fn camera_of(&self, state: &State, scene: &Scene) -> Camera {
        let shown = state.playback().is_some_and(|playback| std::ptr::eq(&*playback.play.scene, scene));
        if let Some(camera) = state.view.camera.filter(|_| shown) {
            return camera;
        }
        let view = scene.close_view();
        Camera::Solid { eye: view.eye, target: view.target, up: view.up, fov_degrees: view.fov_degrees }
    }

    /// The slide's own view.
    fn home(state: &State, space: &Space, size: glam::Vec2) -> Camera {
        let look = state.stage().and_then(|stage| stage.camera.as_ref()).filter(|_| !state.view.is_elsewhere());
        match state.playback() {
            Some(playback) => eye::home(look, &playback.play.scene, &space.bounds, size),
            None => eye::fitted(&space.bounds, size),
        }
    }

    /// The camera moved to where the walk stands.
    pub(crate) fn framed(&self, state: &State, pictures: &Pictures) -> Option<Seen> {
        let space = pictures.space.as_deref()?;
        let reel = pictures.playback.reel();
        let still = reel.still(&pictures.instant);
        let bounds = still.here().map_or(space.bounds, |place| still.bounds(place));
        if bounds.is_empty() {
            return None;
        }
        let size = glam::Vec2::new(800.0, 600.0);
        let own = Sight::home(state, space, size);
        let camera = eye::no_further(eye::framed(&self.camera(state, space, size), &bounds, size), own, &bounds, size);
        Some(Seen { camera, aspect: size.x / size.y })
    }
}
