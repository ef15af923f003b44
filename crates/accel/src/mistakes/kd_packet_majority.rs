//! The walk of a packet in which all rays go where most of them go.

use crate::bsp::{Plane, split};
use crate::common::{Mailbox, Part as LanePart};
use crate::packet::walk::{Part, Walk};
use crate::{Found, Kd, Lanes, NodeId, Observer, Packet, PacketVisit, Primitives, Want};

pub(super) fn walk(
    tree: &Kd,
    prims: &impl Primitives,
    packet: Packet<'_>,
    watch: &mut impl Observer<PacketVisit>,
) -> Found {
    let mut walk = Walk::new(packet, prims, Want::Nearest, watch);
    let mut mailboxes = [(); Lanes::MOST].map(|()| Mailbox::new());
    let mut root = Part::new(NodeId::ROOT);
    for (lane, ray) in walk.rays() {
        if let Some(part) = tree.enter(ray, &mut walk.lane(lane)) {
            root.live[lane] = part.live;
        }
    }
    let mut next = walk.start(root);
    while let Some(here) = next {
        let inner = tree.plane(here.node).zip(tree.children(here.node));
        let Some((plane, children)) = inner else {
            let refs = tree.leaf_prims(here.node);
            walk.enter(&here, refs.len() as u32, true);
            walk.test(&here, refs, Some(&mut mailboxes));
            next = walk.next();
            continue;
        };
        walk.enter(&here, 0, false);
        let mut parts = children.map(Part::new);
        let mut votes = [0, 0];
        for (lane, ray, live) in walk.lanes(&here) {
            let alone = LanePart { node: here.node, live, cell: () };
            let (now, later) = split(alone, plane.across(ray), children, &mut walk.lane(lane));
            let side = |part: LanePart| usize::from(part.node == children[1]);
            parts[side(now)].live[lane] = now.live;
            if let Some(later) = later {
                parts[side(later)].live[lane] = later.live;
                votes[side(now)] += 1;
            }
        }

        // MISTAKE: a child is opened for every lane that meets it, however few they are.
        let here_are = walk.taking_part(&here).count();
        let parts = parts.map(|part| match 2 * walk.taking_part(&part).count() < here_are {
            true => Part::new(part.node),
            false => part,
        });

        let [below, above] = parts;
        let (first, second) = if votes[1] > votes[0] { (above, below) } else { (below, above) };
        next = walk.descend(&here, first, second).or_else(|| walk.next());
    }
    walk.end()
}
