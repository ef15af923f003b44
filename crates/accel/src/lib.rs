//! The textbook: every acceleration structure of the lecture, built and walked, observed.
//!
//! Each algorithm stands here once. It tells an [`Observer`] what it does, in the order it does it,
//! with the numbers it has in hand: a builder speaks the vocabulary [`Grow`], a walk the vocabulary
//! [`Visit`]. Observed by `()` the telling compiles to nothing; observed by [`Cost`] it is counted;
//! observed by a [`Trace`] it is the picture a student steps through.
//!
//! Arithmetic is `+ − × ÷ √` and comparisons alone, so that the same ray gives the same bits on every
//! machine: single precision in the structures, double precision rounded once where a primitive is met.
//! This crate knows no screen, no file, no thread and no lesson.
//!
//! Its rooms, in the order of the lecture; each knows only those that it stands on:
//!
//! | room | slides | what it holds |
//! |---|---|---|
//! | `geometry` | 12 | boxes, rays, intervals, axes: what everything else is said in |
//! | `events` | | what is told, about which place, and who listens: nobody, a counter, a tape |
//! | `common` | 7, 20, 29 | what structures have in common: [`Accel`], mailbox, stack, margin, the box around everything |
//! | `prims` | 7 | the primitives that structures are built over, and the best hit among them |
//! | `list` | 7, 21 | brute force, the judge of everything else |
//! | `slab`, `one_box` | 12-15 | the slab test, and the box around everything alone |
//! | `objects` | 19 | shapes, and whether two objects meet, one file a pair |
//! | `grid` | 16-25, 63 | uniform, nested and hashed grids |
//! | `instancing` | 27 | a mesh stored once and placed many times; the primitives of any scene |
//! | `kd` | 28-42, 60-62 | the kd-tree: planes across an axis; its first lines lead to the builder and the walk |
//! | `octree` | 43-44 | the octree, and how it changes |
//! | `bsp` | 28-46 | any tree of planes, built and walked; with planes that stand free, the BSP tree |
//! | `volume` | 49-52 | spheres, boxes, k-DOPs and hulls around sets of primitives |
//! | `bvh` | 48-57 | hierarchies of them, built top-down, bottom-up and by insertion |
//! | `packet` | 59 | several rays that walk a tree together |
//! | `rule` | | how a structure is to be built: its kind and its parameters, as text too |
//! | `structure` | 65 | any of the structures, with what views ask of them |
//! | `mistakes` | | what the lecture prints loosely and what students get wrong, as walks |

mod bsp;
mod bvh;
mod common;
mod event;
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
pub use event::Event;
pub use events::{
    Abreast, Cancelled, CellId, Cost, Each, Ending, Fit, FrameFrom, Grain, Grow, Lanes, LeafReason, NodeId, Observer,
    PacketStep, PacketVisit, Place, PrimId, Probed, Reveal, Side, Trace, Value, Verdict, Visit,
};
pub use geometry::{Aabb, Axes, Axis, Direction, Interval, Measure, Obb, Ray, RayError, pinhole};
pub use grid::{AnyGrid, Cells, Dense, Grid, GridOf, Hashed, HashedGrid, Lattice, Nested, NestedGrid};
pub use instancing::{Instance, Instances, Model, Prims, Transform, TransformError};
pub use kd::{CacheLines, Kd, KdLayout, KdMemory, KdNode, Machine, NodeField, Upright, Word};
pub use list::List;
pub use mistakes::{Example, Mistake};
pub use objects::{
    Arrangement, Body, Cone, Corner, Cover, Cylinder, Disc, Frustum, Kind, PAIRS, Pair, Part, Plane, Polygon, Prism,
    Probe, Shape, Sphere, Step, Steps, Trial, Triangle, Wall, Watch,
};
pub use octree::{Change, Octree, Outside};
pub use one_box::OneBox;
pub use packet::{Fill, Found, Packet, WalkPackets, Width};
pub use prims::{Best, Hit, Mesh, Primitives, Want, test};
pub use rule::{
    Allowed, BspPlanes, BspRule, BvhBuilder, BvhOrder, BvhRule, BvhSplit, BvhVolume, ByHand, GridRule, HandCut, KdRule,
    KdSplit, NestedRule, OctreeRule, Parameter, Resolution, Rule, RuleError, Straddlers,
};
pub use slab::slab;
pub use structure::Structure;
pub use volume::{Appraisal, Draft, Hull, KDop, Outline, Spans, Volume, fit_around, outline};
