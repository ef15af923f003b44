//! The sphere; in a flat scene, a disc of the plane.

use glam::Vec3;

use crate::{Aabb, Axis};

/// All points at `radius` from `center`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Its centre.
    pub center: Vec3,
    /// Its radius, not negative.
    pub radius: f32,
}

impl Sphere {
    /// The smallest box around it.
    pub fn bounds(&self) -> Aabb {
        Aabb::reaching(self.center, Vec3::splat(self.radius))
    }

    /// A small box around the part of the ball that lies in `bounds`.
    pub fn clip(&self, bounds: &Aabb) -> Aabb {
        let part = self.bounds().intersection(*bounds);
        if part.is_empty() {
            return part;
        }
        // From the centre to the nearest point of the box.
        let off = self.gap(&part, &mut ());
        if !self.reaches(off, &mut ()) {
            return Aabb::EMPTY;
        }
        let center = self.center.as_dvec3();
        let r2 = f64::from(self.radius) * f64::from(self.radius);
        // On each axis the ball reaches as far as its disc at the nearest point of the other two.
        let mut shrunk = part;
        for axis in Axis::ALL {
            let i = axis.index();
            let half = (r2 - (off.length_squared() - off[i] * off[i])).max(0.0).sqrt();
            shrunk.min[axis] = part.min[axis].max((center[i] - half) as f32);
            shrunk.max[axis] = part.max[axis].min((center[i] + half) as f32);
        }
        shrunk
    }
}
