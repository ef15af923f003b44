//! A flat round plate in space.

use glam::{DVec3, Vec3};

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
        let n2 = self.normal.as_dvec3() * self.normal.as_dvec3();
        // 1 − n² by the other two components, which does not cancel.
        let part = DVec3::new(n2.y + n2.z, n2.z + n2.x, n2.x + n2.y) / n2.element_sum();
        let reach = (DVec3::new(part.x.sqrt(), part.y.sqrt(), part.z.sqrt()) * f64::from(self.radius)).as_vec3()
            * (1.0 + 2.0 * f32::EPSILON);
        Aabb { min: self.center - reach, max: self.center + reach }
    }

    /// A small box around the part of its box that lies in `bounds`; empty if the plane passes beside.
    pub fn clip(&self, bounds: &Aabb) -> Aabb {
        let part = self.bounds().intersection(*bounds);
        if part.is_empty() {
            return part;
        }
        // The plane meets the box if its distance from the middle is no more than the box's reach along the normal.
        let (min, max, normal) = (part.min.as_dvec3(), part.max.as_dvec3(), self.normal.as_dvec3());
        let off = normal.dot((min + max) * 0.5 - self.center.as_dvec3());
        let reach = normal.abs().dot((max - min) * 0.5);
        if off.abs() > reach { Aabb::EMPTY } else { part }
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
