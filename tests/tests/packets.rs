//! Packets: every lane finds what its ray finds alone, whatever the other lanes are.

use rayon::prelude::*;
use raystep_accel::{
    Abreast, Accel, Fill, Hit, Lanes, List, NodeId, Packet, PacketStep, PrimId, Prims, Random, Ray, Structure, Visit,
    Want, Width,
};
use raystep_tests::rays::Targets;
use raystep_tests::rules::rules;
use raystep_tests::scenes::cases;

/// Calls `law` with packets of rays that have nothing to do with each other, in every tree over every scene.
fn check(count: u32, law: impl Fn(&Structure, &Prims, Packet<'_>, Want, &str) + Sync) {
    cases().par_iter().enumerate().for_each(|(i, case)| {
        let seed = i as u64 + 1;
        for (line, rule) in rules() {
            if !["kd", "bsp", "bvh"].iter().any(|kind| line.starts_with(kind)) {
                continue;
            }
            let rule = if case.flat { rule.flat() } else { rule };
            let structure = Structure::build(&case.prims, &rule, &mut ()).unwrap();
            let targets = Targets::of(&case.prims, case.flat, &[&structure]);
            let mut random = Random::new(seed);
            let rays: Vec<Ray> = (0..count).filter_map(|i| targets.ray(&case.prims, i, &mut random)).collect();
            for &width in Width::ALL {
                for want in [Want::Nearest, Want::Any] {
                    let what = format!("{}, {line}, {} lanes", case.name, width.word());
                    Packet::all(&rays, width).for_each(|packet| law(&structure, &case.prims, packet, want, &what));
                }
            }
        }
    });
}

#[test]
fn every_lane_finds_what_its_ray_finds_alone() {
    let bits = |hit: Option<Hit>| hit.map(|hit| (hit.t.to_bits(), hit.prim, hit.inner));
    check(500, |structure, prims, packet, want, what| {
        let found = structure.walk_packet(prims, packet, want, &mut ()).unwrap();
        for (ray, found) in packet.rays().iter().zip(found) {
            let alone = List.intersect(prims, ray, &mut ());
            match want {
                Want::Nearest => assert!(bits(found) == bits(alone), "{what}: {found:?} for {alone:?}\n{ray:?}"),
                Want::Any => assert_eq!(found.is_some(), alone.is_some(), "{what}\n{ray:?}"),
            }
        }
        assert!(found[packet.rays().len()..].iter().all(Option::is_none));
    });
}

#[test]
fn lanes_take_part_only_where_they_have_come_to() {
    check(64, |structure, prims, packet, want, what| {
        let (mut events, mut fill) = (Vec::new(), Fill::default());
        let found = structure.walk_packet(prims, packet, want, &mut (&mut events, &mut fill)).unwrap();
        assert_eq!(structure.walk_packet(prims, packet, want, &mut ()).unwrap(), found, "{what}: watched or not");

        let width = packet.width();
        // Who may enter which node.
        let mut sent = vec![Lanes::none(width); structure.node_count()];
        if let Some(root) = sent.first_mut() {
            *root = Lanes::of(width, |lane| lane < packet.rays().len());
        }
        let mut here = Lanes::none(width);
        let mut stack: Vec<(NodeId, Lanes)> = Vec::new();
        let mut visits = 0;
        for event in &events {
            assert_eq!(event.lanes.width(), width);
            assert_eq!(event.field("lanes").is_some(), event.fields().iter().all(|name| event.field(name).is_some()));
            match event.step {
                PacketStep::Packet(Abreast::Enter { node, prims, leaf }) => {
                    here = event.lanes;
                    visits += here.count();
                    assert!(!here.is_empty() && here.and(sent[node.index()]) == here, "{what}: node {node}");
                    assert_eq!(leaf, structure.children(node).is_empty());
                    assert_eq!(prims as usize, structure.leaf_prims(node).len());
                }
                PacketStep::Packet(Abreast::Split { node, first, second, to_first, to_second, both }) => {
                    let mut children = [first, second];
                    children.sort_unstable();
                    assert_eq!(structure.children(node), children);
                    assert_eq!((event.lanes, to_first.and(to_second)), (here, both));
                    (sent[first.index()], sent[second.index()]) = (to_first, to_second);
                }
                PacketStep::Packet(Abreast::Push { node, depth }) => {
                    assert_eq!(event.lanes, sent[node.index()]);
                    stack.push((node, event.lanes));
                    assert_eq!(stack.len(), depth as usize);
                }
                PacketStep::Packet(Abreast::Pop { node, waited, depth } | Abreast::Drop { node, waited, depth }) => {
                    assert_eq!(stack.pop(), Some((node, waited)));
                    assert_eq!(stack.len(), depth as usize);
                    assert_eq!(event.lanes.is_empty(), event.name() == "packet.drop");
                }
                PacketStep::Packet(Abreast::Test { better, .. }) => assert_eq!(better.and(event.lanes), better),
                PacketStep::Packet(Abreast::End { hit }) => {
                    assert_eq!(hit, Lanes::of(width, |lane| found[lane].is_some()));
                }
                PacketStep::Lane(_) => assert_eq!(event.lanes.count(), 1),
            }
        }
        assert!(stack.is_empty(), "{what}");
        assert_eq!(fill.lane_visits, u64::from(visits));
        assert!(fill.share().is_none_or(|share| share > 0.0 && share <= 1.0));
    });
}

#[test]
fn lanes_that_agree_do_in_a_kd_tree_what_each_does_alone() {
    /// The primitives that a walk tests, in order.
    fn tests(visits: impl Iterator<Item = Visit>) -> Vec<PrimId> {
        visits.filter_map(|visit| if let Visit::Test { prim, .. } = visit { Some(prim) } else { None }).collect()
    }
    check(120, |structure, prims, packet, want, what| {
        if !matches!(structure, Structure::Kd(_)) {
            return;
        }
        // The same signs on every axis, so that all of them want the same child first.
        let signs = |ray: &Ray| ray.d.to_array().map(|d| d > 0.0);
        let usable = |ray: &&Ray| ray.d.to_array().iter().all(|&d| d != 0.0);
        let Some(first) = packet.rays().iter().find(usable) else { return };
        let agreeing: Vec<Ray> =
            packet.rays().iter().filter(usable).filter(|ray| signs(ray) == signs(first)).copied().collect();
        let mut events = Vec::new();
        let packet = Packet::all(&agreeing, Width::Sixteen).next().unwrap();
        structure.walk_packet(prims, packet, want, &mut events);
        for (lane, ray) in agreeing.iter().enumerate() {
            let mut alone: Vec<Visit> = Vec::new();
            structure.walk(prims, ray, want, &mut alone);
            let own = events.iter().filter(|event| event.lanes.has(lane)).filter_map(|event| match event.step {
                PacketStep::Lane(visit) => Some(visit),
                PacketStep::Packet(_) => None,
            });
            assert_eq!(tests(own), tests(alone.into_iter()), "{what}, lane {lane}\n{ray:?}");
        }
    });
}
