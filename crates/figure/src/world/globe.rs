//! Circles that show a sphere: its outline as an eye sees it, and two around it.

use glam::Vec3;
use raystep_accel::Sphere;

use crate::world::ring;

/// Where the eye's lines of sight touch a sphere, as a closed line; nothing if the eye is inside.
pub fn contour(sphere: &Sphere, eye: Vec3) -> Option<Vec<Vec3>> {
    let away = eye - sphere.center;
    let near = sphere.radius * sphere.radius / away.length_squared();
    if near >= 1.0 || near.is_nan() {
        return None;
    }
    Some(closed(ring(sphere.center + away * near, away, sphere.radius * (1.0 - near).sqrt())))
}

/// Its equator and a circle over its poles, as closed lines.
pub fn circles(sphere: &Sphere) -> [Vec<Vec3>; 2] {
    [Vec3::Z, Vec3::Y].map(|normal| closed(ring(sphere.center, normal, sphere.radius)))
}

fn closed(mut ring: Vec<Vec3>) -> Vec<Vec3> {
    ring.push(ring[0]);
    ring
}
