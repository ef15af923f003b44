//! Two oriented boxes: fifteen directions in which they may be apart (Gottschalk, Lin and Manocha,
//! "OBBTree: a hierarchical structure for rapid interference detection", 1996).

use glam::{DVec3, Vec3};

use super::{Part, Probe};
use crate::{Aabb, Obb, Observer};

/// Edges this near to parallel have no direction across both; the faces decide then.
const PARALLEL: f64 = 1e-12;

impl Obb {
    /// Whether the two share a point.
    pub fn overlaps(&self, other: &Obb, watch: &mut impl Observer<Probe>) -> bool {
        let [a, b] = [self, other].map(|solid| solid.axes.map(Vec3::as_dvec3));
        let (a_half, b_half) = (self.half.as_dvec3(), other.half.as_dvec3());
        let between = other.center.as_dvec3() - self.center.as_dvec3();

        // How far a box reaches along a direction, from its middle.
        let reach = |axes: &[DVec3; 3], half: DVec3, along: DVec3| {
            axes[0].dot(along).abs() * half.x + axes[1].dot(along).abs() * half.y + axes[2].dot(along).abs() * half.z
        };
        let mut overlap_along = |of: Part, along: DVec3| {
            let (a_reach, b_reach) = (reach(&a, a_half, along), reach(&b, b_half, along));
            // Seen from the middle of the first.
            let middle = between.dot(along);
            let apart = middle.abs() > a_reach + b_reach;
            let [x, y, z] = along.as_vec3().to_array();
            let (a_low, a_high) = (-a_reach as f32, a_reach as f32);
            let (b_low, b_high) = ((middle - b_reach) as f32, (middle + b_reach) as f32);
            watch.on(Probe::Shadow { of, x, y, z, a_low, a_high, b_low, b_high, apart });
            !apart
        };
        // The faces of each, then across an edge of each.
        a.iter().all(|&along| overlap_along(Part::First, along))
            && b.iter().all(|&along| overlap_along(Part::Second, along))
            && a.iter().all(|edge| {
                b.iter()
                    .map(|other| edge.cross(*other))
                    .all(|along| along.length_squared() <= PARALLEL || overlap_along(Part::Edges, along))
            })
    }

    /// A small box around the part of its box that lies in `bounds`; empty if the two are apart.
    pub fn clip(&self, bounds: &Aabb) -> Aabb {
        let part = self.bounds().intersection(*bounds);
        if part.is_empty() || self.overlaps(&Obb::from_aabb(&part), &mut ()) { part } else { Aabb::EMPTY }
    }
}
