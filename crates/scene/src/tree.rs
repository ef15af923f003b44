//! A tree of triangles, grown from a seed.

use glam::Vec3;
use raystep_accel::{Mesh, Random};

/// How often branches fork: trunk, boughs, branches, twigs.
const LEVELS: u32 = 4;

/// Branches at each fork.
const FORKS: u32 = 5;

/// Leaves on a twig.
const LEAVES: u32 = 12;

/// One tree: z up, its foot at the origin, about ten metres high. The same seed grows the same tree.
pub fn tree(seed: u64) -> Mesh {
    let mut growing = Growing { random: Random::new(seed), mesh: Mesh::default() };
    growing.branch(Vec3::ZERO, Vec3::Z * 3.5, 0.28, 0);
    growing.mesh
}

struct Growing {
    random: Random,
    mesh: Mesh,
}

impl Growing {
    /// A branch, those that fork from it, and in the end leaves.
    fn branch(&mut self, from: Vec3, along: Vec3, radius: f32, level: u32) {
        self.tube(from, along, radius);
        if level == LEVELS {
            (0..LEAVES).for_each(|_| self.leaf(from, along));
            return;
        }
        for fork in 0..FORKS {
            // The first goes on nearly straight, the others lean out, and lower ones more.
            let (lean, place) = if fork == 0 { (0.25, 1.0) } else { (0.9, self.random.range(0.55, 0.95)) };
            let way = (along.normalize_or(Vec3::Z) + self.aside() * lean + Vec3::Z * 0.15).normalize_or(Vec3::Z);
            let length = along.length() * self.random.range(0.55, 0.75);
            self.branch(from + along * place, way * length, radius * 0.55, level + 1);
        }
    }

    /// Four sides, narrower towards the end.
    fn tube(&mut self, from: Vec3, along: Vec3, radius: f32) {
        let (u, v) = along.normalize_or(Vec3::Z).any_orthonormal_pair();
        let first = self.mesh.corners.len() as u32;
        for (foot, radius) in [(from, radius), (from + along, radius * 0.55)] {
            self.mesh.corners.extend([u, v, -u, -v].map(|side| foot + side * radius));
        }
        for side in 0..4 {
            let next = (side + 1) % 4;
            let [a, b, c, d] = [side, next, 4 + next, 4 + side].map(|corner| first + corner);
            self.mesh.triangles.extend([[a, b, c], [a, c, d]]);
        }
    }

    /// Two triangles, folded along the middle.
    fn leaf(&mut self, from: Vec3, along: Vec3) {
        let foot = from + along * self.random.range(0.2, 1.0);
        let out = (self.aside() + Vec3::Z * self.random.range(-0.4, 0.4)).normalize_or(Vec3::X);
        let (across, up) = out.any_orthonormal_pair();
        let size = self.random.range(0.16, 0.26);
        let first = self.mesh.corners.len() as u32;
        let middle = foot + out * size * 0.5;
        let side = across * size * 0.3;
        let fold = up * size * 0.1;
        self.mesh.corners.extend([foot, middle + side + fold, foot + out * size, middle - side + fold]);
        self.mesh.triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
    }

    /// A direction, anywhere.
    fn aside(&mut self) -> Vec3 {
        loop {
            let [x, y, z] = [0; 3].map(|_| self.random.range(-1.0, 1.0));
            let v = Vec3::new(x, y, z);
            let square = v.length_squared();
            if square > 0.05 && square <= 1.0 {
                return v / square.sqrt();
            }
        }
    }
}
