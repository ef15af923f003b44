//! A packet walks a kd-tree or a BSP tree: every lane splits its own interval.

use super::walk::{Part, Walk};
use super::{Found, Packet, WalkPackets};
use crate::bsp::{Node, Plane, PlaneTree, split};
use crate::common::{Mailbox, Part as LanePart};
use crate::{Accel, Lanes, List, NodeId, Observer, PacketVisit, Primitives, Want};

impl<N: Node> WalkPackets for PlaneTree<N> {
    fn walk_packet(
        &self,
        prims: &impl Primitives,
        packet: Packet<'_>,
        want: Want,
        watch: &mut impl Observer<PacketVisit>,
    ) -> Found {
        let mut walk = Walk::new(packet, prims, want, watch);
        let mut mailboxes = self.mailbox.then(|| [(); Lanes::MOST].map(|()| Mailbox::new()));

        // The part of each ray in the tree's box.
        let mut root = Part::new(NodeId::ROOT);
        for (lane, ray) in walk.rays() {
            if let Some(why) = self.bars(ray) {
                // Too far away to be told where it goes: brute force, for this lane alone.
                let watch = &mut walk.lane(lane);
                watch.on(why);
                walk.best[lane].hit = List.walk(prims, ray, want, watch);
            } else if let Some(part) = self.enter(ray, &mut walk.lane(lane)) {
                root.live[lane] = part.live;
            }
        }

        let mut next = walk.start(root);
        while let Some(here) = next {
            next = match (self.plane(here.node), self.children(here.node)) {
                (Some(plane), Some(children)) => {
                    walk.enter(&here, 0, false);
                    let mut parts = children.map(Part::new);
                    let mut votes = [0, 0];
                    for (lane, ray, live) in walk.lanes(&here) {
                        // Each lane splits its interval as it would alone.
                        let alone = LanePart { node: here.node, live, cell: () };
                        let (now, later) = split(alone, plane.across(ray), children, &mut walk.lane(lane));
                        let side = |part: LanePart| usize::from(part.node == children[1]);
                        parts[side(now)].live[lane] = now.live;
                        if let Some(later) = later {
                            parts[side(later)].live[lane] = later.live;
                            // Who meets both children has a wish which comes first.
                            votes[side(now)] += 1;
                        }
                    }
                    // Rays of different signs disagree: most lanes are served, the others visit their far
                    // child first. That costs them tests, and no hit: their intervals are their own.
                    let [below, above] = parts;
                    let (first, second) = if votes[1] > votes[0] { (above, below) } else { (below, above) };
                    walk.descend(&here, first, second)
                }
                _ => {
                    let prims = self.leaf_prims(here.node);
                    walk.enter(&here, prims.len() as u32, true);
                    walk.test(&here, prims, mailboxes.as_mut());
                    None
                }
            };
            // Next is what waits.
            next = next.or_else(|| walk.next());
        }
        walk.end()
    }
}
