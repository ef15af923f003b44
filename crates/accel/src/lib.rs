//! The textbook: every acceleration structure of the lecture, built and walked, observed.
//!
//! Each algorithm stands here once. It tells an [`Observer`] what it does, in the order it does it,
//! with the numbers it has in hand: a builder speaks the vocabulary [`Grow`], a walk the vocabulary
//! [`Visit`]. Observed by `()` the telling compiles to nothing; observed by [`Cost`] it is counted;
//! observed by a [`Trace`] it is the picture a student steps through.
//!
//! Arithmetic is `+ − × ÷ √` and comparisons alone, so that the same ray gives the same bits on every
//! machine: single precision in the structures, double precision rounded once where a primitive is met. This crate knows no screen, no file, no thread and no lesson.

mod aabb;
mod around;
mod axis;
mod best;
mod bsp;
mod bvh;
mod digits;
mod direction;
mod event;
mod events;
mod grid;
mod grow;
mod halving;
mod ids;
mod instancing;
mod interval;
mod kd;
mod list;
mod mailbox;
mod margin;
mod mistakes;
mod obb;
mod objects;
mod octree;
mod one_box;
mod packet;
mod prims;
mod random;
mod ray;
mod rule;
mod slab;
mod stack;
mod structure;
mod visit;
mod volume;
mod watch;

pub use aabb::Aabb;
pub(crate) use around::around;
pub use axis::{Axes, Axis, Measure};
pub use best::{Best, Want, test};
pub use bsp::{Bsp, BspNode, ConvexCell, FreePlane};
pub use bvh::{AnyBvh, Bvh, Draft, Spans};
pub use direction::Direction;
pub use event::Event;
pub use events::Value;
pub use grid::{AnyGrid, Cells, Dense, Grid, GridOf, Hashed, HashedGrid, Lattice, Nested, NestedGrid};
pub use grow::{Grow, LeafReason};
pub use halving::PlaneTest;
pub use ids::{CellId, NodeId, Place, PrimId};
pub use instancing::{Instance, Instances, Model, Transform, TransformError};
pub use interval::Interval;
pub use kd::{CacheLines, Kd, KdLayout, KdMemory, KdNode, Machine, NodeField, Upright, Word};
pub use list::List;
pub use margin::Margin;
pub use mistakes::{Example, Mistake};
pub use obb::Obb;
pub use objects::{Body, Cover, Frustum, Kind, PAIRS, Pair, Part, Plane, Probe, Step, Steps, Watch};
pub use octree::{Octree, Outside};
pub use one_box::OneBox;
pub use packet::{Abreast, Fill, Found, Lanes, Packet, PacketStep, PacketVisit, WalkPackets, Width};
pub use prims::{Cone, Corner, Cylinder, Disc, Mesh, Polygon, Primitives, Prims, Prism, Shape, Sphere, Triangle, Wall};
pub use random::Random;
pub use ray::{Hit, Ray, RayError};
pub use rule::{
    Allowed, BspPlanes, BspRule, BvhBuilder, BvhOrder, BvhRule, BvhSplit, BvhVolume, GridRule, KdRule, KdSplit,
    NestedRule, OctreeRule, Parameter, Resolution, Rule, RuleError, Straddlers,
};
pub use slab::slab;
pub use structure::Structure;
pub use visit::{Ending, Grain, Probed, Side, Verdict, Visit};
pub use volume::{Appraisal, Hull, KDop, Outline, Volume, outline};
pub use watch::{Cancelled, Cost, Each, Observer, Trace};

/// What every structure of this crate can do with a ray: slides 7 and 21, whatever lies between.
pub trait Accel {
    /// The nearest hit in `[ray.t_min, ray.t_max]`: smallest `t`, then smallest [`PrimId`].
    ///
    /// `prims` must be the primitives that the structure was built over.
    fn intersect(&self, prims: &impl Primitives, ray: &Ray, watch: &mut impl Observer<Visit>) -> Option<Hit> {
        self.walk(prims, ray, Want::Nearest, watch)
    }

    /// Whether anything is hit in `[ray.t_min, ray.t_max]`; stops at the first hit found.
    fn occluded(&self, prims: &impl Primitives, ray: &Ray, watch: &mut impl Observer<Visit>) -> bool {
        self.walk(prims, ray, Want::Any, watch).is_some()
    }

    /// The walk behind both questions.
    fn walk(&self, prims: &impl Primitives, ray: &Ray, want: Want, watch: &mut impl Observer<Visit>) -> Option<Hit>;
}
