//! The state of a walk after some of its events.

use raystep_accel::{
    Axis, CellId, Cost, Direction, Ending, Hit, Interval, NodeId, Observer, Place, PrimId, Side, Verdict, Visit,
};

use crate::moments::Walk;

/// The state of a walk after its first `step` events: nothing in it comes from later ones.
#[derive(Clone, Debug, PartialEq)]
pub struct Moment {
    /// How many events have happened.
    pub step: usize,
    /// The last of them: what this step shows. None before the walk.
    pub event: Option<Visit>,
    /// Where the walk stands: the node, cell or box last entered. None before the walk, after it, and when
    /// a node was just thrown away.
    pub here: Option<Place>,
    /// The interval of `here`, as it was entered.
    pub entered: Interval,
    /// The part of the ray under consideration: `entered`, or what a running slab test has left of it.
    /// After the walk, from the ray's beginning to its hit.
    pub live: Interval,
    /// Nodes that wait, the next one last.
    pub stack: Vec<Waiting>,
    /// Places entered and left again, in order of entering.
    pub seen: Vec<Place>,
    /// Nodes never to be opened: missed, cut off, thrown away.
    pub dropped: Vec<Place>,
    /// Volumes tested in the current place, in order.
    pub volumes: Vec<Tested>,
    /// The slab test under way or just finished.
    pub slab: Option<SlabTest>,
    /// The split of the current node, once its plane has met the ray.
    pub cut: Option<Cut>,
    /// The planes of the current node that the walk has met the ray with.
    pub(crate) planes: Vec<Cut>,
    /// The cells in whose grids the walk is, the coarse one first.
    pub within: Vec<CellId>,
    /// How the grid walk steps, as of its last step.
    pub stepping: Option<Stepping>,
    /// Primitives tested, in order; one without a mailbox may come twice.
    pub tested: Vec<PrimTest>,
    /// Primitives skipped by their mailbox in the current place.
    pub skipped: Vec<PrimId>,
    /// The best hit so far.
    pub best: Option<Hit>,
    /// The instance in whose own space the walk is, with the walk there. What happens there is counted here too.
    pub inside: Option<Box<Inside>>,
    /// Of the instance last left, the primitive of its model that was hit.
    pub(crate) met: Option<PrimId>,
    /// The cost so far.
    pub cost: Cost,
    /// Why the walk ended, if it has.
    pub ending: Option<Ending>,
    /// Possible answers to a question that is open at this step, with a word for each. The walk knows
    /// nothing of it: whoever asks puts them here.
    pub guesses: Vec<(Place, String)>,
}

/// A walk in an instance's own space: its nodes and primitives are those of the model.
#[derive(Clone, Debug, PartialEq)]
pub struct Inside {
    /// The instance.
    pub instance: PrimId,
    /// The walk there so far.
    pub moment: Moment,
}

/// A node on the stack.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Waiting {
    /// The node.
    pub node: NodeId,
    /// Where the ray enters it.
    pub near: f32,
    /// Where the ray leaves it.
    pub far: f32,
}

/// A volume that was tested.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tested {
    /// Whose volume.
    pub place: Place,
    /// The part of the ray in it; empty on a miss.
    pub interval: Interval,
    /// What became of it.
    pub verdict: Verdict,
}

/// A primitive that was tested.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PrimTest {
    /// The primitive.
    pub prim: PrimId,
    /// Where it was hit, if it was.
    pub t: Option<f32>,
}

/// A slab test as far as it has come.
#[derive(Clone, Debug, PartialEq)]
pub struct SlabTest {
    /// Whose volume is tested.
    pub place: Place,
    /// The direction under consideration.
    pub axis: Direction,
    /// What is known of each direction so far.
    pub cuts: Vec<SlabCut>,
    /// What the slabs have left of the interval.
    pub interval: Interval,
}

/// One direction of a slab test.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlabCut {
    /// The direction across which the planes stand.
    pub axis: Direction,
    /// The lower plane.
    pub low: f32,
    /// The upper plane.
    pub high: f32,
    /// Where the ray meets the two planes, ordered once the walk has ordered them; none if it runs
    /// parallel to them.
    pub t: Option<[f32; 2]>,
    /// For a parallel ray, whether it lies between the planes.
    pub inside: bool,
}

/// A split plane and what is known of the children.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cut {
    /// The node that is split.
    pub node: NodeId,
    /// The direction across which the plane stands.
    pub axis: Direction,
    /// Where on the axis it lies.
    pub plane: f32,
    /// Where the ray meets it.
    pub t: f32,
    /// The near and the far child and which of them the ray meets, once decided.
    pub children: Option<(NodeId, NodeId, Side)>,
}

/// The state of a grid walk.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stepping {
    /// The cell stepped out of.
    pub cell: CellId,
    /// The axis along which the walk stepped.
    pub axis: Axis,
    /// Where it stepped.
    pub t: f32,
    /// Where the ray meets the next plane of each axis.
    pub next: [f32; 3],
    /// From one plane to the next, along each axis.
    pub delta: [f32; 3],
    /// Whether the walk is still inside the grid.
    pub inside: bool,
}

impl Moment {
    /// The state before the walk.
    pub fn start(walk: &Walk<'_>) -> Moment {
        Moment {
            step: 0,
            event: None,
            here: None,
            entered: walk.ray.range(),
            live: walk.ray.range(),
            stack: Vec::new(),
            seen: Vec::new(),
            dropped: Vec::new(),
            volumes: Vec::new(),
            slab: None,
            cut: None,
            planes: Vec::new(),
            within: Vec::new(),
            stepping: None,
            tested: Vec::new(),
            skipped: Vec::new(),
            best: None,
            inside: None,
            met: None,
            cost: Cost::default(),
            ending: None,
            guesses: Vec::new(),
        }
    }

    /// The state after the first `step` events.
    pub fn at(walk: &Walk<'_>, step: usize) -> Moment {
        let mut moment = Moment::start(walk);
        moment.advance(walk, step);
        moment
    }

    /// Lets events happen until `step` have. Steps already taken are not taken back.
    pub fn advance(&mut self, walk: &Walk<'_>, step: usize) {
        let end = step.min(walk.events.len());
        for event in walk.events.get(self.step..end).unwrap_or_default() {
            self.happen(*event, walk);
        }
    }

    /// What the last test of a primitive found; none if it was not tested.
    pub fn test_of(&self, prim: PrimId) -> Option<PrimTest> {
        self.tested.iter().rev().find(|test| test.prim == prim).copied()
    }

    /// The volume whose test is under way or just finished.
    pub fn under_test(&self) -> Option<Place> {
        match self.event {
            Some(Visit::Roots { place, .. } | Visit::Clip { place, .. }) => Some(place),
            _ => self.slab.as_ref().map(|slab| slab.place),
        }
    }

    /// The position of a node on the stack: 0 is opened next.
    pub fn waiting(&self, node: NodeId) -> Option<usize> {
        self.stack.iter().rev().position(|waiting| waiting.node == node)
    }

    fn happen(&mut self, event: Visit, walk: &Walk<'_>) {
        self.step += 1;
        self.event = Some(event);
        self.cost.on(event);
        if let (Some(inside), false) = (&mut self.inside, matches!(event, Visit::World { .. })) {
            inside.moment.happen(event, walk);
            // The same t is the same point in both spaces.
            self.live = inside.moment.live;
            return;
        }
        match event {
            Visit::Parallel { place, axis, low, high, inside, .. } => {
                self.slab(place, axis).cuts.push(SlabCut { axis, low, high, t: None, inside });
            }
            Visit::Divide { place, axis, low, high, t1, t2, .. } => {
                self.slab(place, axis).cuts.push(SlabCut { axis, low, high, t: Some([t1, t2]), inside: true });
            }
            Visit::Order { place, axis, t1, t2, .. } => {
                if let Some(cut) = self.slab(place, axis).cuts.last_mut() {
                    cut.t = Some([t1, t2]);
                }
            }
            Visit::Narrow { place, axis, t_near, t_far, .. } => {
                self.slab(place, axis).interval = Interval::new(t_near, t_far);
                self.live = Interval::new(t_near, t_far);
            }
            Visit::Roots { t_near, t_far, .. } | Visit::Clip { t_near, t_far, .. } => {
                self.live = Interval::new(t_near, t_far);
            }
            Visit::Volume { place, t_near, t_far, verdict, .. } => {
                let interval = Interval::new(t_near, t_far);
                self.volumes.push(Tested { place, interval, verdict });
                self.live = if self.here.is_none_or(|here| here == place) { interval } else { self.entered };
                if verdict != Verdict::Hit {
                    self.dropped.push(place);
                    self.here.take_if(|here| *here == place);
                }
            }
            Visit::Enter { place, t_near, t_far, .. } => self.enter(place, Interval::new(t_near, t_far)),
            Visit::Plane { node, axis, plane, t, .. } => {
                self.rest();
                let cut = Cut { node, axis, plane, t, children: None };
                self.cut = Some(cut);
                self.planes.push(cut);
            }
            Visit::Split { node, near, far, side, .. } => {
                self.rest();
                if let Some(cut) = self.cut.as_mut().filter(|cut| cut.node == node) {
                    cut.children = Some((near, far, side));
                }
                match side {
                    Side::Both => {}
                    Side::Near => self.dropped.push(Place::Node(far)),
                    Side::Far => self.dropped.push(Place::Node(near)),
                }
            }
            Visit::Push { node, t_near, t_far, .. } => {
                self.rest();
                self.turn_to(t_near);
                self.stack.push(Waiting { node, near: t_near, far: t_far });
            }
            Visit::Pop { node, t_near, t_far, .. } => {
                self.stack.pop();
                self.enter(Place::Node(node), Interval::new(t_near, t_far));
            }
            Visit::Drop { node, .. } => {
                self.stack.pop();
                self.leave();
                self.live = Interval::new(f32::INFINITY, f32::NEG_INFINITY);
                self.dropped.push(Place::Node(node));
            }
            Visit::Step { cell, axis, t, next_x, next_y, next_z, delta_x, delta_y, delta_z, inside } => {
                self.rest();
                let (next, delta) = ([next_x, next_y, next_z], [delta_x, delta_y, delta_z]);
                self.stepping = Some(Stepping { cell, axis, t, next, delta, inside });
            }
            Visit::Descend { cell, .. } => {
                self.rest();
                self.within.push(cell);
            }
            Visit::Ascend { cell, t_near, t_far, .. } => {
                self.enter(Place::Cell(cell), Interval::new(t_near, t_far));
                self.within.pop();
            }
            Visit::Local { instance, t_near, t_far, .. } => {
                self.rest();
                let mut moment = Moment::start(walk);
                moment.entered = Interval::new(t_near, t_far);
                moment.rest();
                self.live = moment.live;
                self.inside = Some(Box::new(Inside { instance, moment }));
            }
            Visit::World { instance, t, hit } => {
                self.rest();
                let tests = self.inside.take().map(|inside| inside.moment.tested).unwrap_or_default();
                self.met = tests.iter().find(|test| hit && test.t == Some(t)).map(|test| test.prim);
                self.tested.push(PrimTest { prim: instance, t: hit.then_some(t) });
            }
            Visit::Probe { .. } | Visit::Beyond { .. } | Visit::Distant { .. } | Visit::Extreme { .. } => self.rest(),
            Visit::Skip { prim } => {
                self.rest();
                self.skipped.push(prim);
            }
            Visit::Test { prim, t, hit } => {
                self.rest();
                self.tested.push(PrimTest { prim, t: hit.then_some(t) });
            }
            Visit::Better { prim, t, .. } => self.best = Some(Hit { t, prim, inner: self.met }),
            Visit::End { why, hit, t } => {
                self.leave();
                self.seen.extend(self.within.drain(..).map(Place::Cell));
                self.dropped.extend(self.stack.drain(..).map(|waiting| Place::Node(waiting.node)));
                self.ending = Some(why);
                let far = if hit { t } else { f32::NEG_INFINITY };
                self.live = Interval::new(walk.ray.t_min, far);
            }
        }
    }

    /// The slab test of this volume, begun if another or none was under way.
    fn slab(&mut self, place: Place, axis: Direction) -> &mut SlabTest {
        let fresh = SlabTest { place, axis, cuts: Vec::new(), interval: self.entered };
        let running = self.slab.take().filter(|slab| slab.place == place && slab.axis <= axis);
        let slab = self.slab.insert(running.unwrap_or(fresh));
        slab.axis = axis;
        slab
    }

    /// A slab test is over: back to the interval of the current place.
    fn rest(&mut self) {
        self.slab = None;
        self.live = self.entered;
    }

    /// Of several planes of the current node, the one at which a child begins.
    fn turn_to(&mut self, t_near: f32) {
        if self.cut.is_some_and(|cut| cut.t != t_near) {
            self.cut = self.planes.iter().find(|cut| cut.t == t_near).copied().or(self.cut);
        }
    }

    /// The walk leaves where it is.
    fn leave(&mut self) {
        self.slab = None;
        self.cut = None;
        self.planes.clear();
        self.volumes.clear();
        self.skipped.clear();
        // A cell is not left while the walk is in its grid.
        let open = |place: &Place| self.within.iter().any(|cell| *place == Place::Cell(*cell));
        self.seen.extend(self.here.take().filter(|here| !open(here)));
    }

    fn enter(&mut self, place: Place, interval: Interval) {
        if self.here != Some(place) {
            self.leave();
            self.here = Some(place);
        }
        self.entered = interval;
        self.rest();
    }
}
