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
    /// eight corners allow in a picture of 4:3.
    pub fn fitting(bounds: &Aabb, from: Vec3, up: Vec3) -> View {
        const FOV_DEGREES: f32 = 30.0;
        const ASPECT: f32 = 4.0 / 3.0;
        const AIR: f32 = 1.04;
        let half = f64::from(FOV_DEGREES).to_radians() / 2.0;
        let tan = (libm::sin(half) / libm::cos(half)) as f32;

        let bounds = if bounds.is_empty() { Aabb::new(Vec3::NEG_ONE, Vec3::ONE) } else { *bounds };
        let target = bounds.center();
        let back = from.normalize_or(Vec3::Z);
        let right = up.cross(back).normalize_or(Vec3::X);
        let page_up = back.cross(right);
        // A corner at (x, y) that lies z nearer than the target fits if the eye is |y| / tan + z away.
        let mut distance = 0.0_f32;
        for i in 0..8 {
            let pick = |bit: usize, low: f32, high: f32| if i >> bit & 1 == 0 { low } else { high };
            let corner = Vec3::new(
                pick(0, bounds.min.x, bounds.max.x),
                pick(1, bounds.min.y, bounds.max.y),
                pick(2, bounds.min.z, bounds.max.z),
            ) - target;
            let reach = (corner.dot(page_up).abs()).max(corner.dot(right).abs() / ASPECT);
            distance = distance.max(reach * AIR / tan + corner.dot(back));
        }
        // A scene that is one point is seen from a step away.
        let distance = if distance > 0.0 { distance } else { 1.0 };
        View { eye: target + back * distance, target, up, fov_degrees: FOV_DEGREES }
    }
}
