//! What dragging and turning the wheel do to a camera, and where it stands at first.

use glam::{Vec2, Vec3};
use raystep_accel::Aabb;

use super::Camera;

/// So much more than a box has room in a picture that holds it.
const AIR: f32 = 1.04;

/// Directly above or below, up would be undefined.
const STEEPEST: f32 = 0.995;

impl Camera {
    /// A camera that shows all of a box in a picture of this aspect (width / height).
    pub fn frame(bounds: &Aabb, aspect: f32, flat: bool) -> Camera {
        let bounds = if bounds.is_empty() { Aabb::new(Vec3::splat(-1.0), Vec3::ONE) } else { *bounds };
        let (center, half) = (bounds.center(), bounds.extent() * 0.5);
        if flat {
            let half_height = half.y.max(half.x / aspect).max(1e-6) * 1.04;
            return Camera::Flat { center: center.truncate(), half_height };
        }
        // From the front, a little to the right and above; far enough for the sphere around the box.
        let fov_degrees = 35.0_f32;
        let angle = f64::from(fov_degrees.to_radians() * 0.5);
        let tan = (libm::sin(angle) / libm::cos(angle)) as f32 * aspect.min(1.0);
        let distance = half.length().max(1e-6) * 1.05 / tan;
        let eye = center + Vec3::new(0.55, 0.42, 0.9).normalize() * distance;
        Camera::Solid { eye, target: center, up: Vec3::Y, fov_degrees }
    }

    /// The same view from further back, if a box would reach out of a picture of this aspect (width / height). A
    /// flat camera stays where it is.
    pub fn holding(self, bounds: &Aabb, aspect: f32) -> Camera {
        let Camera::Solid { eye, target, up, fov_degrees } = self else { return self };
        let forward = (target - eye).normalize_or_zero();
        let right = forward.cross(up).normalize_or_zero();
        let page_up = right.cross(forward);
        let angle = f64::from(fov_degrees.to_radians() * 0.5);
        let tall = (libm::sin(angle) / libm::cos(angle)) as f32 / AIR;
        // Across the picture, how far out a plane under the angle of view must lie to have the box on its inner side.
        let sides = |along: Vec3, slope: f32| {
            let beyond = |along: Vec3| {
                bounds.corners().map(|p| p.dot(along) - p.dot(forward) * slope).into_iter().fold(f32::MIN, f32::max)
            };
            [beyond(-along), beyond(along)]
        };
        let (wide, high) = (sides(right, tall * aspect), sides(page_up, tall));
        let inside = |[low, high]: [f32; 2], along: Vec3, slope: f32| {
            let (across, depth) = (eye.dot(along), eye.dot(forward) * slope);
            -across - depth >= low && across - depth >= high
        };
        if bounds.is_empty() || (inside(wide, right, tall * aspect) && inside(high, page_up, tall)) {
            return self;
        }
        // The two planes meet where the eye may stand; it has both pairs of them to keep behind.
        let middle = |[low, high]: [f32; 2]| (high - low) * 0.5;
        let depth = |[low, high]: [f32; 2], slope: f32| -(low + high) * 0.5 / slope;
        let back = depth(wide, tall * aspect).min(depth(high, tall));
        let eye = right * middle(wide) + page_up * middle(high) + forward * back;
        let target = eye + forward * (bounds.center() - eye).dot(forward);
        Camera::Solid { eye, target, up, fov_degrees }
    }

    /// Turned around what it looks at by a drag of so many points: the scene follows the hand. A flat
    /// camera does not turn.
    pub fn orbit(self, drag: Vec2) -> Camera {
        let Camera::Solid { eye, target, up, fov_degrees } = self else { return self };
        let per_point = 0.008;
        let back = eye - target;
        let up = up.normalize_or(Vec3::Y);
        let turned = rotated(back, up, -drag.x * per_point);
        let right = up.cross(turned).normalize_or_zero();
        let tilted = rotated(turned, right, -drag.y * per_point);
        let steep = tilted.normalize_or_zero().dot(up).abs() > STEEPEST;
        Camera::Solid { eye: target + if steep { turned } else { tilted }, target, up, fov_degrees }
    }

    /// Moved so that the scene follows a drag of so many points in a picture of this size.
    pub fn pan(self, drag: Vec2, size: Vec2) -> Camera {
        match self {
            Camera::Flat { center, half_height } => {
                let world = 2.0 * half_height / size.y;
                Camera::Flat { center: center + Vec2::new(-drag.x, drag.y) * world, half_height }
            }
            Camera::Solid { eye, target, up, fov_degrees } => {
                let forward = (target - eye).normalize_or_zero();
                let right = forward.cross(up).normalize_or_zero();
                let angle = f64::from(fov_degrees.to_radians() * 0.5);
                let tan = (libm::sin(angle) / libm::cos(angle)) as f32;
                let world = 2.0 * (target - eye).length() * tan / size.y;
                let by = (right * -drag.x + right.cross(forward) * drag.y) * world;
                Camera::Solid { eye: eye + by, target: target + by, up, fov_degrees }
            }
        }
    }

    /// Nearer by `factor` (2 shows everything twice as large), keeping what lies under `at` in place.
    pub fn zoom(self, factor: f32, at: Vec2, size: Vec2) -> Camera {
        let factor = if factor.is_finite() { factor.clamp(0.05, 20.0) } else { 1.0 };
        match self {
            Camera::Flat { center, half_height } => {
                let from_middle = Vec2::new(at.x - size.x * 0.5, size.y * 0.5 - at.y) * (2.0 * half_height / size.y);
                let under = center + from_middle;
                let half_height = (half_height / factor).clamp(1e-5, 1e7);
                Camera::Flat { center: under - from_middle / factor, half_height }
            }
            Camera::Solid { eye, target, up, fov_degrees } => {
                let distance = ((eye - target).length() / factor).clamp(1e-4, 1e7);
                Camera::Solid { eye: target + (eye - target).normalize_or_zero() * distance, target, up, fov_degrees }
            }
        }
    }
}

/// `v` turned around the unit vector `axis` (Rodrigues).
fn rotated(v: Vec3, axis: Vec3, radians: f32) -> Vec3 {
    let (sin, cos) = (libm::sin(f64::from(radians)) as f32, libm::cos(f64::from(radians)) as f32);
    v * cos + axis.cross(v) * sin + axis * (axis.dot(v) * (1.0 - cos))
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: Vec2 = Vec2::new(800.0, 600.0);

    #[test]
    fn a_frame_shows_the_whole_box() {
        let bounds = Aabb::new(Vec3::new(-3.0, 1.0, -2.0), Vec3::new(5.0, 2.0, 7.0));
        for flat in [true, false] {
            let camera = Camera::frame(&bounds, SIZE.x / SIZE.y, flat);
            for corner in [bounds.min, bounds.max, Vec3::new(-3.0, 2.0, 7.0), Vec3::new(5.0, 1.0, -2.0)] {
                let (at, _) = camera.project(corner, SIZE).expect("before the eye");
                assert!(at.cmpge(Vec2::ZERO).all() && at.cmple(SIZE).all(), "{corner} at {at}");
            }
        }
    }

    #[test]
    fn a_camera_steps_back_until_it_holds_a_box() {
        let near = Camera::Solid { eye: Vec3::new(0.0, -9.0, 3.0), target: Vec3::ZERO, up: Vec3::Z, fov_degrees: 30.0 };
        let bounds = Aabb::new(Vec3::new(-6.0, -3.0, 0.0), Vec3::new(4.0, 7.0, 3.0));
        for size in [SIZE, Vec2::new(300.0, 700.0), Vec2::new(900.0, 200.0)] {
            let camera = near.holding(&bounds, size.x / size.y);
            let seen = bounds.corners().map(|corner| camera.project(corner, size).expect("before the eye").0);
            assert!(seen.iter().all(|at| at.cmpge(Vec2::ZERO).all() && at.cmple(size).all()), "{seen:?}");
            // As near as that allows: the box reaches two opposite edges.
            let low = seen.iter().copied().fold(Vec2::INFINITY, Vec2::min) / size;
            let high = Vec2::ONE - seen.iter().copied().fold(Vec2::ZERO, Vec2::max) / size;
            assert!(low.max(high).min_element() < 0.03, "{low} {high}");
            assert_eq!(camera.holding(&bounds, size.x / size.y), camera);
        }
    }

    #[test]
    fn zooming_keeps_the_point_under_the_pointer() {
        let camera = Camera::Flat { center: Vec2::new(1.0, 2.0), half_height: 3.0 };
        let at = Vec2::new(700.0, 100.0);
        let before = camera.ray(at, SIZE).expect("a ray").o;
        let after = camera.zoom(1.7, at, SIZE).ray(at, SIZE).expect("a ray").o;
        assert!((before - after).length() < 1e-3);
    }

    #[test]
    fn orbiting_keeps_the_distance_and_never_turns_over() {
        let mut camera = Camera::frame(&Aabb::new(Vec3::splat(-1.0), Vec3::ONE), 1.0, false);
        for _ in 0..100 {
            camera = camera.orbit(Vec2::new(7.0, 31.0));
            let Camera::Solid { eye, target, up, .. } = camera else { unreachable!("stays solid") };
            assert!(((eye - target).length() - 5.7).abs() < 1.0);
            assert!((eye - target).normalize().dot(up).abs() <= STEEPEST + 1e-3);
        }
    }

    #[test]
    fn a_ray_through_a_projected_point_meets_it() {
        let camera = Camera::frame(&Aabb::new(Vec3::splat(-1.0), Vec3::ONE), 1.3, false);
        let world = Vec3::new(0.3, -0.2, 0.6);
        let (page, _) = camera.project(world, SIZE).expect("before the eye");
        let ray = camera.ray(page, SIZE).expect("a ray");
        let off = (world - ray.o).cross(ray.d).length();
        assert!(off < 1e-3, "{off}");
    }
}
