//! A ray and a polygon: where it meets the plane, and whether that point lies inside (Badouel, "An
//! efficient ray-polygon intersection", Graphics Gems, 1990, for the flattening).

use super::ray_plane::{PARALLEL, cut};
use super::{Probe, point_polygon};
use crate::{Observer, Polygon, Ray};

impl Polygon<'_> {
    /// The t at which the ray's line meets it; a ray in its plane does not.
    pub(crate) fn meet(&self, ray: &Ray, watch: &mut impl Observer<Probe>) -> Option<f32> {
        let (o, d, normal) = (ray.o.as_dvec3(), ray.d.as_dvec3(), self.normal());
        let corner = self.corners.first()?.as_dvec3();
        let t = cut(normal, corner - o, d, PARALLEL * normal.length() * d.length(), watch)?;
        point_polygon::holds(self.corners, normal, o + d * t, watch).then_some(t as f32)
    }
}
