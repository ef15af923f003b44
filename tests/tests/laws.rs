//! What every walk of every structure keeps to, whatever the scene and the ray.

use std::collections::BTreeSet;
use std::sync::LazyLock;

use glam::Vec3;
use rayon::prelude::*;
use raystep_accel::{
    Accel, CellId, Cost, Ending, Hit, Interval, NodeId, Observer, Place, Prims, Random, Ray, RayError, Structure,
    Trace, Verdict, Visit, Want,
};
use raystep_tests::rays::Targets;
use raystep_tests::rules::rules;
use raystep_tests::scenes::{Case, cases};

/// Rays for every structure over every scene.
const RAYS: u32 = 120;

/// What a walk of a structure is held against: what it told, and what it found.
type Law = fn(&Structure, &[Visit], Option<Hit>);

/// What walks keep to.
const LAWS: [(&str, Law); 9] = [
    ("the last better hit is the answer", the_last_better_hit_is_the_answer),
    ("a walk ends once and last", a_walk_ends_once_and_last),
    ("each pop or drop had its push", each_pop_or_drop_had_its_push),
    ("a childs interval lies in its parents", a_childs_interval_lies_in_its_parents),
    ("a kd split sends the ray where its interval is", a_kd_split_sends_the_ray_where_its_interval_is),
    ("cells of a walk are face neighbours and t never falls", cells_of_a_walk_are_face_neighbours_and_t_never_falls),
    ("a mailbox skips only what was tested", a_mailbox_skips_only_what_was_tested),
    ("a missed box is not opened", a_missed_box_is_not_opened),
    ("every event is in the vocabulary", every_event_is_in_the_vocabulary),
];

#[test]
fn walks_of_every_structure_over_every_scene_keep_to_the_laws() {
    watched(|structure, prims, ray| {
        for want in [Want::Nearest, Want::Any] {
            let mut events = Vec::new();
            let hit = structure.walk(prims, ray, want, &mut events);
            for (said, law) in LAWS {
                let broken = Broken(said);
                law(structure, &events, hit);
                drop(broken);
            }
        }
    });
}

/// Says which law was broken.
struct Broken(&'static str);

impl Drop for Broken {
    fn drop(&mut self) {
        if std::thread::panicking() {
            eprintln!("{}: not so", self.0);
        }
    }
}

/// A scene with every structure over it, and what rays aim at in each.
struct Ready {
    case: Case,
    structures: Vec<(&'static str, Structure, Targets)>,
}

/// All of them, built once for all laws.
static READY: LazyLock<Vec<Ready>> = LazyLock::new(|| cases().into_par_iter().map(ready).collect());

fn ready(case: Case) -> Ready {
    let built = rules().map(|(line, rule)| {
        let rule = if case.flat { rule.flat() } else { rule };
        let structure = Structure::build(&case.prims, &rule, &mut ()).unwrap();
        let targets = Targets::of(&case.prims, case.flat, &[&structure]);
        (line, structure, targets)
    });
    let structures = built.collect();
    Ready { case, structures }
}

/// Calls `shoot` with rays for every structure over every scene; says where it panicked.
fn watched(shoot: impl Fn(&Structure, &Prims, &Ray) + Sync) {
    READY.par_iter().enumerate().for_each(|(i, Ready { case, structures })| {
        let seed = i as u64 + 1;
        for (line, structure, targets) in structures {
            let mut random = Random::new(seed);
            for i in 0..RAYS {
                let Some(ray) = targets.ray(&case.prims, i, &mut random) else { continue };
                let at = At { scene: &case.name, line, number: i, ray };
                shoot(structure, &case.prims, &ray);
                drop(at);
            }
        }
    });
}

/// Says where a law was broken.
struct At<'a> {
    scene: &'a str,
    line: &'a str,
    number: u32,
    ray: Ray,
}

impl Drop for At<'_> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            eprintln!("broken by {}, {}, ray {}: {:?}", self.scene, self.line, self.number, self.ray);
        }
    }
}

fn is_distant(events: &[Visit]) -> bool {
    matches!(events.first(), Some(Visit::Distant { .. } | Visit::Extreme { .. }))
}

#[test]
fn who_watches_changes_nothing() {
    watched(|structure, prims, ray| {
        for want in [Want::Nearest, Want::Any] {
            let unwatched = structure.walk(prims, ray, want, &mut ());
            let (mut cost, mut events, mut short) = (Cost::default(), Vec::new(), Trace::new(5));
            assert_eq!(structure.walk(prims, ray, want, &mut cost), unwatched);
            assert_eq!(structure.walk(prims, ray, want, &mut (&mut events, &mut short)), unwatched);

            // Counting the tape is counting the walk.
            let mut counted = Cost::default();
            for &event in &events {
                counted.on(event);
            }
            assert_eq!(counted, cost);

            // A short tape is the beginning of the long one.
            let kept = events.len().min(5);
            assert_eq!(format!("{:?}", short.events), format!("{:?}", &events[..kept]));
            assert_eq!(short.lost as usize, events.len() - kept);
        }
    });
}

fn the_last_better_hit_is_the_answer(_: &Structure, events: &[Visit], hit: Option<Hit>) {
    let mut best: Option<Hit> = None;
    for event in events {
        match *event {
            Visit::Better { prim, t, before } => {
                assert_eq!(before, best.map_or(f32::INFINITY, |best| best.t));
                assert!(best.is_none_or(|best| t < best.t || (t == best.t && prim < best.prim)));
                best = Some(Hit { t, prim, inner: None });
            }
            Visit::End { hit: found, t, .. } => {
                assert_eq!((found, t), (best.is_some(), best.map_or(f32::INFINITY, |best| best.t)));
            }
            _ => {}
        }
    }
    assert_eq!(best, hit);
}

fn a_walk_ends_once_and_last(_: &Structure, events: &[Visit], hit: Option<Hit>) {
    let ends = events.iter().filter(|event| matches!(event, Visit::End { .. })).count();
    assert_eq!(ends, 1);
    let Some(&Visit::End { why, .. }) = events.last() else { panic!("the last event is no end") };
    match why {
        Ending::Found | Ending::Settled => assert!(hit.is_some()),
        Ending::Outside => assert!(hit.is_none()),
        Ending::Exhausted => {}
    }
}

fn each_pop_or_drop_had_its_push(_: &Structure, events: &[Visit], _: Option<Hit>) {
    let mut stack: Vec<(NodeId, [u32; 2])> = Vec::new();
    let bits = |near: f32, far: f32| [near.to_bits(), far.to_bits()];
    for event in events {
        match *event {
            Visit::Push { node, t_near, t_far, depth } => {
                stack.push((node, bits(t_near, t_far)));
                assert_eq!(stack.len(), depth as usize);
            }
            Visit::Pop { node, t_near, t_far, depth } => {
                assert_eq!(stack.pop(), Some((node, bits(t_near, t_far))));
                assert_eq!(stack.len(), depth as usize);
            }
            Visit::Drop { node, t_near, t_far, best_t, depth } => {
                assert!(best_t < t_near, "dropped what may hold the answer");
                assert_eq!(stack.pop(), Some((node, bits(t_near, t_far))));
                assert_eq!(stack.len(), depth as usize);
            }
            // A shadow ray leaves what waits where it is.
            Visit::End { why, .. } if why != Ending::Found => assert!(stack.is_empty()),
            _ => {}
        }
    }
}

fn a_childs_interval_lies_in_its_parents(structure: &Structure, events: &[Visit], _: Option<Hit>) {
    if is_distant(events) {
        return;
    }
    let mut within: Vec<Option<Interval>> = vec![None; structure.node_count()];
    for event in events {
        let &Visit::Enter { place: Place::Node(node), t_near, t_far, leaf, prims } = event else { continue };
        assert!(t_near <= t_far);
        let children = structure.children(node);
        assert_eq!(leaf, children.is_empty());
        assert_eq!(prims as usize, structure.leaf_prims(node).len());
        if let Some(parent) = within[node.index()] {
            assert!(parent.near <= t_near && t_far <= parent.far, "node {node} leaves its parent's interval");
        } else {
            assert_eq!(node, NodeId::ROOT, "node {node} entered before its parent");
        }
        within[node.index()] = None;
        for child in children {
            assert!(within[child.index()].is_none(), "node {node} entered twice");
            within[child.index()] = Some(Interval::new(t_near, t_far));
        }
    }
}

fn a_kd_split_sends_the_ray_where_its_interval_is(structure: &Structure, events: &[Visit], _: Option<Hit>) {
    for event in events {
        let &Visit::Split { node, near, far, t, t_near, t_far, side } = event else { continue };
        let Some((axis, plane)) = structure.split(node) else { continue };
        let mut children = [near, far];
        children.sort_unstable();
        assert_eq!(structure.children(node), children);
        let cut = events.iter().find_map(|event| match *event {
            Visit::Plane { node: cut, axis, plane, o, d, t, .. } if cut == node => Some((axis, plane, o, d, t)),
            _ => None,
        });
        let (cut_axis, cut_plane, o, d, cut_t) = cut.expect("a plane before the split");
        assert_eq!((cut_axis, cut_plane, cut_t.to_bits()), (axis, plane, t.to_bits()));
        let says = match side.word() {
            "both" => (t_near < t && t < t_far) || (d == 0.0 && o == plane),
            "near" => t_far <= t || (d == 0.0 && o != plane),
            _ => d != 0.0 && t <= t_near,
        };
        assert!(says, "{event:?}");
    }
}

fn cells_of_a_walk_are_face_neighbours_and_t_never_falls(structure: &Structure, events: &[Visit], _: Option<Hit>) {
    let Some(grid) = structure.grid() else { return };
    // For each level the cell the walk is in, with the cell that holds the level's grid.
    let mut levels: Vec<(Option<CellId>, Option<CellId>)> = vec![(None, None)];
    let mut t = f32::NEG_INFINITY;
    for event in events {
        match *event {
            Visit::Enter { place: Place::Cell(cell), t_near, t_far, prims, leaf } => {
                assert!(t_near <= t_far);
                assert_eq!(prims as usize, grid.cell_prims(cell).len());
                assert_eq!(leaf, grid.finer().iter().all(|(holder, _)| *holder != cell));
                assert!(t <= t_near, "t fell from {t} to {t_near}");
                let (holder, before) = levels.last_mut().unwrap();
                assert_eq!(grid.around(cell).1, *holder);
                if let Some(before) = before.replace(cell) {
                    let places = [before, cell].map(|cell| grid.cell_place(cell));
                    let apart: u32 = places[0].iter().zip(places[1]).map(|(&a, b)| a.abs_diff(b)).sum();
                    assert_eq!(apart, 1, "from {before:?} to {cell:?}");
                }
                t = if leaf { t_far } else { t_near };
            }
            Visit::Descend { cell, t_near, .. } => {
                assert_eq!((levels.last().unwrap().1, t_near), (Some(cell), t));
                levels.push((Some(cell), None));
            }
            Visit::Ascend { cell, t_far, .. } => {
                assert_eq!(levels.pop().unwrap().0, Some(cell));
                assert!(t <= t_far, "t fell from {t} to {t_far}");
                t = t_far;
            }
            Visit::Step { cell, t: over, .. } => assert_eq!((levels.last().unwrap().1, over), (Some(cell), t)),
            _ => {}
        }
    }
}

fn a_mailbox_skips_only_what_was_tested(_: &Structure, events: &[Visit], _: Option<Hit>) {
    let mut tested = BTreeSet::new();
    for event in events {
        match event {
            Visit::Test { prim, .. } => {
                tested.insert(*prim);
            }
            Visit::Skip { prim } => assert!(tested.contains(prim)),
            _ => {}
        }
    }
}

fn a_missed_box_is_not_opened(_: &Structure, events: &[Visit], _: Option<Hit>) {
    for pair in events.windows(2) {
        let [Visit::Volume { place, t_near, t_far, best_t, verdict }, next] = pair else { continue };
        match verdict {
            Verdict::Hit => assert!(t_near <= t_far),
            Verdict::Miss => assert!(t_near > t_far),
            Verdict::Cut => assert!(t_near <= t_far && best_t < t_near),
        }
        if *verdict != Verdict::Hit {
            assert!(!matches!(next, Visit::Enter { place: entered, .. } if entered == place));
        }
    }
}

fn every_event_is_in_the_vocabulary(_: &Structure, events: &[Visit], _: Option<Hit>) {
    for event in events {
        let (_, fields) = Visit::NAMES.iter().find(|(names, _)| names.contains(&event.name())).unwrap();
        assert_eq!(*fields, event.fields());
        assert!(fields.iter().all(|field| event.field(field).is_some()));
    }
}

#[test]
fn rays_that_cannot_be_walked_are_refused() {
    for wrong in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        for i in 0..3 {
            let mut p = Vec3::ONE;
            p[i] = wrong;
            assert_eq!(Ray::new(p, Vec3::X), Err(RayError::Origin));
            assert_eq!(Ray::new(Vec3::ZERO, p), Err(RayError::Direction));
        }
    }
    for zero in [Vec3::ZERO, -Vec3::ZERO, Vec3::new(0.0, -0.0, 0.0)] {
        assert_eq!(Ray::new(Vec3::ONE, zero), Err(RayError::NoDirection));
    }
    let ray = Ray::new(Vec3::ZERO, Vec3::X).unwrap();
    assert_eq!(ray.within(f32::NAN, 1.0), Err(RayError::Range));
    assert_eq!(ray.within(0.0, f32::NAN), Err(RayError::Range));
    assert_eq!(ray.within(f32::NEG_INFINITY, 1.0), Err(RayError::Range));
    assert!(ray.within(0.0, f32::INFINITY).is_ok());
}
