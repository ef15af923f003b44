//! The best hit so far, and the one way to test a primitive.

use super::Primitives;
use crate::{Observer, PrimId, Ray, Visit};

/// Which question a walk answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Want {
    /// The nearest hit.
    Nearest,
    /// Any hit: a shadow ray.
    Any,
}

/// The answer to "what does this ray meet first".
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Where along the ray, in lengths of `d`.
    pub t: f32,
    /// What is hit there.
    pub prim: PrimId,
    /// If that is an instance, which primitive of the model that it places.
    pub inner: Option<PrimId>,
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

    /// Whether any hit will do.
    #[inline]
    pub fn wants_any(&self) -> bool {
        self.want == Want::Any
    }

    /// Whether the walk has its answer already: any hit will do, and there is one.
    #[inline]
    pub fn answered(&self) -> bool {
        self.wants_any() && self.hit.is_some()
    }

    /// Whether everything from `t_near` on is too far to matter. Strict: at equal t the smaller id wins,
    /// and it may lie there.
    #[inline]
    pub fn rules_out(&self, t_near: f32) -> bool {
        self.t() < t_near
    }

    /// Keeps the hit if it is better: smaller t, or the same t and the smaller id.
    #[inline]
    pub fn offer(&mut self, found: Hit, watch: &mut impl Observer<Visit>) {
        let better = match self.hit {
            None => true,
            Some(hit) => found.t < hit.t || (found.t == hit.t && (found.prim, found.inner) < (hit.prim, hit.inner)),
        };
        if better {
            watch.on(Visit::Better { prim: found.prim, t: found.t, before: self.t() });
            self.hit = Some(found);
        }
    }
}

/// Tests one primitive and keeps the hit if it is better. Every structure tests through this function.
#[inline]
pub fn test(prims: &impl Primitives, prim: PrimId, ray: &Ray, best: &mut Best, watch: &mut impl Observer<Visit>) {
    prims.test(prim, ray, best, watch);
}
