//! What a structure is asked.

use crate::{Hit, Observer, Primitives, Ray, Visit, Want};

/// What every structure of this crate can do with a ray: slides 7 and 21, whatever lies between.
pub trait Accel {
    /// The nearest hit in `[ray.t_min, ray.t_max]`: smallest `t`, then smallest [`PrimId`](crate::PrimId).
    ///
    /// `prims` must be the primitives that the structure was built over.
    fn intersect(&self, prims: &impl Primitives, ray: &Ray, watch: &mut impl Observer<Visit>) -> Option<Hit> {
        self.walk(prims, ray, Want::Nearest, watch)
    }

    /// Whether anything is hit in `[ray.t_min, ray.t_max]`; stops at the first hit found.
    fn occluded(&self, prims: &impl Primitives, ray: &Ray, watch: &mut impl Observer<Visit>) -> bool {
        self.walk(prims, ray, Want::Any, watch).is_some()
    }

    /// The walk behind both questions.
    fn walk(&self, prims: &impl Primitives, ray: &Ray, want: Want, watch: &mut impl Observer<Visit>) -> Option<Hit>;
}
