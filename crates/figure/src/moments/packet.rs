//! The walk of a packet that was recorded, and its state after some of its events.

use std::collections::BTreeMap;

use raystep_accel::{
    Aabb, Abreast, Cost, Direction, Fill, Hit, Interval, KdLayout, Lanes, NodeId, Observer, PacketStep, PacketVisit,
    Place, PrimId, Prims, Ray, Side, Structure, Verdict, Visit,
};

use super::Walk;
use crate::world::Nodes;

/// Everything that the views of one packet need.
#[derive(Clone, Copy)]
pub struct PacketWalk<'a> {
    /// What the rays walked through.
    pub structure: &'a Structure,
    /// What the structure was built over.
    pub prims: &'a Prims,
    /// The structure's nodes, as pictures need them.
    pub nodes: &'a Nodes,
    /// The rays, one a lane.
    pub rays: &'a [Ray],
    /// What they did, in order.
    pub events: &'a [PacketVisit],
    /// How many events more there were than are kept.
    pub lost: u64,
    /// What each ray costs that walks alone.
    pub alone: &'a [Cost],
    /// Whether the scene is flat.
    pub flat: bool,
}

impl<'a> PacketWalk<'a> {
    /// What the views of a single ray need of it: the walk of this lane, without what happened.
    pub(crate) fn one(&self, lane: usize) -> Option<Walk<'a>> {
        let PacketWalk { structure, prims, nodes, flat, .. } = *self;
        Some(Walk {
            structure,
            prims,
            nodes,
            ray: *self.rays.get(lane)?,
            events: &[],
            lost: 0,
            flat,
            layout: KdLayout::Compact,
        })
    }

    /// The box of a place.
    pub fn bounds(&self, place: Place) -> Aabb {
        self.one(0).map_or(Aabb::EMPTY, |walk| walk.bounds(place))
    }

    /// How many lanes there are, with and without a ray.
    pub fn width(&self) -> usize {
        self.events.first().map_or(self.rays.len(), |event| event.lanes.width())
    }
}

/// The state of a packet after its first `step` events: nothing in it comes from later ones.
#[derive(Clone, Debug, PartialEq)]
pub struct PacketMoment {
    /// How many events have happened.
    pub step: usize,
    /// The last of them. None before the walk.
    pub event: Option<PacketVisit>,
    /// The node where the packet stands, and who takes part in it.
    pub here: Option<(NodeId, Lanes)>,
    /// Nodes that wait with those who are to visit them, the next one last.
    pub stack: Vec<(NodeId, Lanes)>,
    /// Nodes entered, in order, with who took part.
    pub entered: Vec<(NodeId, Lanes)>,
    /// Nodes never to be opened.
    pub dropped: Vec<NodeId>,
    /// The part of each ray in each node as far as it is known, by node and lane.
    pub parts: BTreeMap<(NodeId, usize), Interval>,
    /// The plane that splits the current node, once a ray has met it.
    pub plane: Option<(NodeId, Direction, f32)>,
    /// The node last taken from the stack, for whom it waited, and for whom it was opened.
    pub taken: Option<(NodeId, Lanes, Lanes)>,
    /// Primitives tested, in order, each with the lane and where it was hit.
    pub tested: Vec<(PrimId, usize, Option<f32>)>,
    /// How many primitives were tested, once for all lanes.
    pub tests: u64,
    /// The best hit of each lane so far.
    pub best: [Option<Hit>; Lanes::MOST],
    /// Tests that mailboxes have saved.
    pub skips: u64,
    /// Visits, and who took part in them.
    pub fill: Fill,
    /// Whether the walk is over.
    pub over: bool,
    /// Possible answers to a question that is open at this step, with a word for each.
    pub guesses: Vec<(Place, String)>,
}

impl PacketMoment {
    /// The state before the walk.
    pub fn start() -> PacketMoment {
        PacketMoment {
            step: 0,
            event: None,
            here: None,
            stack: Vec::new(),
            entered: Vec::new(),
            dropped: Vec::new(),
            parts: BTreeMap::new(),
            plane: None,
            taken: None,
            tested: Vec::new(),
            tests: 0,
            best: [None; Lanes::MOST],
            skips: 0,
            fill: Fill::default(),
            over: false,
            guesses: Vec::new(),
        }
    }

    /// Lets events happen until `step` have. Steps already taken are not taken back.
    pub fn advance(&mut self, walk: &PacketWalk<'_>, step: usize) {
        let end = step.min(walk.events.len());
        for event in walk.events.get(self.step..end).unwrap_or_default() {
            self.happen(*event);
        }
    }

    /// Who took part in a node, was to visit it when it waited, or is there now; nobody where none came to it.
    pub fn lanes_of(&self, node: NodeId) -> Option<Lanes> {
        let here = self.here.filter(|(here, _)| *here == node);
        let waits = self.stack.iter().find(|(waits, _)| *waits == node);
        let entered = self.entered.iter().rev().find(|(entered, _)| *entered == node);
        here.or(waits.copied()).or(entered.copied()).map(|(_, lanes)| lanes)
    }

    /// The part of a ray in a node.
    pub fn part(&self, node: NodeId, lane: usize) -> Option<Interval> {
        self.parts.get(&(node, lane)).copied()
    }

    fn happen(&mut self, event: PacketVisit) {
        self.step += 1;
        self.event = Some(event);
        self.fill.on(event);
        match (event.step, event.lane()) {
            (PacketStep::Packet(abreast), _) => self.together(event.lanes, abreast),
            (PacketStep::Lane(visit), Some(lane)) => self.lane(lane, visit),
            (PacketStep::Lane(_), None) => {}
        }
    }

    /// What a lane computes for itself.
    fn lane(&mut self, lane: usize, visit: Visit) {
        match visit {
            Visit::Volume { place: Place::Node(node), t_near, t_far, verdict: Verdict::Hit, .. } => {
                self.parts.insert((node, lane), Interval::new(t_near, t_far));
            }
            Visit::Plane { node, axis, plane, .. } => self.plane = Some((node, axis, plane)),
            Visit::Split { near, far, t, t_near, t_far, side, .. } => {
                // Parallel to the plane and in it, the ray is on both sides all the way.
                let cut = |t: f32, or: f32| if t > t_near && t < t_far { t } else { or };
                let (near_part, far_part) =
                    (Interval::new(t_near, cut(t, t_far)), Interval::new(cut(t, t_near), t_far));
                match side {
                    Side::Both => {
                        self.parts.insert((near, lane), near_part);
                        self.parts.insert((far, lane), far_part);
                    }
                    Side::Near => _ = self.parts.insert((near, lane), Interval::new(t_near, t_far)),
                    Side::Far => _ = self.parts.insert((far, lane), Interval::new(t_near, t_far)),
                }
            }
            Visit::Test { prim, t, hit } => self.tested.push((prim, lane, hit.then_some(t))),
            Visit::World { instance, t, hit } => self.tested.push((instance, lane, hit.then_some(t))),
            Visit::Better { prim, t, .. } => self.best[lane] = Some(Hit { t, prim, inner: None }),
            Visit::Skip { .. } => self.skips += 1,
            _ => {}
        }
    }

    /// What all do together.
    fn together(&mut self, lanes: Lanes, abreast: Abreast) {
        match abreast {
            Abreast::Enter { node, .. } => {
                self.here = Some((node, lanes));
                self.plane = None;
                self.entered.push((node, lanes));
                self.taken.take_if(|(taken, ..)| *taken != node);
            }
            Abreast::Split { first, second, to_first, to_second, .. } => {
                self.dropped.extend(to_first.is_empty().then_some(first));
                self.dropped.extend(to_second.is_empty().then_some(second));
            }
            Abreast::Push { node, .. } => self.stack.push((node, lanes)),
            Abreast::Pop { node, waited, .. } => {
                self.stack.pop();
                self.here = Some((node, lanes));
                self.plane = None;
                self.taken = Some((node, waited, lanes));
            }
            Abreast::Drop { node, waited, .. } => {
                self.stack.pop();
                self.here = None;
                self.plane = None;
                self.dropped.push(node);
                self.taken = Some((node, waited, lanes));
            }
            Abreast::Test { .. } => self.tests += 1,
            Abreast::End { .. } => {
                self.here = None;
                self.taken = None;
                self.over = true;
            }
        }
    }
}
