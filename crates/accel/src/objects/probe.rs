//! The vocabulary of single tests: what two objects are asked before it is known whether they meet.

use crate::events::{vocabulary, words};
use crate::{Axis, Grain};

words! {
    /// Which part of an object a number is about.
    pub enum Part {
        /// A plane.
        Plane = "plane",
        /// The round side of a cylinder or a cone.
        Surface = "surface",
        /// The flat ends of a cylinder; apex and base of a cone.
        Ends = "ends",
        /// How far out from a centre or from an axis, squared.
        Radius = "radius",
        /// Along the x axis.
        X = "x",
        /// Along the y axis.
        Y = "y",
        /// Along the z axis.
        Z = "z",
        /// Along the first side of an oriented box.
        U = "u",
        /// Along its second side.
        V = "v",
        /// Along its third side.
        W = "w",
        /// The left plane of a frustum.
        Left = "left",
        /// Its right plane.
        Right = "right",
        /// Its lower plane.
        Bottom = "bottom",
        /// Its upper plane.
        Top = "top",
        /// Its near plane.
        Near = "near",
        /// Its far plane.
        Far = "far",
        /// Along a normal of the first object.
        First = "first",
        /// Along a normal of the second object.
        Second = "second",
        /// Across an edge of each.
        Edges = "edges",
    }

    /// On which side of a plane an object lies.
    pub enum Cover {
        /// All of it is outside.
        Outside = "outside",
        /// The plane passes through it.
        Across = "across",
        /// All of it is inside.
        Inside = "inside",
    }
}

impl Part {
    /// Along x, y or z.
    #[inline]
    pub(crate) fn along(axis: Axis) -> Part {
        [Part::X, Part::Y, Part::Z][axis.index()]
    }

    /// Along a box's own side.
    #[inline]
    pub(crate) fn own(axis: Axis) -> Part {
        [Part::U, Part::V, Part::W][axis.index()]
    }
}

vocabulary! {
    /// One thing that a test computed. The slabs of boxes are told in the words of walks.
    pub enum Probe {
        /// The ray was cut by a plane: `t = height / slant`, the plane's height over the origin by how much
        /// of it one length of the direction climbs.
        Cut ["cut"] { of: Part, height: f32, slant: f32, t: f32 }
        /// The ray runs along the plane, or so nearly that the numbers would not say where they meet.
        Parallel ["parallel"] { of: Part, slant: f32, limit: f32 }
        /// The equation `a·t² + 2·b·t + c = 0` was solved; `t1 ≤ t2`, and NaN where there is no solution.
        Quadratic ["quadratic.two", "quadratic.none"] { of: Part, a: f32, b: f32, c: f32, discriminant: f32, t1: f32, t2: f32, real: bool }
        /// The part of the ray inside was narrowed to what lies between `t1` and `t2`.
        Narrow ["narrow"] { of: Part, t1: f32, t2: f32, t_near: f32, t_far: f32, empty: bool }
        /// Space was sheared so that the ray runs along an axis: by so much of it in the other two.
        Shear ["shear"] { along: Axis, x: f32, y: f32 }
        /// The three areas that the point makes with the edges: all of one sign, and it lies inside.
        Areas ["areas.in", "areas.out"] { u: f32, v: f32, w: f32, inside: bool }
        /// An edge of a polygon from height `from` to height `to`; if it passes the point's own height,
        /// then at `at`, and it counts if that is to the right. All seen from the point.
        Edge ["edge.crossed", "edge.passed"] { edge: u32, from: f32, to: f32, at: f32, crossed: bool }
        /// The crossings were counted: an odd number lies around a point inside.
        Parity ["parity.in", "parity.out"] { crossings: u32, inside: bool }
        /// A number was compared with its limits.
        Compare ["compare.in", "compare.out"] { of: Part, value: f32, low: f32, high: f32, inside: bool }
        /// The nearest point of a box was found along one axis, `gap` away.
        Nearest ["nearest"] { of: Part, value: f32, low: f32, high: f32, nearest: f32, gap: f32 }
        /// The shadows of both objects on the direction `(x, y, z)` were compared.
        Shadow ["shadow.apart", "shadow.overlap"] { of: Part, x: f32, y: f32, z: f32, a_low: f32, a_high: f32, b_low: f32, b_high: f32, apart: bool }
        /// A box was compared with a plane: the distance of its middle, in lengths of the normal, and how
        /// far it reaches from there.
        Side ["side.outside", "side.across", "side.inside"] { of: Part, distance: f32, reach: f32, cover: Cover }
        /// The ray's answer: the first t in its range, or infinity.
        Met ["met.hit", "met.miss"] { t: f32, hit: bool }
        /// The answer of two objects: whether they share a point.
        Touch ["touch.yes", "touch.no"] { touch: bool }
    }
}

impl Probe {
    /// What slides, listings and questions call this event.
    pub fn name(&self) -> &'static str {
        let names = match self {
            Probe::Cut { .. } => ["cut"; 2],
            Probe::Parallel { .. } => ["parallel"; 2],
            Probe::Quadratic { .. } => ["quadratic.two", "quadratic.none"],
            Probe::Narrow { .. } => ["narrow"; 2],
            Probe::Shear { .. } => ["shear"; 2],
            Probe::Areas { .. } => ["areas.in", "areas.out"],
            Probe::Edge { .. } => ["edge.crossed", "edge.passed"],
            Probe::Parity { .. } => ["parity.in", "parity.out"],
            Probe::Compare { .. } => ["compare.in", "compare.out"],
            Probe::Nearest { .. } => ["nearest"; 2],
            Probe::Shadow { .. } => ["shadow.apart", "shadow.overlap"],
            Probe::Side { cover: Cover::Across, .. } => ["side.across"; 2],
            Probe::Side { .. } => ["side.inside", "side.outside"],
            Probe::Met { .. } => ["met.hit", "met.miss"],
            Probe::Touch { .. } => ["touch.yes", "touch.no"],
        };
        let yes = match *self {
            Probe::Quadratic { real: yes, .. }
            | Probe::Areas { inside: yes, .. }
            | Probe::Edge { crossed: yes, .. }
            | Probe::Parity { inside: yes, .. }
            | Probe::Compare { inside: yes, .. }
            | Probe::Shadow { apart: yes, .. }
            | Probe::Met { hit: yes, .. }
            | Probe::Touch { touch: yes } => yes,
            Probe::Side { cover, .. } => cover == Cover::Inside,
            _ => true,
        };
        names[usize::from(!yes)]
    }

    /// How coarse the event is.
    pub fn grain(&self) -> Grain {
        match self {
            Probe::Cut { .. }
            | Probe::Quadratic { .. }
            | Probe::Shear { .. }
            | Probe::Edge { .. }
            | Probe::Nearest { .. } => Grain::Arithmetic,
            Probe::Met { .. } | Probe::Touch { .. } => Grain::Visit,
            _ => Grain::Decision,
        }
    }
}
