//! A ray and an axis-aligned box: the slab test of slide 13, the one that every structure uses.

use super::Watch;
use crate::{Aabb, Interval, Place, Ray, slab};

impl Aabb {
    /// The two t at which the ray's line enters and leaves it.
    pub(crate) fn crossing(&self, ray: &Ray, watch: &mut impl Watch) -> Option<[f32; 2]> {
        slab(self, ray, Interval::ALL, Place::World, watch).ends()
    }
}
