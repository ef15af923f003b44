//! The best hit so far, and the one way to test a primitive.

use crate::{Hit, Observer, PrimId, Primitives, Ray, Visit};

/// Which question a walk answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Want {
    /// The nearest hit.
    Nearest,
    /// Any hit: a shadow ray.
    Any,
}

/// The best hit so far: smallest t, then smallest id.
#[derive(Clone, Copy, Debug)]
pub struct Best {
    want: Want,
    /// The best hit so far.
    pub hit: Option<Hit>,
}

impl Best {
    /// Nothing found yet.
    #[inline]
    pub fn new(want: Want) -> Best {
        Best { want, hit: None }
    }

    /// Its t, or infinity while there is none.
    #[inline]
    pub fn t(&self) -> f32 {
        self.hit.map_or(f32::INFINITY, |hit| hit.t)
    }

    /// Whether the walk has its answer already: any hit will do, and there is one.
    #[inline]
    pub fn answered(&self) -> bool {
        self.want == Want::Any && self.hit.is_some()
    }

    /// Whether everything from `t_near` on is too far to matter. Strict: at equal t the smaller id wins,
    /// and it may lie there.
    #[inline]
    pub fn rules_out(&self, t_near: f32) -> bool {
        self.t() < t_near
    }
}

/// Tests one primitive and keeps the hit if it is better. Every structure tests through this function.
pub fn test(prims: &impl Primitives, prim: PrimId, ray: &Ray, best: &mut Best, watch: &mut impl Observer<Visit>) {
    let found = prims.intersect(prim, ray);
    watch.on(Visit::Test { prim, t: found.unwrap_or(f32::INFINITY), hit: found.is_some() });
    let Some(t) = found else { return };
    let better = match best.hit {
        None => true,
        Some(hit) => t < hit.t || (t == hit.t && prim < hit.prim),
    };
    if better {
        watch.on(Visit::Better { prim, t, before: best.t() });
        best.hit = Some(Hit { t, prim });
    }
}
