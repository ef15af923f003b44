//! A view frustum and a box (Assarsson and Möller, "Optimized view frustum culling algorithms for bounding
//! boxes", 2000).

use super::{Cover, Frustum, Probe, plane_aabb};
use crate::{Aabb, Observer};

impl Frustum {
    /// Whether the box is seen whole, in part or not at all. A box that lies outside but behind no single
    /// plane, near an edge of the frustum, counts as seen in part: culling draws it in vain, and loses nothing.
    pub fn sees(&self, bounds: &Aabb, watch: &mut impl Observer<Probe>) -> Cover {
        let mut cover = Cover::Inside;
        for (plane, of) in self.planes.iter().zip(Frustum::SIDES) {
            match plane_aabb::side(plane.normal.as_dvec3(), plane.point.as_dvec3(), bounds, of, watch) {
                Cover::Outside => return Cover::Outside,
                Cover::Across => cover = Cover::Across,
                Cover::Inside => {}
            }
        }
        cover
    }
}
