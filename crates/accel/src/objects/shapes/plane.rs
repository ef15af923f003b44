//! The plane.

use glam::Vec3;

/// All points `p` with `normal · (p − point) = 0`. The side that the normal points to is inside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// A point of it.
    pub point: Vec3,
    /// Across it, of any length but zero.
    pub normal: Vec3,
}
