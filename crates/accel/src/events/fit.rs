//! The vocabulary of fitting: how a volume comes to lie around a set.

use super::{CellId, Grain, NodeId, Observer, Place, PrimId, vocabulary, words};
use crate::{Aabb, Direction, Grow};

words! {
    /// Where the directions of an oriented box come from.
    pub enum FrameFrom {
        /// In which the set spreads most and least.
        Principal = "principal",
        /// Those of the world.
        World = "world",
        /// The best so far, two of them turned towards each other.
        Turned = "turned",
    }
}

vocabulary! {
    /// One thing that the fitting of a volume did. A `point` is a corner of a primitive, or the middle of a round one, by
    /// its number among them all. Lengths and coordinates are the world's.
    pub enum Fit {
        /// The set is given: so many primitives, and the box around them.
        Begin ["begin"] { prims: u32, bounds: Aabb }
        /// A primitive was put into the box around them all, which is `bounds` now; it had to grow, or not.
        Widen ["widen.grown", "widen.same"] { prim: PrimId, bounds: Aabb, grown: bool }
        /// The corners of all primitives were gathered.
        Gather ["gather"] { points: u32 }
        /// The point furthest from the centre, among all points: `far` away, where the sphere reaches to `radius`. Only if
        /// it lies outside must the sphere grow. Before there is a sphere, `radius` is 0.
        Far ["far.outside", "far.inside"] { point: u32, x: f32, y: f32, z: f32, far: f32, radius: f32, outside: bool }
        /// The smallest sphere through `on` points was tried: each of them lies on it.
        Try ["try"] { x: f32, y: f32, z: f32, radius: f32, on: u32 }
        /// The smallest sphere around the few points that decide so far.
        Ball ["ball"] { x: f32, y: f32, z: f32, radius: f32, few: u32 }
        /// Around balls: the centre was moved towards the one furthest away, by a `part` of the way.
        Shift ["shift"] { x: f32, y: f32, z: f32, radius: f32, part: f32 }
        /// The sphere is found: around this centre, as far as the furthest point.
        Sphere ["sphere"] { x: f32, y: f32, z: f32, radius: f32 }
        /// A point that lies furthest in some direction, or any one where there are `few` to begin with: these choose the
        /// directions of the box.
        Keep ["keep"] { point: u32, x: f32, y: f32, z: f32, few: bool }
        /// The mean of the points.
        Mean ["mean"] { x: f32, y: f32, z: f32, points: u32 }
        /// Two directions were turned towards each other, until the set's spread along them has nothing in common: how far
        /// it spread along each, what both had in common, and the tangent of the angle.
        Align ["align"] { first: Direction, second: Direction, along_first: f32, along_second: f32, together: f32, tangent: f32 }
        /// Three directions were tried: so wide is the set along each, there is the middle of the box, and that is its
        /// surface. `tangent` is by how much they were turned.
        Frame ["frame.principal", "frame.world", "frame.turned"] {
            from: FrameFrom,
            x: f32, y: f32, z: f32,
            u_x: f32, u_y: f32, u_z: f32,
            v_x: f32, v_y: f32, v_z: f32,
            w_x: f32, w_y: f32, w_z: f32,
            wide_u: f32, wide_v: f32, wide_w: f32,
            surface: f32,
            tangent: f32,
        }
        /// The smallest of what was tried: it is taken, or, where none was smaller, the angle is halved.
        Choose ["choose.taken", "choose.halved"] { surface: f32, least: f32, tangent: f32, taken: bool }
        /// Two planes across a direction were pushed out until they hold the first `points` points: so far they lie, seen
        /// from the middle of the box around everything.
        Push ["push"] { axis: Direction, x: f32, y: f32, z: f32, low: f32, high: f32, points: u32 }
        /// A corner of the first tetrahedron: the `count`th. `far` is its distance from the corners before it, from their
        /// line or from their plane.
        Seed ["seed"] { point: u32, x: f32, y: f32, z: f32, far: f32, count: u32 }
        /// The point furthest outside the hull so far, `far` before a face of it: it becomes the `count`th corner.
        Apex ["apex"] { point: u32, x: f32, y: f32, z: f32, far: f32, count: u32 }
        /// A face sees the new corner from outside: it goes.
        Hide ["face.gone"] { face: u32 }
        /// A face came to be, between three corners; so many points lie before it, the furthest `far` away.
        Make ["face.made"] { face: u32, a: u32, b: u32, c: u32, before: u32, far: f32 }
        /// Nothing lies further outside than `far`, or no more corners are sought.
        Enough ["enough"] { faces: u32, corners: u32, far: f32 }
        /// A plane of the hull was pushed out as far as the furthest point, seen from the middle of the box; faces in one
        /// plane have one between them.
        Plane ["plane"] { face: u32, x: f32, y: f32, z: f32, plane: f32 }
        /// The volume is fitted: by so many planes it is bounded (0 of a sphere), and so much room it encloses, with this
        /// surface, in a flat scene this outline.
        End ["end"] { planes: u32, content: f32, surface: f32, bytes: u32 }
    }
}

impl Fit {
    /// What slides, listings and questions call this event.
    pub fn name(&self) -> &'static str {
        match self {
            Fit::Begin { .. } => "begin",
            Fit::Widen { grown: true, .. } => "widen.grown",
            Fit::Widen { grown: false, .. } => "widen.same",
            Fit::Gather { .. } => "gather",
            Fit::Far { outside: true, .. } => "far.outside",
            Fit::Far { outside: false, .. } => "far.inside",
            Fit::Try { .. } => "try",
            Fit::Ball { .. } => "ball",
            Fit::Shift { .. } => "shift",
            Fit::Sphere { .. } => "sphere",
            Fit::Keep { .. } => "keep",
            Fit::Mean { .. } => "mean",
            Fit::Align { .. } => "align",
            Fit::Frame { from: FrameFrom::Principal, .. } => "frame.principal",
            Fit::Frame { from: FrameFrom::World, .. } => "frame.world",
            Fit::Frame { from: FrameFrom::Turned, .. } => "frame.turned",
            Fit::Choose { taken: true, .. } => "choose.taken",
            Fit::Choose { taken: false, .. } => "choose.halved",
            Fit::Push { .. } => "push",
            Fit::Seed { .. } => "seed",
            Fit::Apex { .. } => "apex",
            Fit::Hide { .. } => "face.gone",
            Fit::Make { .. } => "face.made",
            Fit::Enough { .. } => "enough",
            Fit::Plane { .. } => "plane",
            Fit::End { .. } => "end",
        }
    }

    /// How coarse the event is: what is tried is fine, a volume that stands is coarse.
    pub fn grain(&self) -> Grain {
        match self {
            Fit::Try { .. }
            | Fit::Keep { .. }
            | Fit::Align { .. }
            | Fit::Frame { from: FrameFrom::Turned, .. }
            | Fit::Choose { taken: false, .. }
            | Fit::Shift { .. }
            | Fit::Hide { .. }
            | Fit::Plane { .. }
            | Fit::Widen { grown: false, .. } => Grain::Arithmetic,
            Fit::Begin { .. }
            | Fit::Ball { .. }
            | Fit::Sphere { .. }
            | Fit::Apex { .. }
            | Fit::Enough { .. }
            | Fit::End { .. } => Grain::Visit,
            _ => Grain::Decision,
        }
    }

    /// Whether flat scenes leave it out: planes across a direction that is not in the plane of the drawing.
    pub fn concerns_z(&self) -> bool {
        matches!(self, Fit::Push { z, .. } if *z != 0.0)
    }

    /// What the event is about: a point is a cell, a face of the hull a node.
    pub fn place(&self) -> Place {
        match *self {
            Fit::Widen { prim, .. } => Place::Prim(prim),
            Fit::Far { point, .. } | Fit::Keep { point, .. } | Fit::Seed { point, .. } | Fit::Apex { point, .. } => {
                Place::Cell(CellId(point))
            }
            Fit::Hide { face } | Fit::Make { face, .. } | Fit::Plane { face, .. } => Place::Node(NodeId(face)),
            _ => Place::World,
        }
    }
}

/// A builder's observer while a volume is fitted: it is told nothing of that, but can ask to give up.
pub(crate) struct Unheard<'a, W>(pub(crate) &'a W);

impl<W: Observer<Grow>> Observer<Fit> for Unheard<'_, W> {
    #[inline(always)]
    fn on(&mut self, _: Fit) {}

    #[inline]
    fn cancelled(&self) -> bool {
        self.0.cancelled()
    }
}
