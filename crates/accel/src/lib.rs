//! The textbook: every acceleration structure of the lecture, built and walked, observed.
//!
//! Each algorithm stands here once. It tells an [`Observer`] what it does, in the order it does it,
//! with the numbers it has in hand: a builder speaks the vocabulary [`Grow`], a walk the vocabulary
//! [`Visit`]. Observed by `()` the telling compiles to nothing; observed by [`Cost`] it is counted;
//! observed by a [`Trace`] it is the picture a student steps through.
//!
//! Arithmetic is `+ − × ÷ √` and comparisons alone, so that the same ray gives the same bits on every
//! machine: single precision in the structures, double precision rounded once where a primitive is met. This crate knows no screen, no file, no thread and no lesson.

mod bsp;
mod bvh;
mod common;
mod events;
mod geometry;
mod grid;
mod instancing;
mod kd;
mod list;
mod mistakes;
mod objects;
mod octree;
mod one_box;
mod packet;
mod prims;
mod rule;
mod slab;
mod structure;
mod volume;

pub use bsp::{Bsp, BspNode, ConvexCell, FreePlane, PlaneTest};
pub use bvh::{AnyBvh, Bvh};
pub(crate) use common::around;
pub use common::{Accel, Margin, Random};
pub use events::{
    Cancelled, CellId, Cost, Each, Ending, Event, Grain, Grow, Lanes, LeafReason, NodeId, Observer, Place, PrimId,
    Probed, Side, Trace, Value, Verdict, Visit,
};
pub use geometry::{Aabb, Axes, Axis, Direction, Interval, Measure, Obb, Ray, RayError};
pub use grid::{AnyGrid, Cells, Dense, Grid, GridOf, Hashed, HashedGrid, Lattice, Nested, NestedGrid};
pub use instancing::{Instance, Instances, Model, Prims, Transform, TransformError};
pub use kd::{CacheLines, Kd, KdLayout, KdMemory, KdNode, Machine, NodeField, Upright, Word};
pub use list::List;
pub use mistakes::{Example, Mistake};
pub use objects::{
    Body, Cone, Corner, Cover, Cylinder, Disc, Frustum, Kind, PAIRS, Pair, Part, Plane, Polygon, Prism, Probe, Shape,
    Sphere, Step, Steps, Triangle, Wall, Watch,
};
pub use octree::{Octree, Outside};
pub use one_box::OneBox;
pub use packet::{Abreast, Fill, Found, Packet, PacketStep, PacketVisit, WalkPackets, Width};
pub use prims::{Best, Hit, Mesh, Primitives, Want, test};
pub use rule::{
    Allowed, BspPlanes, BspRule, BvhBuilder, BvhOrder, BvhRule, BvhSplit, BvhVolume, GridRule, KdRule, KdSplit,
    NestedRule, OctreeRule, Parameter, Resolution, Rule, RuleError, Straddlers,
};
pub use slab::slab;
pub use structure::Structure;
pub use volume::{Appraisal, Draft, Hull, KDop, Outline, Spans, Volume, outline};
