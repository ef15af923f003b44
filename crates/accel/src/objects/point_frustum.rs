//! A point and a frustum: on the inner side of all six planes.

use glam::Vec3;

use super::{Frustum, Probe};
use crate::Observer;

impl Frustum {
    /// Whether the point is seen.
    pub fn holds(&self, p: Vec3, watch: &mut impl Observer<Probe>) -> bool {
        self.planes.iter().zip(Frustum::SIDES).all(|(plane, of)| plane.is_before(p, of, watch))
    }
}
