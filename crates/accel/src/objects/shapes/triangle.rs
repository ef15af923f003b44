//! The triangle.

use glam::Vec3;

use super::clip::{clip_polygon, clip_polygon_twice};
use crate::{Aabb, Axis};

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

    /// Small boxes around two parts of it: of what lies in `bounds`, that below `high` and that above `low`.
    pub fn clip_twice(&self, bounds: &Aabb, axis: Axis, sides: [f32; 2]) -> [Aabb; 2] {
        clip_polygon_twice(&[self.a, self.b, self.c], bounds, axis, sides)
    }
}
