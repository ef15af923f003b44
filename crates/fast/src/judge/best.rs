//! The nearest hit so far.

use raystep_accel::{Hit, PrimId};

/// The nearest hit so far, or what any hit has to be: no further than the ray's end.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Nearest {
    /// Its t; the ray's largest t while there is none.
    pub(crate) t: f32,
    prim: u32,
}

/// The number of no triangle.
pub(crate) const NONE: u32 = u32::MAX;

impl Nearest {
    /// Nothing found yet.
    #[inline(always)]
    pub(crate) fn before(t_max: f32) -> Nearest {
        Nearest { t: t_max, prim: NONE }
    }

    /// What was found before: [`parts`](Nearest::parts).
    #[inline(always)]
    pub(crate) fn of(t: f32, prim: u32) -> Nearest {
        Nearest { t, prim }
    }

    /// The t, and the number of the triangle or of none.
    #[inline(always)]
    pub(crate) fn parts(self) -> (f32, u32) {
        (self.t, self.prim)
    }

    /// Keeps a hit within the ray's range if it is better: smaller t, or the same t and the smaller id.
    #[inline(always)]
    pub(crate) fn offer(&mut self, t: f32, prim: u32) {
        if t < self.t || (t == self.t && prim < self.prim) {
            *self = Nearest { t, prim };
        }
    }

    /// Whether anything was hit.
    #[inline(always)]
    pub(crate) fn is_some(&self) -> bool {
        self.prim != NONE
    }

    /// The hit.
    #[inline(always)]
    pub(crate) fn hit(&self) -> Option<Hit> {
        self.is_some().then_some(Hit { t: self.t, prim: PrimId(self.prim), inner: None })
    }
}
