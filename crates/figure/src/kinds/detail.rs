//! What is but a dot in a picture of everything.

use glam::Vec3;
use raystep_accel::Aabb;

/// What a small picture from near shows.
#[derive(Clone, Debug, PartialEq)]
pub struct Detail {
    /// What it is called.
    pub title: String,
    /// A box with some of what lies around it.
    pub bounds: Aabb,
    /// The point that must be seen better in it than in the large picture.
    pub focus: Vec3,
}

/// What is larger than this part of the scene is seen well enough in the picture of all of it.
const SMALL: f32 = 0.3;

/// A box with so much air around it, in parts of its size; nothing if it is large in the scene.
pub(super) fn small(bounds: Aabb, world: Aabb, air: f32) -> Option<Aabb> {
    let diagonal = bounds.extent().length();
    (diagonal > 0.0 && diagonal < SMALL * world.extent().length()).then(|| bounds.padded(diagonal * air))
}
