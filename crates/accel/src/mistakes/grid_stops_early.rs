//! The grid walk that stops at the first hit it finds (slide 16 read literally).

use crate::common::Mailbox;
use crate::grid::Crossing;
use crate::{Best, Ending, Grid, Hit, Observer, Primitives, Ray, Visit, Want, test};

pub(super) fn walk(grid: &Grid, prims: &impl Primitives, ray: &Ray, watch: &mut impl Observer<Visit>) -> Option<Hit> {
    let (mut best, mut mailbox) = (Best::new(Want::Nearest), Mailbox::new());
    let mut why = Ending::Outside;
    if let Some(mut crossing) = Crossing::begin(&grid.lattice, ray, watch) {
        why = loop {
            let (_, refs) = grid.enter(&crossing, watch);
            for &prim in refs {
                if grid.mailbox && mailbox.holds(prim) {
                    watch.on(Visit::Skip { prim });
                    continue;
                }
                mailbox.put(prim);
                test(prims, prim, ray, &mut best, watch);
            }
            // MISTAKE: the hit may lie beyond this cell, and something nearer in between.
            if best.hit.is_some() {
                break Ending::Settled;
            }
            if !crossing.step(watch) {
                break Ending::Exhausted;
            }
        };
    }
    watch.on(Visit::End { why, hit: best.hit.is_some(), t: best.t() });
    best.hit
}
