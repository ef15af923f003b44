//! The walk of a packet, and beside it the walks of its rays one by one.

use glam::{Quat, Vec3};
use raystep_accel::{Cost, Hit, Observer, Packet, PacketVisit, Ray, Structure, Trace, Visit, Want};
use raystep_scene::Scene;

use crate::{NamedRay, Tape, WalkTape, names};

/// The most events of the walk of a packet.
const MOST: usize = 200_000;

/// Several rays that walk through a structure together.
#[derive(Clone, Debug, Default)]
pub struct PacketTape {
    /// The packets of the stage: the rays of each.
    pub packets: Vec<Vec<Ray>>,
    /// The rays that walk, one a lane; none before a packet is chosen.
    pub rays: Vec<Ray>,
    /// What they do together, and each for itself.
    pub events: Vec<PacketVisit>,
    /// How many events more there were.
    pub lost: u64,
    /// The answer of each ray.
    pub found: Vec<Option<Hit>>,
    /// The walks of the same rays, each alone.
    pub alone: Vec<WalkTape>,
    /// What each of those cost.
    pub costs: Vec<Cost>,
}

impl PacketTape {
    /// The packets to choose from; nothing walks yet.
    pub fn of(packets: Vec<Vec<Ray>>) -> PacketTape {
        PacketTape { packets, ..PacketTape::default() }
    }

    /// The packets of a stage.
    pub fn packets_of(rays: &[NamedRay]) -> Vec<Vec<Ray>> {
        rays.iter().map(|named| [std::slice::from_ref(&named.ray), named.others.as_slice()].concat()).collect()
    }

    /// Lets the packet that begins with this ray walk; if there is none, the one that walked last, moved and turned so
    /// that it does.
    pub fn walk(&self, scene: &Scene, structure: &Structure, ray: Ray) -> PacketTape {
        let rays = self.packet_of(ray);
        let mut trace = Trace::new(MOST);
        let found = Packet::of(&rays)
            .and_then(|packet| structure.walk_packet(&scene.prims, packet, Want::Nearest, &mut trace))
            .map_or_else(Vec::new, |found| found[..rays.len()].to_vec());
        let alone = |ray: &Ray| match Tape::walk(scene, structure, *ray) {
            Tape::Walk(walk) => Some(walk),
            _ => None,
        };
        let alone: Vec<WalkTape> = rays.iter().filter_map(alone).collect();
        let costs = alone.iter().map(|walk| cost(&walk.events)).collect();
        let (packets, events, lost) = (self.packets.clone(), trace.events, trace.lost);
        PacketTape { packets, rays, events, lost, found, alone, costs }
    }

    /// The same rays to choose from, and which of them walked last.
    pub(crate) fn again(&self) -> PacketTape {
        PacketTape { rays: self.rays.clone(), ..PacketTape::of(self.packets.clone()) }
    }

    /// The rays of the packet that begins with this one.
    pub fn packet_of(&self, ray: Ray) -> Vec<Ray> {
        let known = self.packets.iter().find(|packet| packet.first() == Some(&ray));
        let last = if self.rays.is_empty() { self.packets.first() } else { Some(&self.rays) };
        known.cloned().unwrap_or_else(|| moved(last.map_or(&[], Vec::as_slice), ray))
    }

    /// How many events of that name the walks of the single rays have in all.
    pub(crate) fn count_alone(&self, name: &str) -> Option<u32> {
        let of_name = |walk: &WalkTape| walk.events.iter().filter(|event| names(name, Visit::name(event))).count();
        self.alone.iter().all(|walk| walk.lost == 0).then(|| self.alone.iter().map(of_name).sum::<usize>() as u32)
    }
}

/// What a walk cost.
fn cost(events: &[Visit]) -> Cost {
    let mut cost = Cost::default();
    for event in events {
        cost.on(*event);
    }
    cost
}

/// The packet moved and turned as a whole, so that it begins with `ray`. A ray that would be none stays as it is.
fn moved(packet: &[Ray], ray: Ray) -> Vec<Ray> {
    let Some(first) = packet.first() else { return vec![ray] };
    let (before, now) = (first.d.normalize(), ray.d.normalize());
    // Straight back there are many ways to turn: the one in the plane.
    let turn = match before.dot(now) < -0.9999 {
        true => Quat::from_xyzw(0.0, 0.0, 1.0, 0.0),
        false => Quat::from_rotation_arc(before, now),
    };
    let longer = ray.d.length() / first.d.length();
    let other = |other: &Ray| {
        let along: Vec3 = turn * other.d * longer;
        let made = Ray::new(ray.o + turn * (other.o - first.o), along);
        made.and_then(|made| made.within(other.t_min, other.t_max)).unwrap_or(*other)
    };
    std::iter::once(ray).chain(packet.iter().skip(1).map(other)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ray(o: [f32; 2], d: [f32; 2]) -> Ray {
        Ray::new(Vec3::new(o[0], o[1], 0.0), Vec3::new(d[0], d[1], 0.0)).unwrap()
    }

    #[test]
    fn a_packet_moves_as_a_whole() {
        let packet = [ray([0.0, 0.0], [1.0, 0.0]), ray([0.0, 1.0], [1.0, 0.0]), ray([0.0, 0.0], [0.0, 1.0])];
        // Up, to the left and straight back.
        for (d, [second, third]) in [
            ([0.0, 1.0], [([1.0, 2.0], [0.0, 1.0]), ([2.0, 2.0], [-1.0, 0.0])]),
            ([-1.0, 0.0], [([2.0, 1.0], [-1.0, 0.0]), ([2.0, 2.0], [0.0, -1.0])]),
            ([2.0, 0.0], [([2.0, 3.0], [2.0, 0.0]), ([2.0, 2.0], [0.0, 2.0])]),
        ] {
            let first = ray([2.0, 2.0], d);
            let made = moved(&packet, first);
            assert_eq!(made[0], first);
            for (made, (o, d)) in made[1..].iter().zip([second, third]) {
                let wanted = ray(o, d);
                assert!((made.o - wanted.o).length() < 1e-5 && (made.d - wanted.d).length() < 1e-5, "{made:?}");
            }
        }
        assert_eq!(moved(&[], packet[0]), [packet[0]]);
    }
}
