//! The triangle.

use glam::Vec3;

use super::clip::clip_polygon;
use crate::Aabb;

/// Three corners; both sides are met.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle {
    /// First corner.
    pub a: Vec3,
    /// Second corner.
    pub b: Vec3,
    /// Third corner.
    pub c: Vec3,
}

impl Triangle {
    /// The smallest box around it.
    pub fn bounds(&self) -> Aabb {
        Aabb { min: self.a.min(self.b).min(self.c), max: self.a.max(self.b).max(self.c) }
    }

    /// A small box around the part of it that lies in `bounds`.
    pub fn clip(&self, bounds: &Aabb) -> Aabb {
        clip_polygon(&[self.a, self.b, self.c], bounds)
    }
}
