//! Where scenes and stages are seen from in a picture.

use glam::Vec2;
use raystep_figure::{Camera, Space};
use raystep_lesson::Look;
use raystep_scene::Scene;

/// A camera as somebody has set it, in a picture of this aspect (width / height).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Seen {
    /// The camera.
    pub(crate) camera: Camera,
    /// The aspect of the picture in which it was set.
    pub(crate) aspect: f32,
}

impl Seen {
    /// The camera that shows all of what was seen in a picture of this size.
    pub(crate) fn all_in(&self, size: Vec2) -> Camera {
        let taller = (self.aspect / (size.x / size.y)).max(1.0);
        match self.camera {
            Camera::Flat { center, half_height } => Camera::Flat { center, half_height: half_height * taller },
            Camera::Solid { eye, target, up, fov_degrees } => {
                let half = f64::from(fov_degrees.to_radians() * 0.5);
                let wider = libm::atan(libm::tan(half) * f64::from(taller)) as f32;
                Camera::Solid { eye, target, up, fov_degrees: (2.0 * wider).to_degrees() }
            }
        }
    }
}

/// A view that was written down, as it is in a picture of this size: in a narrow one it shows as much across.
pub(crate) fn composed(camera: Camera, size: Vec2) -> Camera {
    Seen { camera, aspect: COMPOSED }.all_in(size)
}

/// The narrowest pictures that views are written for.
const COMPOSED: f32 = 1.3;

/// The scene's own view, for a picture of this size.
pub(crate) fn of_scene(scene: &Scene, size: Vec2) -> Camera {
    let view = scene.view;
    if scene.flat {
        Camera::frame(&scene.bounds(), size.x / size.y, true)
    } else {
        Camera::Solid { eye: view.eye, target: view.target, up: view.up, fov_degrees: view.fov_degrees }
    }
}

/// The stage's view, or its scene's from so far back that all is seen that the drawing is about.
pub(crate) fn of_stage(look: Option<Look>, scene: &Scene, space: &Space, size: Vec2) -> Camera {
    match look {
        None if scene.flat => Camera::frame(&space.bounds, size.x / size.y, true),
        None => of_scene(scene, size).holding(&space.bounds, size.x / size.y),
        Some(Look::Flat { center, half_height }) => Camera::Flat { center, half_height },
        Some(Look::Solid { eye, target, up, fov_degrees }) => {
            composed(Camera::Solid { eye, target, up, fov_degrees }, size)
        }
    }
}
