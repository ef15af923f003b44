//! Triangles in bulk, in plain arrays.

use glam::Vec3;

use super::Primitives;
use crate::{PrimId, Shape, Triangle};

/// Corners and the triangles that share them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// The corners, world space; finite.
    pub corners: Vec<Vec3>,
    /// Three indices into `corners` for each triangle.
    pub triangles: Vec<[u32; 3]>,
}

impl Mesh {
    /// One triangle.
    #[inline]
    pub fn triangle(&self, prim: PrimId) -> Triangle {
        let [a, b, c] = self.triangles[prim.index()].map(|corner| self.corners[corner as usize]);
        Triangle { a, b, c }
    }
}

impl Primitives for Mesh {
    #[inline]
    fn len(&self) -> usize {
        self.triangles.len()
    }

    #[inline]
    fn shape(&self, prim: PrimId) -> Shape<'_> {
        Shape::Triangle(self.triangle(prim))
    }
}
