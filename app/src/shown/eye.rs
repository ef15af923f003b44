//! How the camera moves: fitting, turning, shifting, coming nearer. Pure geometry.

use glam::{Quat, Vec2, Vec3};
use raystep_accel::Aabb;
use raystep_figure::Camera;
use raystep_lesson::Look;
use raystep_scene::Scene;

use super::camera::composed;

/// Where a stage is first seen from, in a picture of this size. `bounds` is what shall be seen.
pub(crate) fn home(look: Option<&Look>, scene: &Scene, bounds: &Aabb, size: Vec2) -> Camera {
    match look {
        Some(Look::Flat { center, half_height }) => Camera::Flat { center: *center, half_height: *half_height },
        Some(Look::Solid { eye, target, up, fov_degrees }) => {
            composed(Camera::Solid { eye: *eye, target: *target, up: *up, fov_degrees: *fov_degrees }, size)
        }
        None if scene.flat => fitted(bounds, size),
        None => {
            let view = scene.view;
            let (eye, target, up) = (view.eye, view.target, view.up);
            Camera::Solid { eye, target, up, fov_degrees: view.fov_degrees }.holding(bounds, size.x / size.y.max(1.0))
        }
    }
}

/// A flat camera that shows all of a box with a margin.
pub(crate) fn fitted(bounds: &Aabb, size: Vec2) -> Camera {
    let (center, half) = (bounds.center().truncate(), bounds.extent().truncate() * 0.5);
    let aspect = size.x / size.y.max(1.0);
    let half_height = half.y.max(half.x / aspect).max(1e-4) * 1.045;
    Camera::Flat { center, half_height }
}

/// The camera moved so that a box fills a good part of the picture.
pub(crate) fn framed(camera: &Camera, bounds: &Aabb, size: Vec2) -> Camera {
    match *camera {
        Camera::Flat { .. } => match fitted(bounds, size) {
            Camera::Flat { center, half_height } => Camera::Flat { center, half_height: half_height * 1.3 },
            other => other,
        },
        Camera::Solid { eye, target, up, fov_degrees } => {
            let away = (eye - target).normalize_or(Vec3::Z);
            let radius = bounds.extent().length() * 0.5;
            let distance = radius.max(1e-4) * 1.4 / (fov_degrees.to_radians() * 0.5).tan();
            let target = bounds.center();
            Camera::Solid { eye: target + away * distance, target, up, fov_degrees }
        }
    }
}

/// A camera, unless another one shows all of a box larger: then that one. Framing never makes anything smaller.
pub(crate) fn no_further(camera: Camera, home: Camera, bounds: &Aabb, size: Vec2) -> Camera {
    // How much of the picture the box takes, if all of it is seen.
    let share = |camera: &Camera| {
        let seen: Option<Vec<Vec2>> =
            bounds.corners().into_iter().map(|at| Some(camera.project(at, size)?.0)).collect();
        let seen = seen.filter(|seen| seen.iter().all(|at| at.cmpge(Vec2::ZERO).all() && at.cmple(size).all()))?;
        let low = seen.iter().copied().reduce(Vec2::min)?;
        let high = seen.iter().copied().reduce(Vec2::max)?;
        Some(((high - low) / size).max_element())
    };
    match (camera, home) {
        (Camera::Solid { .. }, Camera::Solid { .. }) if share(&home) > share(&camera) => home,
        (Camera::Flat { half_height, .. }, Camera::Flat { half_height: own, .. }) if half_height > own => home,
        _ => camera,
    }
}

/// Turned around its target by a drag over so much of the picture; a flat camera is shifted.
pub(crate) fn turned(camera: &Camera, drag: Vec2, size: Vec2) -> Camera {
    let Camera::Solid { eye, target, up, fov_degrees } = *camera else { return shifted(camera, drag, size) };
    let angle = drag / size.y.max(1.0) * std::f32::consts::PI;
    let away = eye - target;
    let right = up.cross(away).normalize_or(Vec3::X);
    let level = away.normalize_or(Vec3::Z).dot(up.normalize_or(Vec3::Y)).clamp(-1.0, 1.0).asin();
    // Never over the pole.
    let tilt = (level + angle.y).clamp(-1.5, 1.5) - level;
    let turn = Quat::from_axis_angle(up.normalize_or(Vec3::Y), -angle.x) * Quat::from_axis_angle(right, -tilt);
    Camera::Solid { eye: target + turn * away, target, up, fov_degrees }
}

/// Turned aside around its target, so that a ray from its eye is seen along its way.
pub(crate) fn aside(camera: &Camera) -> Camera {
    turned(camera, Vec2::new(0.22, 0.06), Vec2::ONE)
}

/// Shifted so that the picture follows the pointer.
pub(crate) fn shifted(camera: &Camera, drag: Vec2, size: Vec2) -> Camera {
    match *camera {
        Camera::Flat { center, half_height } => {
            let scale = 2.0 * half_height / size.y.max(1.0);
            Camera::Flat { center: center + Vec2::new(-drag.x, drag.y) * scale, half_height }
        }
        Camera::Solid { eye, target, up, fov_degrees } => {
            let away = eye - target;
            let right = up.cross(away).normalize_or(Vec3::X);
            let page_up = away.cross(right).normalize_or(Vec3::Y);
            let scale = 2.0 * away.length() * (fov_degrees.to_radians() * 0.5).tan() / size.y.max(1.0);
            let by = (page_up * drag.y - right * drag.x) * scale;
            Camera::Solid { eye: eye + by, target: target + by, up, fov_degrees }
        }
    }
}

/// Nearer by a factor, keeping what lies under the pointer in its place.
pub(crate) fn nearer(camera: &Camera, factor: f32, pointer: Vec2, size: Vec2) -> Camera {
    match *camera {
        Camera::Flat { center, half_height } => {
            let at = on_plane(camera, pointer, size, Vec3::ZERO).truncate();
            Camera::Flat { center: at + (center - at) / factor, half_height: half_height / factor }
        }
        Camera::Solid { eye, target, up, fov_degrees } => {
            Camera::Solid { eye: target + (eye - target) / factor, target, up, fov_degrees }
        }
    }
}

/// The nearest and the furthest that a camera may come, in parts of the diagonal of what it looks at: nearer, single
/// precision shows; further, there is nothing to see.
const NEAREST: f32 = 2e-5;
const FURTHEST: f32 = 50.0;

/// The camera that is wanted, unless it comes too near to what it looks at or goes too far: then the one of before.
pub(crate) fn bounded(now: &Camera, wanted: Camera, around: &Aabb) -> Camera {
    let diagonal = around.extent().length();
    if !(diagonal > 0.0 && diagonal.is_finite()) {
        return wanted;
    }
    let reach = |camera: &Camera| match *camera {
        Camera::Flat { half_height, .. } => half_height,
        Camera::Solid { eye, target, .. } => eye.distance(target),
    };
    let away = |camera: &Camera| match *camera {
        Camera::Flat { center, .. } => center.distance(around.center().truncate()),
        Camera::Solid { target, .. } => target.distance(around.center()),
    };
    let (from, to) = (reach(now), reach(&wanted));
    let near = to < from && to < diagonal * NEAREST;
    let far = to > from && to > diagonal * FURTHEST;
    let lost = away(&wanted) > away(now) && away(&wanted) > diagonal * FURTHEST;
    if near || far || lost || !to.is_finite() { *now } else { wanted }
}

/// The point under the pointer on the plane through `through` that faces the camera.
pub(crate) fn on_plane(camera: &Camera, pointer: Vec2, size: Vec2, through: Vec3) -> Vec3 {
    let Ok(sight) = camera.ray(pointer, size) else { return through };
    let normal = match *camera {
        Camera::Flat { .. } => Vec3::Z,
        Camera::Solid { eye, target, .. } => (eye - target).normalize_or(Vec3::Z),
    };
    let slope = sight.d.dot(normal);
    if slope.abs() < 1e-6 {
        return through;
    }
    sight.at((through - sight.o).dot(normal) / slope)
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: Vec2 = Vec2::new(800.0, 600.0);

    fn solid() -> Camera {
        Camera::Solid { eye: Vec3::new(0.0, -5.0, 1.0), target: Vec3::ZERO, up: Vec3::Z, fov_degrees: 30.0 }
    }

    #[test]
    fn what_is_dragged_stays_under_the_pointer() {
        for camera in [Camera::Flat { center: Vec2::new(1.0, 2.0), half_height: 3.0 }, solid()] {
            let (from, to) = (Vec2::new(300.0, 200.0), Vec2::new(380.0, 260.0));
            let at = on_plane(&camera, from, SIZE, Vec3::ZERO);
            let moved = shifted(&camera, to - from, SIZE);
            let (page, _) = moved.project(at, SIZE).unwrap();
            assert!(page.distance(to) < 0.5, "{page}");
        }
    }

    #[test]
    fn zooming_keeps_the_point_under_the_pointer() {
        let camera = Camera::Flat { center: Vec2::new(1.0, 2.0), half_height: 3.0 };
        let pointer = Vec2::new(100.0, 500.0);
        let at = on_plane(&camera, pointer, SIZE, Vec3::ZERO);
        let (page, _) = nearer(&camera, 1.7, pointer, SIZE).project(at, SIZE).unwrap();
        assert!(page.distance(pointer) < 0.1);
    }

    #[test]
    fn zooming_ends_before_numbers_do() {
        let around = Aabb { min: Vec3::ZERO, max: Vec3::new(10.0, 6.0, 0.0) };
        for factor in [1.3, 1.0 / 1.3] {
            for mut camera in [Camera::Flat { center: Vec2::new(1.0, 2.0), half_height: 3.0 }, solid()] {
                for _ in 0..1000 {
                    camera = bounded(&camera, nearer(&camera, factor, Vec2::new(100.0, 500.0), SIZE), &around);
                }
                let reach = match camera {
                    Camera::Flat { half_height, .. } => half_height,
                    Camera::Solid { eye, target, .. } => eye.distance(target),
                };
                assert!((1e-4..1000.0).contains(&reach), "{reach}");
                let back = nearer(&camera, 1.0 / factor, Vec2::new(100.0, 500.0), SIZE);
                assert_eq!(bounded(&camera, back, &around), back, "the way back is open");
            }
        }
    }

    #[test]
    fn turning_keeps_the_distance_and_stops_before_the_pole() {
        let Camera::Solid { eye, .. } = turned(&solid(), Vec2::new(500.0, 5000.0), SIZE) else { panic!() };
        assert!((eye.length() - 26.0_f32.sqrt()).abs() < 1e-3);
        assert!(eye.normalize().z < 0.999);
    }
}
