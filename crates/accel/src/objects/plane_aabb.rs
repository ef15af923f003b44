//! A plane and a box: how far the box reaches along the normal (Ericson, "Real-Time Collision Detection",
//! section 5.2.3).

use glam::DVec3;

use super::{Cover, Part, Plane, Probe};
use crate::{Aabb, Observer};

impl Plane {
    /// On which side of the plane the box lies: outside is where the normal points away from.
    pub fn side(&self, bounds: &Aabb, watch: &mut impl Observer<Probe>) -> Cover {
        side(self.normal.as_dvec3(), self.point.as_dvec3(), bounds, Part::Plane, watch)
    }
}

/// On which side of the plane through `point` the box lies; touching is across.
#[inline]
pub(crate) fn side(normal: DVec3, point: DVec3, bounds: &Aabb, of: Part, watch: &mut impl Observer<Probe>) -> Cover {
    let (min, max) = (bounds.min.as_dvec3(), bounds.max.as_dvec3());
    // Along the normal the box reaches as far as its half sides do together.
    let distance = normal.dot((min + max) * 0.5 - point);
    let reach = normal.abs().dot((max - min) * 0.5);
    let cover = if distance > reach {
        Cover::Inside
    } else if distance < -reach {
        Cover::Outside
    } else {
        Cover::Across
    };
    watch.on(Probe::Side { of, distance: distance as f32, reach: reach as f32, cover });
    cover
}
