//! What the lecture prints loosely and what students get wrong: each mistake is a walk like the right one,
//! with the wrong line marked `MISTAKE`. They speak the same vocabulary, so that a mistaken walk can be
//! watched beside the right one; and they are the only walks that may differ from brute force.

mod bvh_no_cut;
mod bvh_unordered;
mod example;
mod grid_forgets;
mod grid_stops_early;
mod kd_any_hit;
mod kd_left_first;
mod kd_packet_majority;
mod slab_behind;
mod slab_no_swap;
mod slab_strict;

pub use example::Example;

use crate::bvh::each;
use crate::{Accel, Found, Hit, Observer, Packet, PacketVisit, Primitives, Ray, Structure, Visit, Want};

/// A mistaken walk.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Mistake {
    /// The slab test does not order its two cuts.
    SlabNoSwap,
    /// The slab test asks for an interval with a length.
    SlabStrict,
    /// The slab test forgets that a ray has a beginning.
    SlabBehind,
    /// The grid walk stops at the first hit it finds.
    GridStopsEarly,
    /// The grid walk throws away a hit beyond the cell, and its mailbox skips the primitive later.
    GridForgets,
    /// The kd walk takes the left child for the near one.
    KdLeftFirst,
    /// The kd walk stops at the first leaf with a hit.
    KdAnyHit,
    /// The walk of boxes opens the left child first.
    BvhUnordered,
    /// The walk of boxes opens what lies behind the best hit.
    BvhNoCut,
    /// The whole packet goes where most of its rays go.
    KdPacketMajority,
}

impl Mistake {
    /// All of them, in the order of the lecture.
    pub const ALL: [Mistake; 10] = [
        Mistake::SlabNoSwap,
        Mistake::SlabStrict,
        Mistake::SlabBehind,
        Mistake::GridStopsEarly,
        Mistake::GridForgets,
        Mistake::KdLeftFirst,
        Mistake::KdAnyHit,
        Mistake::BvhUnordered,
        Mistake::BvhNoCut,
        Mistake::KdPacketMajority,
    ];

    /// Those that can be made in a structure of this kind.
    pub fn of_kind(kind: &str) -> impl Iterator<Item = Mistake> {
        Mistake::ALL.into_iter().filter(move |mistake| mistake.kind() == kind)
    }

    /// The kind of structure it belongs to: one of [`Rule::KINDS`](crate::Rule::KINDS).
    pub fn kind(self) -> &'static str {
        match self {
            Mistake::SlabNoSwap | Mistake::SlabStrict | Mistake::SlabBehind => "slab",
            Mistake::GridStopsEarly | Mistake::GridForgets => "grid",
            Mistake::KdLeftFirst | Mistake::KdAnyHit | Mistake::KdPacketMajority => "kd",
            Mistake::BvhUnordered | Mistake::BvhNoCut => "bvh",
        }
    }

    /// What files and commands call it.
    pub fn name(self) -> &'static str {
        match self {
            Mistake::SlabNoSwap => "slab-no-swap",
            Mistake::SlabStrict => "slab-strict",
            Mistake::SlabBehind => "slab-behind",
            Mistake::GridStopsEarly => "grid-stops-early",
            Mistake::GridForgets => "grid-forgets",
            Mistake::KdLeftFirst => "kd-left-first",
            Mistake::KdAnyHit => "kd-any-hit",
            Mistake::BvhUnordered => "bvh-unordered",
            Mistake::BvhNoCut => "bvh-no-cut",
            Mistake::KdPacketMajority => "kd-packet-majority",
        }
    }

    /// What a menu calls it.
    pub fn title(self) -> &'static str {
        match self {
            Mistake::SlabNoSwap => "Never swap t1 and t2",
            Mistake::SlabStrict => "Hit only if t_near < t_far",
            Mistake::SlabBehind => "Forget t ≥ 0",
            Mistake::GridStopsEarly => "Stop at the first hit found",
            Mistake::GridForgets => "Forget a hit beyond the cell",
            Mistake::KdLeftFirst => "Take left for near",
            Mistake::KdAnyHit => "Stop at the first leaf with a hit",
            Mistake::BvhUnordered => "Open the left child first",
            Mistake::BvhNoCut => "Open every box that is met",
            Mistake::KdPacketMajority => "All go where most rays go",
        }
    }

    /// Where it is made: the event that the wrong line tells of, and what stands in its place.
    pub fn instead(self) -> (&'static str, &'static str) {
        match self {
            Mistake::SlabNoSwap => ("slab.order", "t1 and t2 stay as they are"),
            Mistake::SlabStrict => ("volume", "met if t_near < t_far"),
            Mistake::SlabBehind => ("slab", "[t_near, t_far] ← [−∞, ∞]"),
            Mistake::GridStopsEarly => ("beyond", "stop here as well"),
            Mistake::GridForgets => ("beyond", "forget the hit, go on"),
            Mistake::KdLeftFirst => ("plane", "near ← the left child"),
            Mistake::KdAnyHit => ("pop", "return the hit, if there is one"),
            Mistake::BvhUnordered => ("split", "near ← the left child"),
            Mistake::BvhNoCut => ("drop", "open it, whatever t_best is"),
            Mistake::KdPacketMajority => ("packet.push", "only if half of the rays or more need it"),
        }
    }

    /// What goes wrong, in a sentence.
    pub fn consequence(self) -> &'static str {
        match self {
            Mistake::SlabNoSwap => {
                "A ray that runs against an axis meets the upper plane first; with entry and exit mixed up, its interval is empty and the box is missed."
            }
            Mistake::SlabStrict => {
                "In a box without thickness entry and exit are the same t, so every wall along an axis disappears."
            }
            Mistake::SlabBehind => {
                "The line through the ray goes on behind its origin, so boxes behind the eye are hit."
            }
            Mistake::GridStopsEarly => {
                "A primitive in several cells can be hit far beyond this one, and a cell in between may hold a nearer hit."
            }
            Mistake::GridForgets => {
                "The hit beyond the cell is thrown away, and in the cell where it lies the mailbox says that the primitive was tested."
            }
            Mistake::KdLeftFirst => {
                "A ray from the right meets the right child first; taken for the far one, it is left out or gets the wrong part of the ray."
            }
            Mistake::KdAnyHit => {
                "A primitive on both sides of the plane can be hit beyond this leaf, and the far child may hold a nearer hit."
            }
            Mistake::BvhUnordered => {
                "The answer stays right, but the farther child is tested before a nearer hit can rule it out."
            }
            Mistake::BvhNoCut => {
                "The answer stays right, but boxes that begin behind the best hit are opened all the same."
            }
            Mistake::KdPacketMajority => {
                "A ray that goes another way than most never sees its side of the plane, and what it would hit there is lost."
            }
        }
    }

    /// Whether it is made in the walk of a packet; else in that of a single ray.
    pub fn is_of_packets(self) -> bool {
        self == Mistake::KdPacketMajority
    }

    /// The mistaken walk of a packet, in a structure that packets can walk. A mistake that a packet cannot make is not
    /// made: the walk is right.
    pub fn walk_packet(
        self,
        structure: &Structure,
        prims: &impl Primitives,
        packet: Packet<'_>,
        watch: &mut impl Observer<PacketVisit>,
    ) -> Option<Found> {
        match (self, structure) {
            (Mistake::KdPacketMajority, Structure::Kd(tree)) => {
                Some(kd_packet_majority::walk(tree, prims, packet, watch))
            }
            _ => structure.walk_packet(prims, packet, Want::Nearest, watch),
        }
    }

    /// The mistaken walk. In a structure of another kind this mistake cannot be made: the walk is right.
    pub fn walk(
        self,
        structure: &Structure,
        prims: &impl Primitives,
        ray: &Ray,
        watch: &mut impl Observer<Visit>,
    ) -> Option<Hit> {
        match (self, structure) {
            (_, Structure::Slab(one)) if one.bounds.is_empty() => None,
            (Mistake::SlabNoSwap, Structure::Slab(one)) => slab_no_swap::walk(one, ray, watch),
            (Mistake::SlabStrict, Structure::Slab(one)) => slab_strict::walk(one, ray, watch),
            (Mistake::SlabBehind, Structure::Slab(one)) => slab_behind::walk(one, ray, watch),
            (Mistake::GridStopsEarly, Structure::Grid(grid)) => grid_stops_early::walk(grid, prims, ray, watch),
            (Mistake::GridForgets, Structure::Grid(grid)) => grid_forgets::walk(grid, prims, ray, watch),
            (Mistake::KdLeftFirst, Structure::Kd(tree)) => kd_left_first::walk(tree, prims, ray, watch),
            (Mistake::KdAnyHit, Structure::Kd(tree)) => kd_any_hit::walk(tree, prims, ray, watch),
            (Mistake::BvhUnordered, Structure::Bvh(any)) => {
                each!(any, tree => bvh_unordered::walk(tree, prims, ray, watch))
            }
            (Mistake::BvhNoCut, Structure::Bvh(any)) => each!(any, tree => bvh_no_cut::walk(tree, prims, ray, watch)),
            _ => structure.intersect(prims, ray, watch),
        }
    }
}
