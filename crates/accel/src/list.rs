//! Brute force, slides 7 and 21: the judge of everything else.

use crate::{Accel, Best, Ending, Hit, Observer, PrimId, Primitives, Ray, Visit, Want, test};

/// No structure at all: every ray tests every primitive.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct List;

impl Accel for List {
    fn walk(&self, prims: &impl Primitives, ray: &Ray, want: Want, watch: &mut impl Observer<Visit>) -> Option<Hit> {
        let mut best = Best::new(want);
        // Test every primitive, keep the closest.
        for prim in (0..prims.len() as u32).map(PrimId) {
            test(prims, prim, ray, &mut best, watch);
            if best.answered() {
                break;
            }
        }
        watch.on(Visit::End { why: Ending::Exhausted, hit: best.hit.is_some(), t: best.t() });
        best.hit
    }
}
