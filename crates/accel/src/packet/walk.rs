//! What walks of packets have in common, whatever the tree.

use super::{Found, Packet};
use crate::common::Mailbox;
use crate::{
    Abreast, Best, Interval, Lanes, NodeId, Observer, PacketStep, PacketVisit, PrimId, Primitives, Ray, Visit, Want,
    test,
};

const EMPTY: Interval = Interval { near: f32::INFINITY, far: f32::NEG_INFINITY };

/// A node and, for every lane, the part of its ray that may lie in it: an empty one takes no part.
#[derive(Clone, Copy)]
pub(crate) struct Part {
    pub(crate) node: NodeId,
    pub(crate) live: [Interval; Lanes::MOST],
}

impl Part {
    /// A node that no lane has come to yet.
    pub(crate) fn new(node: NodeId) -> Part {
        Part { node, live: [EMPTY; Lanes::MOST] }
    }
}

/// A walk: the rays, what each has found, and the nodes that wait.
pub(crate) struct Walk<'a, P, W> {
    pub(crate) packet: Packet<'a>,
    pub(crate) prims: &'a P,
    pub(crate) best: [Best; Lanes::MOST],
    stack: Vec<Part>,
    watch: &'a mut W,
}

impl<'a, P: Primitives, W: Observer<PacketVisit>> Walk<'a, P, W> {
    pub(crate) fn new(packet: Packet<'a>, prims: &'a P, want: Want, watch: &'a mut W) -> Walk<'a, P, W> {
        Walk { packet, prims, best: [Best::new(want); Lanes::MOST], stack: Vec::new(), watch }
    }

    /// The lanes that have a ray.
    pub(crate) fn rays(&self) -> impl Iterator<Item = (usize, &'a Ray)> + use<'a, P, W> {
        self.packet.rays().iter().enumerate()
    }

    /// The lanes that take part, with their rays and their intervals.
    pub(crate) fn lanes(&self, here: &Part) -> impl Iterator<Item = (usize, &'a Ray, Interval)> + use<'a, P, W> {
        let (lanes, live) = (self.taking_part(here), here.live);
        self.rays().filter(move |&(lane, _)| lanes.has(lane)).map(move |(lane, ray)| (lane, ray, live[lane]))
    }

    /// Tells what a single lane does.
    pub(crate) fn lane(&mut self, lane: usize) -> OneLane<'_, W> {
        OneLane { lanes: Lanes::one(self.packet.width(), lane), watch: self.watch }
    }

    pub(crate) fn taking_part(&self, here: &Part) -> Lanes {
        Lanes::of(self.packet.width(), |lane| !here.live[lane].is_empty())
    }

    fn tell(&mut self, lanes: Lanes, abreast: Abreast) {
        self.watch.on(PacketVisit { lanes, step: PacketStep::Packet(abreast) });
    }

    /// The root, if any lane meets it.
    pub(crate) fn start(&self, root: Part) -> Option<Part> {
        (!self.taking_part(&root).is_empty()).then_some(root)
    }

    /// Enters a node, once for all its lanes.
    pub(crate) fn enter(&mut self, here: &Part, prims: u32, leaf: bool) {
        self.tell(self.taking_part(here), Abreast::Enter { node: here.node, prims, leaf });
    }

    /// Tests the primitives of a leaf, each by all lanes before the next one.
    pub(crate) fn test(&mut self, here: &Part, prims: &[PrimId], mut mailboxes: Option<&mut [Mailbox; Lanes::MOST]>) {
        for &prim in prims {
            let mut tested = Lanes::none(self.packet.width());
            let mut better = tested;
            for (lane, ray, _) in self.lanes(here) {
                // A shadow ray needs no second hit.
                if self.best[lane].answered() {
                    continue;
                }
                if let Some(mailboxes) = &mut mailboxes {
                    if mailboxes[lane].holds(prim) {
                        self.lane(lane).on(Visit::Skip { prim });
                        continue;
                    }
                    mailboxes[lane].put(prim);
                }
                let mut best = self.best[lane];
                test(self.prims, prim, ray, &mut best, &mut self.lane(lane));
                tested = tested.with(lane);
                if best.hit != self.best[lane].hit {
                    better = better.with(lane);
                }
                self.best[lane] = best;
            }
            if !tested.is_empty() {
                self.tell(tested, Abreast::Test { prim, better });
            }
        }
    }

    /// Goes on with the first child and lets the second wait, if any lane meets it.
    pub(crate) fn descend(&mut self, here: &Part, first: Part, second: Part) -> Option<Part> {
        let (to_first, to_second) = (self.taking_part(&first), self.taking_part(&second));
        let split = Abreast::Split {
            node: here.node,
            first: first.node,
            second: second.node,
            to_first,
            to_second,
            both: to_first.and(to_second),
        };
        self.tell(self.taking_part(here), split);
        match (to_first.is_empty(), to_second.is_empty()) {
            (true, true) => None,
            (false, true) => Some(first),
            (true, false) => Some(second),
            (false, false) => {
                self.stack.push(second);
                self.tell(to_second, Abreast::Push { node: second.node, depth: self.stack.len() as u32 });
                Some(first)
            }
        }
    }

    /// The next node that waits and that some lane still needs. A lane needs it no more if its best hit
    /// lies before its part of it.
    pub(crate) fn next(&mut self) -> Option<Part> {
        while let Some(mut part) = self.stack.pop() {
            let (node, waited, depth) = (part.node, self.taking_part(&part), self.stack.len() as u32);
            for lane in waited.iter() {
                if self.best[lane].answered() || self.best[lane].rules_out(part.live[lane].near) {
                    part.live[lane] = EMPTY;
                }
            }
            let lanes = self.taking_part(&part);
            if !lanes.is_empty() {
                self.tell(lanes, Abreast::Pop { node, waited, depth });
                return Some(part);
            }
            self.tell(lanes, Abreast::Drop { node, waited, depth });
        }
        None
    }

    /// The walk is over.
    pub(crate) fn end(mut self) -> Found {
        let width = self.packet.width();
        let hit = Lanes::of(width, |lane| self.best[lane].hit.is_some());
        self.tell(Lanes::of(width, |lane| lane < self.packet.rays().len()), Abreast::End { hit });
        self.best.map(|best| best.hit)
    }
}

/// Watches one lane and names it in every event.
pub(crate) struct OneLane<'a, W> {
    lanes: Lanes,
    watch: &'a mut W,
}

impl<W: Observer<PacketVisit>> Observer<Visit> for OneLane<'_, W> {
    fn on(&mut self, visit: Visit) {
        self.watch.on(PacketVisit { lanes: self.lanes, step: PacketStep::Lane(visit) });
    }
}
