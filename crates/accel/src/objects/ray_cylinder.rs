//! A ray and a cylinder: the common part of a round tube and of a slab between its ends (Ericson,
//! "Real-Time Collision Detection", section 5.3.7; Cychosz and Waggenspack, Graphics Gems IV, 1994).

use super::inside::Inside;
use super::ray_plane::PARALLEL;
use super::{Part, Probe, quadratic};
use crate::{Cylinder, Observer, Ray};

impl Cylinder {
    /// The two t at which the ray's line enters and leaves it.
    pub(crate) fn meet(&self, ray: &Ray, watch: &mut impl Observer<Probe>) -> Option<[f32; 2]> {
        let from = self.from.as_dvec3();
        let axis = self.to.as_dvec3() - from;
        let length2 = axis.length_squared();
        if length2 == 0.0 {
            return None;
        }
        let (f, d, r) = (ray.o.as_dvec3() - from, ray.d.as_dvec3(), f64::from(self.radius));

        // Seen along the axis the tube is a circle: leave out what runs along it.
        let (f_along, d_along) = (f.dot(axis) / length2, d.dot(axis) / length2);
        let (f_out, d_out) = (f - axis * f_along, d - axis * d_along);
        let (a, b, c) = (d_out.length_squared(), f_out.dot(d_out), f_out.length_squared() - r * r);
        let inside = if a <= PARALLEL * PARALLEL * d.length_squared() {
            // Along the tube: in it for ever or never.
            let inside = c <= 0.0;
            let (value, high) = (f_out.length_squared() as f32, (r * r) as f32);
            watch.on(Probe::Compare { of: Part::Radius, value, low: 0.0, high, inside });
            inside.then_some(Inside::ALL)?
        } else {
            let nearest = f_out - d_out * (b / a);
            let discriminant = a * (r * r - nearest.length_squared());
            let t = quadratic::solve(Part::Surface, [a, b, c], discriminant, watch)?;
            Inside::ALL.narrow(Part::Surface, t, watch)
        };
        // Between the ends, where the height runs from 0 to 1.
        inside.between(f_along, d_along, 1.0, watch).ends()
    }
}
