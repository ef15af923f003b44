//! A ray and a cone: the common part of an endless cone and of a slab between apex and base
//! (Eberly, "Intersection of a Line and a Cone").

use super::inside::Inside;
use super::{Part, Probe, quadratic};
use crate::{Cone, Observer, Ray};

impl Cone {
    /// The two t at which the ray's line enters and leaves it.
    pub(crate) fn meet(&self, ray: &Ray, watch: &mut impl Observer<Probe>) -> Option<[f32; 2]> {
        let apex = self.apex.as_dvec3();
        let axis = self.base.as_dvec3() - apex;
        let length2 = axis.length_squared();
        if length2 == 0.0 {
            return None;
        }
        let (f, d, r) = (ray.o.as_dvec3() - apex, ray.d.as_dvec3(), f64::from(self.radius));

        // At height h, from 0 at the apex to 1 at the base, the cone is r·h wide: |out|² = r²·h².
        let (f_along, d_along) = (f.dot(axis) / length2, d.dot(axis) / length2);
        let (f_out, d_out) = (f - axis * f_along, d - axis * d_along);
        let a = d_out.length_squared() - r * r * d_along * d_along;
        let b = f_out.dot(d_out) - r * r * f_along * d_along;
        let c = f_out.length_squared() - r * r * f_along * f_along;
        // The discriminant is the same from wherever the ray starts: from the point nearest to the apex
        // little cancels.
        let shift = f.dot(d) / d.length_squared();
        let (near_along, near_out) = (f_along - d_along * shift, f_out - d_out * shift);
        let near_b = near_out.dot(d_out) - r * r * near_along * d_along;
        let near_c = near_out.length_squared() - r * r * near_along * near_along;
        let exact = near_b * near_b - a * near_c;
        // A line steeper than the cone is always in it somewhere; rounding may say otherwise at the apex.
        let is_steep = a < 0.0;
        let discriminant = if is_steep && exact < 0.0 { 0.0 } else { exact };
        let [t1, t2] = quadratic::solve(Part::Surface, [a, b, c], discriminant, watch)?;

        // The equation knows two cones, one above the apex. The slab leaves the one below.
        let t = match (is_steep, d_along > 0.0) {
            (false, _) => [t1, t2],
            // Inside from the lower crossing on, or up to it.
            (true, true) => [t2, f64::INFINITY],
            (true, false) => [f64::NEG_INFINITY, t1],
        };
        Inside::ALL.narrow(Part::Surface, t, watch).between(f_along, d_along, 1.0, watch).ends()
    }
}
