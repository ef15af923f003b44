//! The vocabulary of walks: what a ray does in any structure, in the order it does it.

use super::{CellId, NodeId, Place, PrimId, vocabulary, words};
use crate::{Axis, Direction};

words! {
    /// What became of a tested volume.
    pub enum Verdict {
        /// The ray meets it, near enough to matter.
        Hit = "hit",
        /// The ray misses it, or meets it outside the ray's own range.
        Miss = "miss",
        /// The ray meets it, but only behind the best hit.
        Cut = "cut",
    }

    /// Which children of a split the ray meets.
    pub enum Side {
        /// Both, the near one first.
        Both = "both",
        /// Only the near one.
        Near = "near",
        /// Only the far one.
        Far = "far",
    }

    /// What a slot of a hash table holds for the cell that is looked up.
    pub enum Probed {
        /// The cell itself.
        Found = "found",
        /// Nothing: the cell is empty.
        Empty = "empty",
        /// Another cell: the next slot may hold it.
        Taken = "taken",
    }

    /// Why a walk ended.
    pub enum Ending {
        /// Nothing is left to visit.
        Exhausted = "exhausted",
        /// The hit lies before everything that is left.
        Settled = "settled",
        /// The ray does not meet the structure's box.
        Outside = "outside",
        /// A shadow ray has found something.
        Found = "found",
    }

    /// How fine a step is.
    pub enum Grain {
        /// Every division and comparison.
        Arithmetic = "arithmetic",
        /// Every decision: which way, which first, what waits, what counts.
        Decision = "decision",
        /// Every node or cell.
        Visit = "visit",
    }
}

vocabulary! {
    /// One thing that a walk did. Ids and numbers that the algorithm had in hand, nothing computed for show.
    pub enum Visit {
        /// The ray runs parallel to a slab: it is inside for ever or never.
        Parallel ["slab.parallel"] { place: Place, axis: Direction, o: f32, low: f32, high: f32, inside: bool }
        /// The ray was cut by the two planes of a slab: `t1 = (low − o)/d`, `t2 = (high − o)/d`.
        Divide ["slab.divide"] { place: Place, axis: Direction, o: f32, d: f32, low: f32, high: f32, t1: f32, t2: f32 }
        /// The two cuts were ordered; `t1 ≤ t2` from here on.
        Order ["slab.order"] { place: Place, axis: Direction, t1: f32, t2: f32, swapped: bool }
        /// The interval was narrowed to what the slab leaves of it.
        Narrow ["slab.narrow"] { place: Place, axis: Direction, t1: f32, t2: f32, t_near: f32, t_far: f32, empty: bool }
        /// The ray was put into the equation of a sphere, `a·t² + 2·b·t + c = 0`; its two solutions are entry and exit.
        Roots ["roots"] { place: Place, a: f32, b: f32, c: f32, discriminant: f32, t1: f32, t2: f32, t_near: f32, t_far: f32, empty: bool }
        /// The interval was cut at the plane of a face: where the ray comes in there, or goes out.
        Clip ["clip"] { place: Place, face: u32, axis: Direction, o: f32, d: f32, plane: f32, t: f32, entering: bool, t_near: f32, t_far: f32, empty: bool }
        /// A volume was tested.
        Volume ["volume.hit", "volume.miss", "volume.cut"] { place: Place, t_near: f32, t_far: f32, best_t: f32, verdict: Verdict }
        /// An inner node, a leaf or a cell was entered, holding `prims` references (0 in inner nodes, and in cells
        /// with a grid of their own).
        Enter ["enter.inner", "enter.leaf", "enter.cell"] { place: Place, t_near: f32, t_far: f32, prims: u32, leaf: bool }
        /// The ray was cut by a split plane: `t = (plane − o)/d`.
        Plane ["plane"] { node: NodeId, axis: Direction, plane: f32, o: f32, d: f32, t: f32, t_near: f32, t_far: f32 }
        /// The children were ordered along the ray, and those it meets chosen.
        Split ["split.both", "split.near", "split.far"] { node: NodeId, near: NodeId, far: NodeId, t: f32, t_near: f32, t_far: f32, side: Side }
        /// A node was put on the stack with its interval; `depth` nodes wait now.
        Push ["push"] { node: NodeId, t_near: f32, t_far: f32, depth: u32 }
        /// A node was taken from the stack; `depth` nodes still wait.
        Pop ["pop"] { node: NodeId, t_near: f32, t_far: f32, depth: u32 }
        /// A node was taken from the stack and thrown away: the best hit lies before it.
        Drop ["drop"] { node: NodeId, t_near: f32, t_far: f32, best_t: f32, depth: u32 }
        /// The walk stepped over a cell's face: the smallest of the three next t says which axis.
        Step ["step"] { cell: CellId, axis: Axis, t: f32, next_x: f32, next_y: f32, next_z: f32, delta_x: f32, delta_y: f32, delta_z: f32, inside: bool }
        /// A cell holds a grid of its own, of `nx`·`ny`·`nz` cells: the walk goes through that first.
        Descend ["descend"] { cell: CellId, nx: u32, ny: u32, nz: u32, t_near: f32, t_far: f32 }
        /// The walk is through with the grid in a cell and back at that cell, whose three next t are as they were.
        Ascend ["ascend"] { cell: CellId, t_near: f32, t_far: f32, next_x: f32, next_y: f32, next_z: f32 }
        /// A slot of a hash table was looked at for a cell.
        Probe ["probe.found", "probe.empty", "probe.taken"] { cell: CellId, slot: u32, holds: Probed }
        /// A primitive was skipped: the ray's mailbox says that it was tested already.
        Skip ["skip"] { prim: PrimId }
        /// A primitive was tested; `t` is infinite on a miss.
        Test ["test.hit", "test.miss"] { prim: PrimId, t: f32, hit: bool }
        /// The hit is better than the best so far.
        Better ["better"] { prim: PrimId, t: f32, before: f32 }
        /// The hit found lies beyond the current cell: the walk may not stop yet.
        Beyond ["beyond"] { cell: CellId, t: f32, t_far: f32 }
        /// The ray was moved into the own space of an instance; what follows happens there.
        Local ["local"] { instance: PrimId, o_x: f32, o_y: f32, o_z: f32, d_x: f32, d_y: f32, d_z: f32, t_near: f32, t_far: f32 }
        /// The walk inside an instance is over, and the ray is back in the world: the same t is the same point.
        World ["world"] { instance: PrimId, t: f32, hit: bool }
        /// The ray starts further away than the structure's margin allows for: brute force answers.
        Distant ["distant"] { reach: f32 }
        /// The largest component of the ray's direction is too small or too large for the structure's numbers, which
        /// allow for what lies between `shortest` and `longest`: brute force answers.
        Extreme ["extreme"] { length: f32, shortest: f32, longest: f32 }
        /// The walk is over.
        End ["end.hit", "end.miss"] { why: Ending, hit: bool, t: f32 }
    }
}

impl Visit {
    /// What slides, listings and questions call this event.
    pub fn name(&self) -> &'static str {
        match self {
            Visit::Parallel { .. } => "slab.parallel",
            Visit::Divide { .. } => "slab.divide",
            Visit::Order { .. } => "slab.order",
            Visit::Narrow { .. } => "slab.narrow",
            Visit::Roots { .. } => "roots",
            Visit::Clip { .. } => "clip",
            Visit::Volume { verdict: Verdict::Hit, .. } => "volume.hit",
            Visit::Volume { verdict: Verdict::Miss, .. } => "volume.miss",
            Visit::Volume { verdict: Verdict::Cut, .. } => "volume.cut",
            Visit::Enter { place: Place::Cell(_), .. } => "enter.cell",
            Visit::Enter { leaf: true, .. } => "enter.leaf",
            Visit::Enter { .. } => "enter.inner",
            Visit::Plane { .. } => "plane",
            Visit::Split { side: Side::Both, .. } => "split.both",
            Visit::Split { side: Side::Near, .. } => "split.near",
            Visit::Split { side: Side::Far, .. } => "split.far",
            Visit::Push { .. } => "push",
            Visit::Pop { .. } => "pop",
            Visit::Drop { .. } => "drop",
            Visit::Step { .. } => "step",
            Visit::Descend { .. } => "descend",
            Visit::Ascend { .. } => "ascend",
            Visit::Probe { holds: Probed::Found, .. } => "probe.found",
            Visit::Probe { holds: Probed::Empty, .. } => "probe.empty",
            Visit::Probe { holds: Probed::Taken, .. } => "probe.taken",
            Visit::Skip { .. } => "skip",
            Visit::Test { hit: true, .. } => "test.hit",
            Visit::Test { hit: false, .. } => "test.miss",
            Visit::Better { .. } => "better",
            Visit::Beyond { .. } => "beyond",
            Visit::Local { .. } => "local",
            Visit::World { .. } => "world",
            Visit::Distant { .. } => "distant",
            Visit::Extreme { .. } => "extreme",
            Visit::End { hit: true, .. } => "end.hit",
            Visit::End { hit: false, .. } => "end.miss",
        }
    }

    /// How coarse the event is: stepping by decisions shows decisions and visits, and so on.
    pub fn grain(&self) -> Grain {
        match self {
            Visit::Parallel { .. }
            | Visit::Divide { .. }
            | Visit::Order { .. }
            | Visit::Narrow { .. }
            | Visit::Roots { .. }
            | Visit::Clip { .. } => Grain::Arithmetic,
            Visit::Enter { .. } | Visit::Local { .. } | Visit::End { .. } => Grain::Visit,
            _ => Grain::Decision,
        }
    }

    /// What the event is about.
    pub fn place(&self) -> Place {
        match *self {
            Visit::Parallel { place, .. }
            | Visit::Divide { place, .. }
            | Visit::Order { place, .. }
            | Visit::Narrow { place, .. }
            | Visit::Roots { place, .. }
            | Visit::Clip { place, .. }
            | Visit::Volume { place, .. }
            | Visit::Enter { place, .. } => place,
            Visit::Plane { node, .. }
            | Visit::Split { node, .. }
            | Visit::Push { node, .. }
            | Visit::Pop { node, .. }
            | Visit::Drop { node, .. } => Place::Node(node),
            Visit::Step { cell, .. }
            | Visit::Descend { cell, .. }
            | Visit::Ascend { cell, .. }
            | Visit::Probe { cell, .. }
            | Visit::Beyond { cell, .. } => Place::Cell(cell),
            Visit::Skip { prim } | Visit::Test { prim, .. } | Visit::Better { prim, .. } => Place::Prim(prim),
            Visit::Local { instance, .. } | Visit::World { instance, .. } => Place::Prim(instance),
            Visit::Distant { .. } | Visit::Extreme { .. } | Visit::End { .. } => Place::World,
        }
    }

    /// Whether the event concerns only the z axis, which flat scenes leave out.
    pub fn concerns_z(&self) -> bool {
        match self {
            Visit::Parallel { axis, .. }
            | Visit::Divide { axis, .. }
            | Visit::Order { axis, .. }
            | Visit::Narrow { axis, .. }
            | Visit::Clip { axis, .. } => axis.leaves_plane(),
            _ => false,
        }
    }
}
