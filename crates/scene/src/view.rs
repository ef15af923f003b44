//! Where a scene is first seen from.

use glam::Vec3;
use raystep_accel::Aabb;

/// The eye that shows a scene well.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Where the eye is, world space.
    pub eye: Vec3,
    /// What lies in the middle of the picture.
    pub target: Vec3,
    /// Which way is up.
    pub up: Vec3,
    /// Vertical angle of view in degrees.
    pub fov_degrees: f32,
}

impl View {
    /// Looks at the middle of `bounds` from the side `from` (a direction away from the box), as near as all
    /// eight corners allow in a picture of 4:3, with a little air.
    pub fn fitting(bounds: &Aabb, from: Vec3, up: Vec3) -> View {
        let bounds = if bounds.is_empty() { Aabb::new(Vec3::NEG_ONE, Vec3::ONE) } else { *bounds };
        let corners = (0..8).map(|i| {
            let pick = |bit: usize, low: f32, high: f32| if i >> bit & 1 == 0 { low } else { high };
            Vec3::new(
                pick(0, bounds.min.x, bounds.max.x),
                pick(1, bounds.min.y, bounds.max.y),
                pick(2, bounds.min.z, bounds.max.z),
            )
        });
        View::holding(corners, bounds.center(), from, up, 1.04)
    }

    /// Looks at the middle of the box around `points`, as near as all of them allow: they fill a picture of 4:3.
    pub fn filling(points: &[Vec3], from: Vec3, up: Vec3) -> View {
        let target = Aabb::around(points.iter().copied()).center();
        View::holding(points.iter().copied(), target, from, up, 1.0)
    }

    fn holding(points: impl Iterator<Item = Vec3>, target: Vec3, from: Vec3, up: Vec3, air: f32) -> View {
        const FOV_DEGREES: f32 = 30.0;
        const ASPECT: f32 = 4.0 / 3.0;
        let half = f64::from(FOV_DEGREES).to_radians() / 2.0;
        let tan = (libm::sin(half) / libm::cos(half)) as f32;

        let back = from.normalize_or(Vec3::Z);
        let right = up.cross(back).normalize_or(Vec3::X);
        let page_up = back.cross(right);
        // A point at (x, y) that lies z nearer than the target fits if the eye is |y| / tan + z away.
        let distance = points.map(|point| point - target).fold(0.0_f32, |distance, point| {
            let reach = (point.dot(page_up).abs()).max(point.dot(right).abs() / ASPECT);
            distance.max(reach * air / tan + point.dot(back))
        });
        // A scene that is one point is seen from a step away.
        let distance = if distance > 0.0 { distance } else { 1.0 };
        View { eye: target + back * distance, target, up, fov_degrees: FOV_DEGREES }
    }
}
