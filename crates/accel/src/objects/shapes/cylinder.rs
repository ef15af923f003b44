//! The cylinder.

use glam::Vec3;

use super::Disc;
use crate::Aabb;
use crate::geometry::digits::direction;

/// All points no further than `radius` from the segment between two ends, and between the ends: its round side
/// and both ends are met. Without length it is not met at all.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cylinder {
    /// The middle of one end.
    pub from: Vec3,
    /// The middle of the other end.
    pub to: Vec3,
    /// Its radius, not negative.
    pub radius: f32,
}

impl Cylinder {
    /// A small box around it: the one around both ends.
    pub fn bounds(&self) -> Aabb {
        let normal = direction(self.to - self.from).unwrap_or(Vec3::X);
        let end = |center: Vec3| Disc { center, normal, radius: self.radius }.bounds();
        end(self.from).union(end(self.to))
    }

    /// A small box around the part of its box that lies in `bounds`; empty if that lies beside the round side
    /// or beyond an end.
    pub fn clip(&self, bounds: &Aabb) -> Aabb {
        let part = self.bounds().intersection(*bounds);
        if part.is_empty() {
            return part;
        }
        let (min, max) = (part.min.as_dvec3(), part.max.as_dvec3());
        let half = (max - min) * 0.5;
        let axis = (self.to.as_dvec3() - self.from.as_dvec3()).normalize_or_zero();
        let f = (min + max) * 0.5 - self.from.as_dvec3();
        // Along the axis the box reaches so far on both sides of its middle.
        let (height, reach) = (f.dot(axis), axis.abs().dot(half));
        let length = (self.to.as_dvec3() - self.from.as_dvec3()).length();
        // Out from the axis no point of it lies further from the middle than a corner.
        let out = (f - axis * height).length() - half.length();
        let is_apart = height + reach < 0.0 || height - reach > length || out > f64::from(self.radius);
        if is_apart { Aabb::EMPTY } else { part }
    }
}
