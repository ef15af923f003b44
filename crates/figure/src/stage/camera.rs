//! Where a solid scene is seen from.

use glam::{Mat4, Vec2, Vec3};
use raystep_accel::{Ray, RayError, pinhole};

/// A camera; the one type that projects the world onto a page.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Camera {
    /// Straight down the z axis onto a flat scene, x to the right and y up.
    Flat {
        /// What lies in the middle of the picture.
        center: Vec2,
        /// World units from the middle of the picture to its upper edge.
        half_height: f32,
    },
    /// A perspective view.
    Solid {
        /// Where the eye is.
        eye: Vec3,
        /// What lies in the middle of the picture.
        target: Vec3,
        /// Which way is up.
        up: Vec3,
        /// Vertical angle of view in degrees.
        fov_degrees: f32,
    },
}

impl Camera {
    /// Clip space from world space, for a picture of this aspect (width / height). Reverse z: 1 is at the
    /// eye's near plane, 0 infinitely far.
    pub fn clip_from_world(&self, aspect: f32) -> Mat4 {
        match *self {
            Camera::Flat { center, half_height } => {
                let half_width = half_height * aspect;
                // Depth 0 at z = −10⁴, 1 at z = 10⁴.
                let mut clip_from_world = Mat4::IDENTITY;
                clip_from_world.x_axis.x = 1.0 / half_width;
                clip_from_world.y_axis.y = 1.0 / half_height;
                clip_from_world.z_axis.z = 0.5e-4;
                clip_from_world.w_axis = glam::Vec4::new(-center.x / half_width, -center.y / half_height, 0.5, 1.0);
                clip_from_world
            }
            Camera::Solid { eye, target, up, fov_degrees } => {
                let near = ((target - eye).length() * 1e-3).max(1e-6);
                let half = fov_degrees.to_radians() * 0.5;
                let scale = (libm::cos(f64::from(half)) / libm::sin(f64::from(half))) as f32;
                let mut clip_from_view = Mat4::ZERO;
                clip_from_view.x_axis.x = scale / aspect;
                clip_from_view.y_axis.y = scale;
                clip_from_view.z_axis.w = -1.0;
                clip_from_view.w_axis.z = near;
                clip_from_view * view_from_world(eye, target, up)
            }
        }
    }

    /// The ray through a point of the page; in a flat scene, the ray straight down onto it.
    ///
    /// # Errors
    /// When the camera is degenerate (the eye at the target).
    pub fn ray(&self, page: Vec2, size: Vec2) -> Result<Ray, RayError> {
        let ndc = Vec2::new(page.x / size.x * 2.0 - 1.0, 1.0 - page.y / size.y * 2.0);
        match *self {
            Camera::Flat { center, half_height } => {
                let at = center + ndc * Vec2::new(half_height * size.x / size.y, half_height);
                Ray::new(at.extend(1e3), Vec3::NEG_Z)
            }
            Camera::Solid { eye, target, up, fov_degrees } => {
                pinhole(eye, target, up, fov_degrees, ndc, size.x / size.y)
            }
        }
    }
}

/// View space from world space: x right, y up, the eye at the origin looking down −z.
fn view_from_world(eye: Vec3, target: Vec3, up: Vec3) -> Mat4 {
    let back = (eye - target).normalize_or_zero();
    let right = up.cross(back).normalize_or_zero();
    let up = back.cross(right);
    let rotation = glam::Mat3::from_cols(right, up, back).transpose();
    Mat4::from_cols(
        rotation.x_axis.extend(0.0),
        rotation.y_axis.extend(0.0),
        rotation.z_axis.extend(0.0),
        (-(rotation * eye)).extend(1.0),
    )
}
