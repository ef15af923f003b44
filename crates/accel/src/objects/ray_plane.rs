//! A ray and a plane: one division (Ericson, "Real-Time Collision Detection", section 5.3.1).

use glam::DVec3;

use super::{Part, Plane, Probe};
use crate::{Observer, Ray};

/// The sine of the angle below which a ray counts as parallel to a surface: double precision would no
/// longer say where they meet.
pub(crate) const PARALLEL: f64 = 1e-10;

impl Plane {
    /// The t at which the ray's line meets it; a ray in the plane does not.
    pub(crate) fn meet(&self, ray: &Ray, watch: &mut impl Observer<Probe>) -> Option<f32> {
        let (normal, d) = (self.normal.as_dvec3(), ray.d.as_dvec3());
        let limit = PARALLEL * normal.length() * d.length();
        cut(normal, self.point.as_dvec3() - ray.o.as_dvec3(), d, limit, watch).map(|t| t as f32)
    }
}

/// Where a ray meets the plane through `point`, seen from the ray's origin; no answer up to a slant of `limit`.
#[inline]
pub(crate) fn cut(normal: DVec3, point: DVec3, d: DVec3, limit: f64, watch: &mut impl Observer<Probe>) -> Option<f64> {
    let of = Part::Plane;
    // How much one length of d climbs along the normal, and how much there is to climb.
    let (slant, height) = (normal.dot(d), normal.dot(point));
    if slant.abs() <= limit {
        watch.on(Probe::Parallel { of, slant: slant as f32, limit: limit as f32 });
        return None;
    }
    let t = height / slant;
    watch.on(Probe::Cut { of, height: height as f32, slant: slant as f32, t: t as f32 });
    Some(t)
}
