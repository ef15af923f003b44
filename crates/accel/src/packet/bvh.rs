//! A packet walks a hierarchy of volumes: a node is opened for the lanes that meet its volume.

use super::walk::{Part, Walk};
use super::{Found, Packet, WalkPackets};
use crate::bvh::{BvhWalk, each};
use crate::{Accel, AnyBvh, Bvh, List, NodeId, Observer, PacketVisit, Primitives, Volume, Want};

impl<V: Volume> WalkPackets for Bvh<V> {
    /// Always in order and with the early exit, whatever the rule says of single rays.
    fn walk_packet(
        &self,
        prims: &impl Primitives,
        packet: Packet<'_>,
        want: Want,
        watch: &mut impl Observer<PacketVisit>,
    ) -> Found {
        let mut walk = Walk::new(packet, prims, want, watch);
        let mut root = Part::new(NodeId::ROOT);
        for (lane, ray) in walk.rays() {
            if let Some(why) = V::bars(ray) {
                // Not to be measured: brute force, for this lane alone.
                let watch = &mut walk.lane(lane);
                watch.on(why);
                walk.best[lane].hit = List.walk(prims, ray, want, watch);
                continue;
            }
            let best = walk.best[lane];
            if let Some(met) = BvhWalk::resume(self, prims, ray, best, &mut walk.lane(lane)).root() {
                root.live[lane] = met.within;
            }
        }

        let mut next = walk.start(root);
        while let Some(here) = next {
            next = match self.children(here.node) {
                Some(children) => {
                    walk.enter(&here, 0, false);
                    let mut parts = children.map(Part::new);
                    let mut votes = [0, 0];
                    for (lane, ray, within) in walk.lanes(&here) {
                        // Each lane tests the volumes of both children.
                        let best = walk.best[lane];
                        let watch = &mut walk.lane(lane);
                        let mut alone = BvhWalk::resume(self, prims, ray, best, watch);
                        let met = children.map(|child| alone.volume(child, within).map(|met| met.within));
                        for (part, within) in parts.iter_mut().zip(met) {
                            part.live[lane] = within.unwrap_or(part.live[lane]);
                        }
                        // Who meets both has a wish which comes first: the one that it enters first.
                        if let [Some(left), Some(right)] = met {
                            votes[usize::from(right.near < left.near)] += 1;
                        }
                    }
                    let [left, right] = parts;
                    let (first, second) = if votes[1] > votes[0] { (right, left) } else { (left, right) };
                    walk.descend(&here, first, second)
                }
                None => {
                    let prims = self.leaf_prims(here.node);
                    walk.enter(&here, prims.len() as u32, true);
                    walk.test(&here, prims, None);
                    None
                }
            };
            next = next.or_else(|| walk.next());
        }
        walk.end()
    }
}

impl WalkPackets for AnyBvh {
    fn walk_packet(
        &self,
        prims: &impl Primitives,
        packet: Packet<'_>,
        want: Want,
        watch: &mut impl Observer<PacketVisit>,
    ) -> Found {
        each!(self, tree => tree.walk_packet(prims, packet, want, watch))
    }
}
