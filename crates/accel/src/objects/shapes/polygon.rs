//! A flat polygon in space.

use glam::{DVec3, Vec3};

use crate::Aabb;
use crate::objects::{Cover, Part, plane_aabb};

/// The inside of a closed outline, which need not be convex; met from both sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polygon<'a> {
    /// The corners in order, all in one plane; at least three.
    pub corners: &'a [Vec3],
}

impl Polygon<'_> {
    /// Across it, twice its area long (Newell's sum, as in Sutherland, Sproull and Schumacker 1974): a slight
    /// bend of the outline does not disturb it.
    pub fn normal(&self) -> DVec3 {
        let Some(first) = self.corners.first() else { return DVec3::ZERO };
        let seen = |corner: &Vec3| corner.as_dvec3() - first.as_dvec3();
        self.corners.windows(2).map(|edge| seen(&edge[0]).cross(seen(&edge[1]))).sum()
    }

    /// The smallest box around it.
    pub fn bounds(&self) -> Aabb {
        Aabb::around(self.corners.iter().copied())
    }

    /// A small box around the part of its box that lies in `bounds`; empty if its plane passes beside.
    pub fn clip(&self, bounds: &Aabb) -> Aabb {
        let part = self.bounds().intersection(*bounds);
        let (Some(first), false) = (self.corners.first(), part.is_empty()) else { return Aabb::EMPTY };
        match plane_aabb::side(self.normal(), first.as_dvec3(), &part, Part::Plane, &mut ()) {
            Cover::Across => part,
            Cover::Inside | Cover::Outside => Aabb::EMPTY,
        }
    }
}
