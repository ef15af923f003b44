//! What is but a dot in a picture of everything.

use raystep_accel::Aabb;

/// What is larger than this part of the scene is seen well enough in the picture of all of it.
const SMALL: f32 = 0.3;

/// A box with so much air around it, in parts of its size; nothing if it is large in the scene.
pub(super) fn small(bounds: Aabb, world: Aabb, air: f32) -> Option<Aabb> {
    let diagonal = bounds.extent().length();
    (diagonal > 0.0 && diagonal < SMALL * world.extent().length()).then(|| bounds.padded(diagonal * air))
}
