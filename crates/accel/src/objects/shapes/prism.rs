//! A polygon of the plane, standing upright: what a flat scene calls a triangle or a polygon.

use glam::Vec2;

use super::Wall;
use crate::Aabb;

/// The upright walls over the closed outline, between `z[0]` and `z[1]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Prism<'a> {
    /// The corners in order, x and y; at least three.
    pub outline: &'a [Vec2],
    /// Its foot and its head.
    pub z: [f32; 2],
}

impl Prism<'_> {
    /// The smallest box around it.
    pub fn bounds(&self) -> Aabb {
        self.walls().fold(Aabb::EMPTY, |all, wall| all.union(wall.bounds()))
    }

    /// A small box around the part of its walls that lies in `bounds`.
    pub fn clip(&self, bounds: &Aabb) -> Aabb {
        self.walls().fold(Aabb::EMPTY, |all, wall| {
            let part = wall.clip(bounds);
            if part.is_empty() { all } else { all.union(part) }
        })
    }

    /// Its walls, one for each edge of the outline.
    pub fn walls(&self) -> impl Iterator<Item = Wall> + '_ {
        let n = self.outline.len();
        (0..n).map(move |i| Wall { from: self.outline[i], to: self.outline[(i + 1) % n], z: self.z })
    }
}
