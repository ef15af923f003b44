//! What the forest looks like: bark, leaves, needles and grass, each plant a little different.

use glam::Vec3;
use raystep_accel::Hit;
use raystep_fast::{Matter, Surface};
use raystep_scene::{Kind, Stuff, Woods};

/// The woods, as they look.
pub(super) struct Looks<'a>(pub(super) &'a Woods);

impl Surface for Looks<'_> {
    fn look(&self, hit: &Hit, point: Vec3) -> Matter {
        let woods = self.0;
        let triangle = hit.inner.map(|inner| woods.instances.triangle(hit.prim, inner));
        let across = triangle.map_or(Vec3::Z, |t| (t.b - t.a).cross(t.c - t.a));
        let normal = across.normalize_or(Vec3::Z);
        // Each plant has numbers of its own, 0 to 1.
        let own = hit.prim.0.wrapping_mul(2_654_435_761) >> 8;
        let part = |shift: u32| ((own >> shift) & 63) as f32 / 63.0;
        let (color, through) = match woods.stuff(hit) {
            Stuff::Ground => (self.ground(point, normal), 0.0),
            Stuff::Wood(Kind::Birch) => (birch(point), 0.0),
            Stuff::Wood(_) => (Vec3::new(0.16, 0.115, 0.08) * (0.8 + 0.5 * part(0)), 0.0),
            Stuff::Leaf(kind) => {
                let (one, other) = match kind {
                    Kind::Oak => (Vec3::new(0.075, 0.17, 0.03), Vec3::new(0.17, 0.23, 0.04)),
                    Kind::Maple => (Vec3::new(0.42, 0.20, 0.03), Vec3::new(0.44, 0.085, 0.03)),
                    Kind::Birch => (Vec3::new(0.19, 0.24, 0.04), Vec3::new(0.42, 0.32, 0.045)),
                    Kind::Spruce => (Vec3::new(0.035, 0.085, 0.045), Vec3::new(0.055, 0.12, 0.06)),
                };
                // Some maples have not turned yet.
                let turned = if kind == Kind::Maple && part(12) < 0.3 { 0.0 } else { part(0) };
                let green = kind == Kind::Maple && part(12) < 0.3;
                let color = if green { Vec3::new(0.14, 0.24, 0.04) } else { one.lerp(other, turned) };
                let high = woods.height_in(hit.prim, point);
                let through = if kind == Kind::Spruce { 0.15 } else { 0.55 };
                (color * (0.7 + 0.45 * high) * (0.85 + 0.3 * part(6)), through)
            }
        };
        Matter { normal, color, through }
    }
}

impl Looks<'_> {
    /// Meadow, drier up the slopes, bare where it is steep, and the floor of the wood under trees.
    fn ground(&self, point: Vec3, normal: Vec3) -> Vec3 {
        let land = &self.0.land;
        let patches = land.noise(point.x / 9.0, point.y / 9.0, 6);
        let fine = land.noise(point.x / 0.7, point.y / 0.7, 7);
        let fresh = Vec3::new(0.10, 0.17, 0.03).lerp(Vec3::new(0.22, 0.20, 0.06), 0.65 * patches + 0.35 * fine);
        let floor = Vec3::new(0.13, 0.09, 0.045).lerp(Vec3::new(0.20, 0.13, 0.05), fine);
        let wooded = ((land.wooded(point.x, point.y) - 0.35) * 5.0).clamp(0.0, 1.0);
        let steep = ((0.80 - normal.z.abs()) * 8.0).clamp(0.0, 1.0);
        fresh.lerp(floor, wooded).lerp(Vec3::new(0.27, 0.25, 0.23), steep) * (0.8 + 0.4 * fine)
    }
}

/// White bark with dark marks.
fn birch(point: Vec3) -> Vec3 {
    let marks = ((point.z * 9.0).floor() as i32).wrapping_mul(1_274_126_177) >> 16 & 7;
    if marks == 0 { Vec3::new(0.10, 0.09, 0.08) } else { Vec3::new(0.62, 0.60, 0.55) }
}
