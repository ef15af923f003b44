//! A point and a polygon: how often a line from the point crosses its edges (Shimrat, "Algorithm 112:
//! position of point relative to polygon", 1962; Haines, "Point in polygon strategies", Graphics Gems IV, 1994).

use glam::{DVec2, DVec3, Vec3};

use super::{Probe, largest};
use crate::{Observer, Polygon};

impl Polygon<'_> {
    /// Whether the point lies in it, seen along its normal's largest component.
    pub fn holds(&self, p: Vec3, watch: &mut impl Observer<Probe>) -> bool {
        holds(self.corners, self.normal(), p.as_dvec3(), watch)
    }
}

/// Flattened along the largest component of its normal, the polygon keeps its inside.
pub(super) fn holds(corners: &[Vec3], normal: DVec3, p: DVec3, watch: &mut impl Observer<Probe>) -> bool {
    let z = largest(normal);
    let (x, y) = ((z + 1) % 3, (z + 2) % 3);
    let flat = |corner: Vec3| {
        let seen = corner.as_dvec3() - p;
        DVec2::new(seen[x], seen[y])
    };
    let mut crossings = 0;
    for (edge, &corner) in corners.iter().enumerate() {
        let (from, to) = (flat(corner), flat(corners[(edge + 1) % corners.len()]));
        // Only an edge that passes the point's height can be crossed. A corner at that height belongs to
        // the edge above it, so that no corner counts twice.
        let passes = (from.y < 0.0) != (to.y < 0.0);
        let at = if passes { from.x - from.y * (to.x - from.x) / (to.y - from.y) } else { f64::NAN };
        let crossed = at > 0.0;
        crossings += u32::from(crossed);
        let (from, to) = (from.y as f32, to.y as f32);
        watch.on(Probe::Edge { edge: edge as u32, from, to, at: at as f32, crossed });
    }
    let inside = crossings % 2 == 1;
    watch.on(Probe::Parity { crossings, inside });
    inside
}
