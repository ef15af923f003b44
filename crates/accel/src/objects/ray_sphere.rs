//! A ray and a sphere: a quadratic equation (Ericson, "Real-Time Collision Detection", section 5.3.2; the
//! discriminant as in Haines et al., "Precision improvements for ray/sphere intersection", 2019).

use super::{Part, Probe, quadratic};
use crate::{Observer, Ray, Sphere};

impl Sphere {
    /// The two t at which the ray's line enters and leaves it. In double precision: near the rim a
    /// rounding error of the discriminant would move them far along the ray.
    pub(crate) fn meet(&self, ray: &Ray, watch: &mut impl Observer<Probe>) -> Option<[f32; 2]> {
        let d = ray.d.as_dvec3();
        let f = ray.o.as_dvec3() - self.center.as_dvec3();
        let r = f64::from(self.radius);
        // |f + t·d|² = r² has the form a·t² + 2·b·t + c = 0.
        let (a, b, c) = (d.length_squared(), f.dot(d), f.length_squared() - r * r);
        // How deep the point nearest to the centre lies inside.
        let nearest = f - d * (b / a);
        let discriminant = a * (r * r - nearest.length_squared());
        quadratic::solve(Part::Surface, [a, b, c], discriminant, watch).map(|t| t.map(|t| t as f32))
    }
}
