//! A hundred thousand times the same triangle: nothing can part them, and no builder may try for ever.

use glam::Vec3;
use raystep_accel::{Mesh, Prims};

use super::scenes::Case;

/// The scene's name.
pub const NAME: &str = "trial:a-hundred-thousand-alike";

/// So many they are.
const MANY: usize = 100_000;

/// The scene called [`NAME`].
pub(super) fn named(name: &str) -> Option<Case> {
    (name == NAME).then(|| {
        let corners = vec![Vec3::ZERO, Vec3::new(1.0, 0.3, 0.2), Vec3::new(0.2, 1.0, 0.7)];
        let mesh = Mesh { corners, triangles: vec![[0, 1, 2]; MANY] };
        Case { name: name.to_owned(), prims: Prims::Mesh(mesh), flat: false }
    })
}
