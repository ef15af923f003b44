//! Packets, slide 59: 4, 8 or 16 rays walk a tree together (Wald, Slusallek, Benthin and Wagner 2001).
//!
//! This is the clear version: lanes are computed one after the other, by the very routines that walk single
//! rays. What a packet saves is visits: a node is opened once for all the lanes that meet it.

mod bsp;
mod bvh;
mod fill;
pub(crate) mod walk;

pub use fill::Fill;

use crate::events::words;
use crate::{Hit, Lanes, Observer, PacketVisit, Primitives, Ray, Structure, Want};

words! {
    /// How many rays walk together.
    pub enum Width {
        /// 4
        Four = "4",
        /// 8
        Eight = "8",
        /// 16
        Sixteen = "16",
    }
}

impl Width {
    /// 4, 8 or 16.
    pub fn lanes(self) -> usize {
        4 << self as usize
    }

    /// The narrowest packet in which so many rays find a lane each; nothing if they are too many, or none.
    pub fn of(rays: usize) -> Option<Width> {
        Width::ALL.iter().copied().find(|width| (1..=width.lanes()).contains(&rays))
    }
}

/// Rays that walk together, one a lane.
#[derive(Clone, Copy, Debug)]
pub struct Packet<'a> {
    rays: &'a [Ray],
    width: Width,
}

impl<'a> Packet<'a> {
    /// The rays in packets, in order. In the last one some lanes may be left without a ray.
    pub fn all(rays: &'a [Ray], width: Width) -> impl Iterator<Item = Packet<'a>> {
        rays.chunks(width.lanes()).map(move |rays| Packet { rays, width })
    }

    /// These rays as one packet; nothing if they are none, or more than the widest packet takes.
    pub fn of(rays: &'a [Ray]) -> Option<Packet<'a>> {
        Width::of(rays.len()).map(|width| Packet { rays, width })
    }

    /// The rays, one a lane.
    pub fn rays(&self) -> &'a [Ray] {
        self.rays
    }

    /// How many lanes there are, with and without a ray.
    pub fn width(&self) -> usize {
        self.width.lanes()
    }
}

/// What each lane has found; nothing in lanes without a ray.
pub type Found = [Option<Hit>; Lanes::MOST];

/// A structure that packets can walk. Each lane finds what its ray would find alone.
pub trait WalkPackets {
    /// The nearest hit of every ray, or any hit.
    ///
    /// `prims` must be the primitives that the structure was built over.
    fn walk_packet(
        &self,
        prims: &impl Primitives,
        packet: Packet<'_>,
        want: Want,
        watch: &mut impl Observer<PacketVisit>,
    ) -> Found;
}

impl Structure {
    /// The answers of a packet, if it is a structure that packets can walk.
    pub fn walk_packet(
        &self,
        prims: &impl Primitives,
        packet: Packet<'_>,
        want: Want,
        watch: &mut impl Observer<PacketVisit>,
    ) -> Option<Found> {
        match self {
            Structure::Kd(tree) => Some(tree.walk_packet(prims, packet, want, watch)),
            Structure::Bsp(tree) => Some(tree.walk_packet(prims, packet, want, watch)),
            Structure::Bvh(tree) => Some(tree.walk_packet(prims, packet, want, watch)),
            _ => None,
        }
    }
}
