//! The land: hills around a valley, as a function and as a mesh.

use glam::Vec3;
use raystep_accel::{Mesh, Random};

/// Hills around a valley that runs along y.
pub struct Land {
    seed: u64,
}

/// Half its width in metres, and how many squares the mesh has along a side.
const HALF: f32 = 1000.0;
const SQUARES: u32 = 400;

impl Land {
    pub(super) fn new() -> Land {
        Land { seed: 5 }
    }

    /// Half its width, in metres.
    pub fn half(&self) -> f32 {
        HALF
    }

    /// How high the ground lies.
    pub fn height(&self, x: f32, y: f32) -> f32 {
        let bend = self.bend(y);
        let beside = ((x - bend) / 420.0).abs();
        // Slopes on both sides, steeper further up, and higher hills at the far end.
        let slopes = 105.0 * smooth(beside.min(1.6) / 1.6) + 26.0 * beside;
        let far = 190.0 * smooth(((y - 250.0) / 750.0).clamp(0.0, 1.0));
        let hills = 70.0 * self.noise(x / 340.0, y / 340.0, 0) + 26.0 * self.noise(x / 120.0, y / 120.0, 1);
        let rough = smooth(beside.min(1.0)).max(0.12);
        slopes + far + hills * rough + 1.6 * self.noise(x / 17.0, y / 17.0, 2)
    }

    /// The middle of the valley at y.
    fn bend(&self, y: f32) -> f32 {
        130.0 * (self.noise(0.5, y / 420.0, 3) - 0.5)
    }

    /// How much trees like a place: little on the meadows along the valley and in clearings.
    pub fn wooded(&self, x: f32, y: f32) -> f32 {
        let meadow = 1.0 - ((x - self.bend(y)).abs() / 70.0).min(1.0);
        let clearing = self.noise(x / 90.0, y / 90.0, 4);
        0.5 + 0.5 * clearing - 1.1 * smooth(meadow)
    }

    /// From 0 up on the dry slopes, to 1 down by the meadows.
    pub fn damp(&self, x: f32, y: f32) -> f32 {
        let up = (self.height(x, y) / 190.0).clamp(0.0, 1.0);
        let patches = self.noise(x / 150.0, y / 150.0, 5) - 0.5;
        (0.85 - 0.6 * up + 0.7 * patches).clamp(0.0, 1.0)
    }

    /// Between 0 and 1, smooth, another one for each `layer`: random numbers at whole places, blended in between.
    pub fn noise(&self, x: f32, y: f32, layer: u64) -> f32 {
        let (left, below) = (x.floor(), y.floor());
        let at = |dx: i64, dy: i64| {
            let (i, j) = (left as i64 + dx, below as i64 + dy);
            let key = (i as u64).wrapping_mul(0x9e37_79b1) ^ (j as u64).wrapping_mul(0x85eb_ca77_0001);
            let mut random = Random::new(key ^ (self.seed + layer).wrapping_mul(0xc2b2_ae3d_27d4_eb4f));
            random.bits();
            random.unit()
        };
        let (u, v) = (smooth(x - left), smooth(y - below));
        let low = at(0, 0) + (at(1, 0) - at(0, 0)) * u;
        let high = at(0, 1) + (at(1, 1) - at(0, 1)) * u;
        low + (high - low) * v
    }

    /// Its triangles.
    pub(super) fn mesh(&self) -> Mesh {
        let side = SQUARES + 1;
        let step = 2.0 * HALF / SQUARES as f32;
        let corner = |n: u32| {
            let (x, y) = ((n % side) as f32 * step - HALF, (n / side) as f32 * step - HALF);
            Vec3::new(x, y, self.height(x, y))
        };
        let squares = (0..SQUARES * SQUARES).flat_map(|n| {
            let first = n / SQUARES * side + n % SQUARES;
            [[first, first + 1, first + side + 1], [first, first + side + 1, first + side]]
        });
        Mesh { corners: (0..side * side).map(corner).collect(), triangles: squares.collect() }
    }
}

/// From 0 to 1 without a kink.
fn smooth(x: f32) -> f32 {
    x * x * (3.0 - 2.0 * x)
}
