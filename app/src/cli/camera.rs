//! Where scenes and stages are seen from when nobody has moved the eye.

use glam::Vec2;
use raystep_figure::{Camera, Space};
use raystep_lesson::{Look, Stage};
use raystep_scene::Scene;

/// The scene's own view, for a picture of this size.
pub(crate) fn of_scene(scene: &Scene, size: Vec2) -> Camera {
    let view = scene.view;
    if scene.flat {
        Camera::frame(&scene.bounds(), size.x / size.y, true)
    } else {
        Camera::Solid { eye: view.eye, target: view.target, up: view.up, fov_degrees: view.fov_degrees }
    }
}

/// The stage's view, or its scene's; of a flat scene, all that its drawing is about.
pub(crate) fn of_stage(stage: &Stage, scene: &Scene, space: &Space, size: Vec2) -> Camera {
    match stage.camera {
        None if scene.flat => Camera::frame(&space.bounds, size.x / size.y, true),
        None => of_scene(scene, size),
        Some(Look::Flat { center, half_height }) => Camera::Flat { center, half_height },
        Some(Look::Solid { eye, target, up, fov_degrees }) => Camera::Solid { eye, target, up, fov_degrees },
    }
}
