//! The rays of a picture: from the eye through the points of a page.

use glam::{Vec2, Vec3};

use super::{Ray, RayError};

/// The ray from `eye` through the point `at` of a page that is `aspect` times as wide as high: (−1, −1) is its lower
/// left corner, (1, 1) its upper right one, (0, 0) the middle, where `target` lies. Its direction has length one.
///
/// # Errors
/// When nothing can be seen that way: the eye lies at the target, or `up` along the view.
pub fn pinhole(eye: Vec3, target: Vec3, up: Vec3, fov_degrees: f32, at: Vec2, aspect: f32) -> Result<Ray, RayError> {
    let forward = (target - eye).normalize_or_zero();
    let right = forward.cross(up).normalize_or_zero();
    let half = f64::from(fov_degrees.to_radians() * 0.5);
    let tan = (libm::sin(half) / libm::cos(half)) as f32;
    let d = forward + right * (at.x * tan * aspect) + right.cross(forward) * (at.y * tan);
    Ray::new(eye, d.normalize_or_zero())
}
