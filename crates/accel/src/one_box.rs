//! Only the box around everything: what slides 12 to 15 show.

use crate::{Aabb, Accel, Hit, Observer, Place, PrimId, Primitives, Ray, Verdict, Visit, Want, slab};

/// The box around all primitives, and nothing in it: a walk is one slab test, and its answer is the
/// verdict on the box. No primitive is ever hit, so this is no structure to compare with others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OneBox {
    /// The box.
    pub bounds: Aabb,
}

impl OneBox {
    /// The box around `prims`.
    pub fn around(prims: &impl Primitives) -> OneBox {
        let ids = (0..prims.len() as u32).map(PrimId);
        OneBox { bounds: ids.fold(Aabb::EMPTY, |all, prim| all.union(prims.bounds(prim))) }
    }
}

impl Accel for OneBox {
    fn walk(&self, _: &impl Primitives, ray: &Ray, _: Want, watch: &mut impl Observer<Visit>) -> Option<Hit> {
        if !self.bounds.is_empty() {
            let part = slab(&self.bounds, ray, ray.range(), Place::World, watch);
            let verdict = if part.is_empty() { Verdict::Miss } else { Verdict::Hit };
            let (t_near, t_far) = (part.near, part.far);
            watch.on(Visit::Volume { place: Place::World, t_near, t_far, best_t: f32::INFINITY, verdict });
        }
        None
    }
}
