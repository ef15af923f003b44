//! What the walk of a packet has in common with that of a single ray.

use raystep_accel::{Interval, NodeId, Place, PrimId, Visit};

use crate::moments::{Moment, PacketMoment, PacketWalk, PrimTest, Waiting};

/// What the packet has in common with a single walk: where it is, what waits, what was left and what was tested.
pub(super) fn together(walk: &PacketWalk<'_>, moment: &PacketMoment) -> Option<Moment> {
    let here = moment.here.map(|(node, _)| node);
    let mut one = Moment::start(&walk.one(0)?);
    one.here = here.map(Place::Node);
    one.live = Interval { near: f32::INFINITY, far: f32::NEG_INFINITY };
    one.stack = moment.stack.iter().map(|&(node, _)| Waiting { node, near: 0.0, far: 0.0 }).collect();
    let left = moment.entered.iter().map(|(node, _)| *node).filter(|node| Some(*node) != here);
    let mut seen: Vec<NodeId> = Vec::new();
    for node in left {
        if !seen.contains(&node) {
            seen.push(node);
        }
    }
    one.seen = seen.into_iter().map(Place::Node).collect();
    one.dropped = moment.dropped.iter().copied().map(Place::Node).collect();
    // Hit by one ray is hit.
    let mut tested: Vec<PrimTest> = Vec::new();
    for &(prim, _, t) in &moment.tested {
        match tested.iter_mut().find(|test| test.prim == prim) {
            Some(test) => test.t = test.t.or(t),
            None => tested.push(PrimTest { prim, t }),
        }
    }
    one.tested = tested;
    one.guesses.clone_from(&moment.guesses);
    // What was just dropped says so.
    if let (None, Some((node, ..)), false) = (here, moment.taken, moment.over) {
        one.event = Some(Visit::Drop { node, t_near: 0.0, t_far: 0.0, best_t: 0.0, depth: 0 });
    }
    Some(one)
}

/// Whether a primitive is the best hit of any ray so far.
pub(super) fn is_best(moment: &PacketMoment, prim: PrimId) -> bool {
    moment.best.iter().flatten().any(|hit| hit.prim == prim)
}
