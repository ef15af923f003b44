//! Every mistake shows on its own example: in the verdict on the box, in the answer, or in what it costs.

use raystep_accel::*;

/// The verdict on the one box, the answer, and how many primitives were tested.
fn play(walk: impl Fn(&mut (Vec<Visit>, Cost)) -> Option<Hit>) -> (Option<Verdict>, Option<Hit>, u64) {
    let mut watch = (Vec::new(), Cost::default());
    let hit = walk(&mut watch);
    let verdict = watch.0.iter().rev().find_map(|event| match event {
        Visit::Volume { place: Place::World, verdict, .. } => Some(*verdict),
        _ => None,
    });
    (verdict, hit, watch.1.prim_tests)
}

/// The right walk and the mistaken one on the mistake's example.
fn both(mistake: Mistake) -> [(Option<Verdict>, Option<Hit>, u64); 2] {
    let Example { shapes, rule, ray, .. } = mistake.example();
    let prims = shapes.as_slice();
    assert_eq!(rule.kind(), mistake.kind());
    let structure = Structure::build(&prims, &rule, &mut ()).unwrap();
    let right = play(|watch| structure.intersect(&prims, &ray, watch));
    if mistake.kind() != "slab" {
        assert_eq!(right.1, List.intersect(&prims, &ray, &mut ()), "the right walk of {mistake:?}");
    }
    [right, play(|watch| mistake.walk(&structure, &prims, &ray, watch))]
}

fn hit(t: f32, prim: u32) -> Option<(String, u32)> {
    Some((format!("{t:.2}"), prim))
}

fn rounded(found: Option<Hit>) -> Option<(String, u32)> {
    found.and_then(|found| hit(found.t, found.prim.0))
}

#[test]
fn slab_mistakes_show_in_the_verdict() {
    for (mistake, right_verdict, wrong_verdict) in [
        (Mistake::SlabNoSwap, Verdict::Hit, Verdict::Miss),
        (Mistake::SlabStrict, Verdict::Hit, Verdict::Miss),
        (Mistake::SlabBehind, Verdict::Miss, Verdict::Hit),
    ] {
        let [right, wrong] = both(mistake);
        assert_eq!((right.0, wrong.0), (Some(right_verdict), Some(wrong_verdict)), "{mistake:?}");
    }
}

#[test]
fn wrong_stops_show_in_the_answer() {
    for (mistake, right_answer, wrong_answer) in [
        (Mistake::GridStopsEarly, hit(2.15, 3), hit(2.62, 0)),
        (Mistake::GridForgets, hit(2.62, 0), None),
        (Mistake::KdLeftFirst, hit(4.8, 1), hit(6.33, 0)),
        (Mistake::KdAnyHit, hit(8.5, 1), hit(9.0, 0)),
    ] {
        let [right, wrong] = both(mistake);
        assert_eq!((rounded(right.1), rounded(wrong.1)), (right_answer, wrong_answer), "{mistake:?}");
    }
}

#[test]
fn a_missing_order_or_cut_shows_in_the_cost() {
    for mistake in [Mistake::BvhUnordered, Mistake::BvhNoCut] {
        let [right, wrong] = both(mistake);
        assert_eq!(rounded(right.1), hit(2.0, 1), "{mistake:?}");
        assert_eq!(wrong.1, right.1, "{mistake:?}");
        assert_eq!((right.2, wrong.2), (1, 2), "{mistake:?}");
    }
}

#[test]
fn a_packet_that_follows_most_of_its_rays_loses_a_hit() {
    let Example { shapes, rule, ray, others } = Mistake::KdPacketMajority.example();
    let (prims, rays) = (shapes.as_slice(), [&[ray], others.as_slice()].concat());
    let tree = Structure::build(&prims, &rule, &mut ()).unwrap();
    let packet = Packet::of(&rays).unwrap();
    let right = tree.walk_packet(&prims, packet, Want::Nearest, &mut ()).unwrap();
    for (ray, found) in rays.iter().zip(right) {
        assert_eq!(found, List.intersect(&prims, ray, &mut ()));
    }
    let mut fill = Fill::default();
    let wrong = Mistake::KdPacketMajority.walk_packet(&tree, &prims, packet, &mut fill).unwrap();
    assert_eq!((rounded(right[0]), rounded(wrong[0])), (hit(2.5, 0), None));
    assert_eq!(right[1..], wrong[1..]);
    // The root by all four, and the leaf at the right by three; the one at the left stays closed.
    assert_eq!(fill, Fill { visits: 2, lane_visits: 7, lanes: 8 });
    // What single rays do wrong no packet does.
    assert_eq!(Mistake::KdAnyHit.walk_packet(&tree, &prims, packet, &mut ()), Some(right));
}

#[test]
fn packets_have_room_for_one_to_sixteen_rays() {
    let widths = [0, 1, 4, 5, 8, 9, 16, 17].map(|rays| Width::of(rays).map(Width::lanes));
    assert_eq!(widths, [None, Some(4), Some(4), Some(8), Some(8), Some(16), Some(16), None]);
}

#[test]
fn every_mistake_has_its_own_name_and_a_kind() {
    for mistake in Mistake::ALL {
        assert!(mistake.name().starts_with(mistake.kind()));
        assert!(mistake.consequence().ends_with('.') && !mistake.title().ends_with('.'));
        assert_eq!(Mistake::ALL.iter().filter(|other| other.name() == mistake.name()).count(), 1);
        assert!(Mistake::of_kind(mistake.kind()).any(|other| other == mistake));
    }
}
