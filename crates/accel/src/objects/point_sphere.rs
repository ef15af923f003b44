//! A point and a ball: its distance from the centre, squared so that no root is taken.

use glam::Vec3;

use super::Probe;
use crate::{Observer, Sphere};

impl Sphere {
    /// Whether the point lies in the ball.
    pub fn holds(&self, p: Vec3, watch: &mut impl Observer<Probe>) -> bool {
        self.reaches(p.as_dvec3() - self.center.as_dvec3(), watch)
    }
}
