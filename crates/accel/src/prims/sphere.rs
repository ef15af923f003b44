//! The sphere; in a flat scene, a disc of the plane.

use glam::Vec3;

use crate::{Aabb, Axis, Ray};

/// All points at `radius` from `center`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Its centre.
    pub center: Vec3,
    /// Its radius, not negative.
    pub radius: f32,
}

impl Sphere {
    /// The smallest box around it.
    pub fn bounds(&self) -> Aabb {
        Aabb { min: self.center - self.radius, max: self.center + self.radius }
    }

    /// A small box around the part of the ball that lies in `bounds`.
    pub fn clip(&self, bounds: &Aabb) -> Aabb {
        let part = self.bounds().intersection(*bounds);
        if part.is_empty() {
            return part;
        }
        let center = self.center.as_dvec3();
        let r2 = f64::from(self.radius) * f64::from(self.radius);
        // From the centre to the nearest point of the box.
        let off = center.clamp(part.min.as_dvec3(), part.max.as_dvec3()) - center;
        if off.length_squared() > r2 {
            return Aabb::EMPTY;
        }
        // On each axis the ball reaches as far as its disc at the nearest point of the other two.
        let mut shrunk = part;
        for axis in Axis::ALL {
            let i = axis.index();
            let half = (r2 - (off.length_squared() - off[i] * off[i])).max(0.0).sqrt();
            shrunk.min[axis] = part.min[axis].max((center[i] - half) as f32);
            shrunk.max[axis] = part.max[axis].min((center[i] + half) as f32);
        }
        shrunk
    }

    /// The two t at which the ray's line enters and leaves it. In double precision: near the rim a
    /// rounding error of the discriminant would move them far along the ray.
    pub(super) fn meet(&self, ray: &Ray) -> Option<[f32; 2]> {
        let d = ray.d.as_dvec3();
        let f = ray.o.as_dvec3() - self.center.as_dvec3();
        let r = f64::from(self.radius);
        // |f + t·d|² = r² has the form a·t² + 2·b·t + c = 0.
        let a = d.length_squared();
        let b = f.dot(d);
        let nearest = f - d * (b / a);
        let discriminant = a * (r * r - nearest.length_squared());
        if discriminant < 0.0 {
            return None;
        }
        // The root that adds, so that nothing cancels; the other follows from their product.
        let c = f.length_squared() - r * r;
        let q = -(b + discriminant.sqrt().copysign(b));
        let (t1, t2) = (q / a, if q == 0.0 { 0.0 } else { c / q });
        Some(if t1 <= t2 { [t1 as f32, t2 as f32] } else { [t2 as f32, t1 as f32] })
    }
}
