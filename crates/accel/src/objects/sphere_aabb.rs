//! A ball and a box: the point of the box nearest to the centre (Arvo, "A simple method for box-sphere
//! intersection testing", Graphics Gems, 1990).

use glam::DVec3;

use super::{Part, Probe};
use crate::{Aabb, Axis, Observer, Sphere};

impl Sphere {
    /// Whether ball and box share a point.
    pub fn overlaps(&self, bounds: &Aabb, watch: &mut impl Observer<Probe>) -> bool {
        let gap = self.gap(bounds, watch);
        self.reaches(gap, watch)
    }

    /// From the centre to the nearest point of the box, one axis after the other.
    #[inline]
    pub(crate) fn gap(&self, bounds: &Aabb, watch: &mut impl Observer<Probe>) -> DVec3 {
        let mut gap = DVec3::ZERO;
        for axis in Axis::ALL {
            let i = axis.index();
            let (center, low, high) = (self.center[axis], bounds.min[axis], bounds.max[axis]);
            let nearest = center.max(low).min(high);
            gap[i] = f64::from(nearest) - f64::from(center);
            watch.on(Probe::Nearest {
                of: Part::along(axis),
                value: center,
                low,
                high,
                nearest,
                gap: gap[i].abs() as f32,
            });
        }
        gap
    }

    /// Whether a point so far from the centre lies in the ball.
    #[inline]
    pub(crate) fn reaches(&self, off: DVec3, watch: &mut impl Observer<Probe>) -> bool {
        let r2 = f64::from(self.radius) * f64::from(self.radius);
        let inside = off.length_squared() <= r2;
        let (value, high) = (off.length_squared() as f32, r2 as f32);
        watch.on(Probe::Compare { of: Part::Radius, value, low: 0.0, high, inside });
        inside
    }
}
