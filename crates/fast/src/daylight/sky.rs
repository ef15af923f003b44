//! The sky: its colours, its clouds, its light.

use glam::{Vec2, Vec3};

/// A sky with a sun. z is up.
pub(super) struct Sky {
    pub(super) sun: Vec3,
}

impl Sky {
    /// What is seen in a direction where nothing else is.
    pub(super) fn seen(&self, way: Vec3) -> Vec3 {
        let up = way.z.max(0.0);
        let blue = self.haze(way).lerp(Vec3::new(0.09, 0.22, 0.52), 1.0 - (1.0 - up.min(1.0)).powi(5));
        let near = way.dot(self.sun).max(0.0);
        let glow = Vec3::new(1.0, 0.82, 0.55) * (0.35 * near.powi(12) + 6.0 * near.powi(1500));
        // Clouds in one layer: the lower one looks, the further away they are.
        let clouds = if up > 0.02 {
            let at = Vec2::new(way.x, way.y) / (up + 0.12) * 1.3;
            let thick = (clouds(at) - 0.52).max(0.0) * 3.2;
            thick.min(1.0) * (up * 5.0).min(1.0) * 0.85
        } else {
            0.0
        };
        let white = Vec3::new(0.82, 0.79, 0.77) + glow * 0.5;
        (blue + glow).lerp(white, clouds)
    }

    /// What the air in a direction looks like, warmer towards the sun.
    pub(super) fn haze(&self, way: Vec3) -> Vec3 {
        let near = (0.5 + 0.5 * way.dot(self.sun)).powi(3);
        Vec3::new(0.30, 0.43, 0.62).lerp(Vec3::new(0.86, 0.68, 0.46), near)
    }

    /// The light of the sun.
    pub(super) fn sunlight(&self) -> Vec3 {
        Vec3::new(2.5, 1.95, 1.3)
    }

    /// The light of the sky.
    pub(super) fn light(&self) -> Vec3 {
        Vec3::new(0.30, 0.40, 0.60)
    }
}

/// How thick clouds are at a point of their layer, about 0 to 1.
fn clouds(at: Vec2) -> f32 {
    let (mut sum, mut at, mut part) = (0.0, at, 0.5);
    for _ in 0..5 {
        sum += part * noise(at);
        at = Vec2::new(at.x * 1.62 - at.y * 1.18, at.x * 1.18 + at.y * 1.62) + 3.1;
        part *= 0.5;
    }
    sum
}

/// Random numbers at whole places, blended in between.
fn noise(at: Vec2) -> f32 {
    let corner = at.floor();
    let within = at - corner;
    let blend = within * within * (3.0 - 2.0 * within);
    let number = |dx: i32, dy: i32| {
        let key = (corner.x as i32 + dx).wrapping_mul(374_761_393) ^ (corner.y as i32 + dy).wrapping_mul(668_265_263);
        let mixed = (key ^ (key >> 13)).wrapping_mul(1_274_126_177);
        (mixed >> 9 & 0xffff) as f32 / 65535.0
    };
    let low = number(0, 0) + (number(1, 0) - number(0, 0)) * blend.x;
    let high = number(0, 1) + (number(1, 1) - number(0, 1)) * blend.x;
    low + (high - low) * blend.y
}
