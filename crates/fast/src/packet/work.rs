//! What packets meet, counted by whoever wants to know.

use raystep_accel::Ray;

use super::beam::Found;
use super::{PacketWidth, Packets, walk};
use crate::judge::Count;
use crate::lanes::dispatch;

impl Packets {
    /// Walks rays to their nearest hits and counts what packets meet: a node, a leaf and a triangle once for all rays of a
    /// packet, a judged triangle once for each ray. How many packets walked together; the rays of the others would walk
    /// alone, and are not counted.
    pub fn count(&self, rays: &[Ray], count: &mut impl Count) -> usize {
        match self.width {
            PacketWidth::Eight => self.count_packets::<1>(rays, count),
            PacketWidth::Sixteen => self.count_packets::<2>(rays, count),
        }
    }

    fn count_packets<const G: usize>(&self, rays: &[Ray], count: &mut impl Count) -> usize {
        let (nodes, leaves, reach) = self.tree.parts();
        walk::STACK.with_borrow_mut(|stack| {
            let mut found = Found::<G>::NONE;
            let found = &mut found;
            let mut together =
                |rays: &&[Ray]| dispatch!(self.isa, walk::walk(nodes, leaves, rays, reach, stack, found, count));
            rays.chunks(8 * G).filter(|rays| together(rays)).count()
        })
    }
}
