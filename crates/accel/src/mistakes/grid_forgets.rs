//! The grid walk that throws away a hit beyond the cell, though its mailbox will skip the primitive.

use crate::common::Mailbox;
use crate::grid::Crossing;
use crate::{Best, Ending, Grid, Hit, Observer, Primitives, Ray, Visit, Want, test};

pub(super) fn walk(grid: &Grid, prims: &impl Primitives, ray: &Ray, watch: &mut impl Observer<Visit>) -> Option<Hit> {
    let mut best = Best::new(Want::Nearest);
    let mut mailbox = Mailbox::new();
    let mut why = Ending::Outside;
    if let Some(mut crossing) = Crossing::begin(&grid.lattice, ray, watch) {
        why = loop {
            let (cell, refs) = grid.enter(&crossing, watch);
            for &prim in refs {
                if mailbox.holds(prim) {
                    watch.on(Visit::Skip { prim });
                    continue;
                }
                mailbox.put(prim);
                test(prims, prim, ray, &mut best, watch);
            }
            let t_far = crossing.t_far();
            if best.t() < t_far {
                break Ending::Settled;
            }
            if best.hit.is_some() {
                watch.on(Visit::Beyond { cell, t: best.t(), t_far });
            }
            // MISTAKE: a hit beyond the cell must be kept as the best so far.
            best = Best::new(Want::Nearest);
            if !crossing.step(watch) {
                break Ending::Exhausted;
            }
        };
    }
    watch.on(Visit::End { why, hit: best.hit.is_some(), t: best.t() });
    best.hit
}
