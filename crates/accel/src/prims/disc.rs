//! A flat round plate in space.

use glam::Vec3;

use crate::{Aabb, Ray};

/// All points of the plane through `center` with normal `normal` no further than `radius` from `center`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc {
    /// Its centre.
    pub center: Vec3,
    /// Its normal, length one.
    pub normal: Vec3,
    /// Its radius, not negative.
    pub radius: f32,
}

impl Disc {
    /// A small box around it: on each axis it reaches `radius·√(1 − n²)`, rounded outward.
    pub fn bounds(&self) -> Aabb {
        let n2 = self.normal * self.normal;
        let part = (Vec3::ONE - n2).max(Vec3::ZERO);
        let reach = self.radius * (Vec3::new(part.x.sqrt(), part.y.sqrt(), part.z.sqrt()) + 1e-6);
        Aabb { min: self.center - reach, max: self.center + reach }
    }

    /// A small box around the part of its box that lies in `bounds`; empty if the plane passes beside.
    pub fn clip(&self, bounds: &Aabb) -> Aabb {
        let part = self.bounds().intersection(*bounds);
        if part.is_empty() {
            return part;
        }
        // The plane meets the box if its distance from the middle is no more than the box's reach along the normal.
        let reach = self.normal.abs().dot(part.extent() * 0.5);
        if self.normal.dot(part.center() - self.center).abs() > reach { Aabb::EMPTY } else { part }
    }

    /// The t at which the ray's line meets it.
    pub(super) fn meet(&self, ray: &Ray) -> Option<f32> {
        let (o, d, n) = (ray.o.as_dvec3(), ray.d.as_dvec3(), self.normal.as_dvec3());
        let f = self.center.as_dvec3() - o;
        let slant = n.dot(d);
        if slant == 0.0 {
            return None;
        }
        let t = n.dot(f) / slant;
        let r = f64::from(self.radius);
        ((d * t - f).length_squared() <= r * r).then_some(t as f32)
    }
}
