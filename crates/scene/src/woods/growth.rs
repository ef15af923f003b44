//! What grows: wood first, then leaves.

use glam::Vec3;
use raystep_accel::{Mesh, Random};

/// A tree that grows.
pub(super) struct Growth {
    pub(super) random: Random,
    wood: Mesh,
    leaves: Mesh,
}

impl Growth {
    pub(super) fn new(seed: u64) -> Growth {
        Growth { random: Random::new(seed), wood: Mesh::default(), leaves: Mesh::default() }
    }

    /// How many triangles of wood there are.
    pub(super) fn wood(&self) -> u32 {
        self.wood.triangles.len() as u32
    }

    /// A tube of so many sides, narrower towards its end.
    pub(super) fn tube(&mut self, from: Vec3, to: Vec3, radii: [f32; 2], sides: u32) {
        let (u, v) = (to - from).normalize_or(Vec3::Z).any_orthonormal_pair();
        let first = self.wood.corners.len() as u32;
        for (foot, radius) in [(from, radii[0]), (to, radii[1])] {
            for side in 0..sides {
                let angle = f64::from(side) / f64::from(sides) * std::f64::consts::TAU;
                let way = u * libm::cos(angle) as f32 + v * libm::sin(angle) as f32;
                self.wood.corners.push(foot + way * radius);
            }
        }
        for side in 0..sides {
            let next = (side + 1) % sides;
            let [a, b, c, d] = [side, next, sides + next, sides + side].map(|corner| first + corner);
            self.wood.triangles.extend([[a, b, c], [a, c, d]]);
        }
    }

    /// A leaf of two triangles, folded along its middle.
    pub(super) fn leaf(&mut self, foot: Vec3, out: Vec3, size: f32, wide: f32) {
        let (across, up) = out.any_orthonormal_pair();
        let first = self.leaves.corners.len() as u32;
        let middle = foot + out * size * 0.5;
        let (side, fold) = (across * size * wide, up * size * 0.12);
        self.leaves.corners.extend([foot, middle + side + fold, foot + out * size, middle - side + fold]);
        self.leaves.triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
    }

    /// A needle: one triangle.
    pub(super) fn needle(&mut self, foot: Vec3, way: Vec3, across: Vec3) {
        let first = self.leaves.corners.len() as u32;
        self.leaves.corners.extend([foot - across, foot + across, foot + way]);
        self.leaves.triangles.push([first, first + 1, first + 2]);
    }

    /// A direction, anywhere.
    pub(super) fn aside(&mut self) -> Vec3 {
        loop {
            let [x, y, z] = [0; 3].map(|_| self.random.range(-1.0, 1.0));
            let v = Vec3::new(x, y, z);
            let square = v.length_squared();
            if square > 0.05 && square <= 1.0 {
                return v / square.sqrt();
            }
        }
    }

    /// Wood and leaves in one mesh, and the number of its first leaf.
    pub(super) fn joined(self) -> (Mesh, u32) {
        let (mut mesh, leaves) = (self.wood, self.leaves);
        let (corners, first) = (mesh.corners.len() as u32, mesh.triangles.len() as u32);
        mesh.corners.extend(leaves.corners);
        mesh.triangles.extend(leaves.triangles.iter().map(|triangle| triangle.map(|corner| corners + corner)));
        (mesh, first)
    }
}
