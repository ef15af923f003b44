//! The cone.

use glam::Vec3;

use super::{Cylinder, Disc};
use crate::Aabb;
use crate::geometry::digits::direction;

/// From a point widening to a round base: its round side and its base are met. Without height it is not met
/// at all.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cone {
    /// Its tip.
    pub apex: Vec3,
    /// The middle of its base.
    pub base: Vec3,
    /// The radius of its base, not negative.
    pub radius: f32,
}

impl Cone {
    /// A small box around it: the one around base and apex.
    pub fn bounds(&self) -> Aabb {
        let normal = direction(self.base - self.apex).unwrap_or(Vec3::X);
        Disc { center: self.base, normal, radius: self.radius }.bounds().with_point(self.apex)
    }

    /// A small box around the part of its box that lies in `bounds`; empty if that lies outside the
    /// cylinder around it.
    pub fn clip(&self, bounds: &Aabb) -> Aabb {
        let around = Cylinder { from: self.apex, to: self.base, radius: self.radius };
        around.clip(&self.bounds().intersection(*bounds))
    }
}
