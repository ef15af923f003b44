//! A camera made ready for one picture. Plain scalar arithmetic, so that every machine draws the same.

use glam::{Vec2, Vec3};

use super::Camera;

/// Projects points, lines and polygons onto a page of some size.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lens {
    size: Vec2,
    eye: Vec3,
    right: Vec3,
    up: Vec3,
    forward: Vec3,
    /// Points of the page for a length of one at distance one; without perspective, at any distance.
    scale: f32,
    /// Distance from the eye at which lines are cut off; none without perspective.
    near: Option<f32>,
}

impl Camera {
    /// The point of the page (points, y down) that shows `world`, and its depth (reverse z); nothing behind the eye.
    pub fn project(&self, world: Vec3, size: Vec2) -> Option<(Vec2, f32)> {
        Lens::new(self, size).point(world)
    }
}

impl Lens {
    pub(crate) fn new(camera: &Camera, size: Vec2) -> Lens {
        match *camera {
            Camera::Flat { center, half_height } => Lens {
                size,
                eye: center.extend(0.0),
                right: Vec3::X,
                up: Vec3::Y,
                forward: Vec3::NEG_Z,
                scale: size.y * 0.5 / half_height,
                near: None,
            },
            Camera::Solid { eye, target, up, fov_degrees } => {
                let forward = (target - eye).normalize_or_zero();
                let right = forward.cross(up).normalize_or_zero();
                let half = f64::from(fov_degrees.to_radians() * 0.5);
                let tan = (libm::sin(half) / libm::cos(half)) as f32;
                Lens {
                    size,
                    eye,
                    right,
                    up: right.cross(forward),
                    forward,
                    scale: size.y * 0.5 / tan,
                    near: Some(((target - eye).length() * 1e-3).max(1e-6)),
                }
            }
        }
    }

    /// Where a point is seen, and its depth: near plane / distance, or growing with z without perspective.
    pub(crate) fn point(&self, world: Vec3) -> Option<(Vec2, f32)> {
        let from_eye = world - self.eye;
        let (x, y, distance) = (from_eye.dot(self.right), from_eye.dot(self.up), from_eye.dot(self.forward));
        let (scale, depth) = match self.near {
            None => (self.scale, 0.5 - distance * 0.5e-4),
            Some(near) if distance >= near => (self.scale / distance, near / distance),
            Some(_) => return None,
        };
        Some((Vec2::new(self.size.x * 0.5 + x * scale, self.size.y * 0.5 - y * scale), depth))
    }

    /// A direction of the world as it is seen from far away: x to the right and y down, at most of length one.
    pub(crate) fn across(&self, direction: Vec3) -> Vec2 {
        Vec2::new(direction.dot(self.right), -direction.dot(self.up))
    }

    /// A line, without the part behind the eye.
    pub(crate) fn segment(&self, from: Vec3, to: Vec3) -> Option<[(Vec2, f32); 2]> {
        let [from, to] = self.in_front(from, to)?;
        Some([self.point(from)?, self.point(to)?])
    }

    /// A polygon, without the part behind the eye; nothing if that leaves no area.
    pub(crate) fn polygon(&self, corners: &[Vec3]) -> Option<Vec<Vec2>> {
        let mut points = Vec::with_capacity(corners.len() + 1);
        for (index, &from) in corners.iter().enumerate() {
            let to = corners[(index + 1) % corners.len()];
            if let Some([a, b]) = self.in_front(from, to) {
                for seen in [a, b].into_iter().filter_map(|p| self.point(p)) {
                    if points.last() != Some(&seen.0) {
                        points.push(seen.0);
                    }
                }
            }
        }
        if points.len() > 1 && points.first() == points.last() {
            points.pop();
        }
        (points.len() >= 3).then_some(points)
    }

    /// Where it stands.
    pub(crate) fn eye(&self) -> Vec3 {
        self.eye
    }

    /// How many points of the page a length of one has at a point.
    pub(crate) fn scale_at(&self, world: Vec3) -> f32 {
        match self.near {
            None => self.scale,
            Some(near) => self.scale / (world - self.eye).dot(self.forward).max(near),
        }
    }

    /// The part of a line that lies before the eye.
    fn in_front(&self, from: Vec3, to: Vec3) -> Option<[Vec3; 2]> {
        let Some(near) = self.near else { return Some([from, to]) };
        // A little further than the near plane, so that the cut end is on the safe side of rounding.
        let margin = near * 1.01;
        let (a, b) = ((from - self.eye).dot(self.forward) - margin, (to - self.eye).dot(self.forward) - margin);
        let cut = || from + (to - from) * (a / (a - b));
        match (a >= 0.0, b >= 0.0) {
            (true, true) => Some([from, to]),
            (true, false) => Some([from, cut()]),
            (false, true) => Some([cut(), to]),
            (false, false) => None,
        }
    }
}
