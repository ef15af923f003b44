//! A flat round plate in space.

use glam::{DVec3, Vec3};

use crate::objects::ray_plane::cut;
use crate::objects::{Cover, Part, Probe, plane_aabb};
use crate::{Aabb, Observer, Ray};

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
        Aabb::reaching(self.center, reach)
    }

    /// A small box around the part of its box that lies in `bounds`; empty if the plane passes beside.
    pub fn clip(&self, bounds: &Aabb) -> Aabb {
        let part = self.bounds().intersection(*bounds);
        if part.is_empty() {
            return part;
        }
        match plane_aabb::side(self.normal.as_dvec3(), self.center.as_dvec3(), &part, Part::Plane, &mut ()) {
            Cover::Across => part,
            Cover::Inside | Cover::Outside => Aabb::EMPTY,
        }
    }

    /// The t at which the ray's line meets it.
    pub(super) fn meet(&self, ray: &Ray, watch: &mut impl Observer<Probe>) -> Option<f32> {
        let (d, n) = (ray.d.as_dvec3(), self.normal.as_dvec3());
        let f = self.center.as_dvec3() - ray.o.as_dvec3();
        let t = cut(n, f, d, 0.0, watch)?;
        // Near enough to the centre.
        let (out2, r) = ((d * t - f).length_squared(), f64::from(self.radius));
        let inside = out2 <= r * r;
        let (value, high) = (out2 as f32, (r * r) as f32);
        watch.on(Probe::Compare { of: Part::Radius, value, low: 0.0, high, inside });
        inside.then_some(t as f32)
    }
}
