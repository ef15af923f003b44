//! What the fitting of a volume tells: facts that hold for the set, in the order in which they come to be.

use glam::Vec3;
use raystep_accel::*;

fn point(random: &mut Random, size: f32) -> Vec3 {
    Vec3::new(random.range(-size, size), random.range(-size, size), random.range(-size, size))
}

fn triangle(a: Vec3, b: Vec3, c: Vec3) -> Shape<'static> {
    Shape::Triangle(Triangle { a, b, c })
}

/// A soup, a long thin one, a thousand triangles, a cube of walls, round things, all in a plane, on a line, in a point.
fn sets() -> Vec<(&'static str, Vec<Shape<'static>>)> {
    let random = &mut Random::new(11);
    let mut soup = |many: usize, stretch: Vec3| -> Vec<Shape<'static>> {
        let mut one = || point(random, 1.0) * stretch;
        (0..many).map(|_| triangle(one(), one(), one())).collect()
    };
    let mut sets = vec![
        ("soup", soup(30, Vec3::ONE)),
        ("long", soup(40, Vec3::new(5.0, 0.3, 1.0))),
        ("many", soup(1000, Vec3::new(1.0, 2.0, 3.0))),
        ("plane", soup(12, Vec3::new(1.0, 1.0, 0.0))),
        ("line", soup(6, Vec3::new(1.0, 0.0, 0.0))),
        ("point", vec![triangle(Vec3::ONE, Vec3::ONE, Vec3::ONE); 2]),
    ];
    let corner = |index: u32| Vec3::new((index & 1) as f32, (index >> 1 & 1) as f32, (index >> 2) as f32);
    let cube = (0..6).map(|i| triangle(corner(i), corner(i + 1), corner(i + 2))).collect();
    sets.push(("cube", cube));
    let ball = |i: usize| Shape::Sphere(Sphere { center: point(random, 1.0), radius: 0.1 + 0.02 * i as f32 });
    sets.push(("round", (0..9).map(ball).collect()));
    sets
}

fn told(set: &[Shape<'static>], volume: BvhVolume) -> (Outline, Vec<Fit>) {
    let mut events = Vec::new();
    let outline = fit_around(&set, volume, Axes::Xyz, &mut events).expect("nobody cancels");
    (outline, events)
}

#[test]
fn who_watches_changes_nothing_and_every_fitting_begins_and_ends() {
    for (name, set) in sets() {
        for &volume in BvhVolume::ALL {
            let (outline, events) = told(&set, volume);
            let alone = fit_around(&set.as_slice(), volume, Axes::Xyz, &mut ()).expect("nobody cancels");
            assert_eq!(outline, alone, "{name} {volume:?}");
            assert_eq!(outline, Appraisal::outline(&set.as_slice(), volume), "{name} {volume:?}");
            // It is the volume of a tree with nothing but a root.
            let rule = BvhRule { volume, leaf_size: u32::MAX, ..BvhRule::default() };
            let root = AnyBvh::build(&set.as_slice(), &rule, &mut ()).expect("nobody cancels");
            assert_eq!(outline, root.outline(NodeId::ROOT), "{name} {volume:?}");
            let Some(&Fit::End { planes, content, surface, bytes }) = events.last() else {
                panic!("{name} {volume:?}")
            };
            let appraised = Appraisal::of(&set.as_slice(), volume, 10, 1);
            let same = (appraised.content as f32, appraised.area, appraised.bytes as u32);
            assert_eq!((content, surface, bytes), same, "{name} {volume:?}");
            assert_eq!(planes == 0, volume == BvhVolume::Sphere, "{name} {volume:?}");
            for event in &events {
                let known = Fit::NAMES.iter().find(|(names, _)| names.contains(&event.name())).expect("a known name");
                assert_eq!(known.1, event.fields());
            }
        }
    }
}

#[test]
fn a_sphere_grows_by_the_furthest_point_until_none_lies_outside() {
    for (name, set) in sets() {
        let (_, events) = told(&set, BvhVolume::Sphere);
        let mut reached = 0.0;
        let mut last = None;
        for event in &events {
            match *event {
                Fit::Far { far, radius, outside, .. } => {
                    assert_eq!(radius, reached, "{name}");
                    // Rounding decides what lies so near.
                    assert!(outside == (far > radius) || (far - radius).abs() <= 1e-5 * radius, "{name}: {event:?}");
                    last = Some(outside);
                }
                Fit::Ball { radius, .. } => {
                    assert!(radius >= reached * 0.99999, "{name}: {radius} after {reached}");
                    reached = radius;
                }
                Fit::Try { on, .. } => assert!((1..=4).contains(&on), "{name}"),
                _ => {}
            }
        }
        assert_eq!(last, Some(false), "{name}");
        let Some(Fit::Sphere { radius, .. }) = events.iter().find(|event| matches!(event, Fit::Sphere { .. })).copied()
        else {
            panic!("{name}")
        };
        let round = name == "round";
        assert!(radius >= reached && (round || radius <= reached * 1.001 + 1e-6), "{name}: {radius} {reached}");
    }
}

#[test]
fn an_oriented_box_is_the_smallest_that_was_tried() {
    for (name, set) in sets() {
        let (outline, events) = told(&set, BvhVolume::Obb);
        let (mut tried, mut least) = (Vec::new(), f32::INFINITY);
        for event in &events {
            match *event {
                Fit::Frame { surface, .. } => tried.push(surface),
                Fit::Choose { surface, taken, .. } => {
                    let best = tried.drain(..).fold(f32::INFINITY, f32::min);
                    // Of boxes without a surface the sum of the sides decides.
                    assert!(surface - best <= 1e-4, "{name}: {surface} {best}");
                    if taken {
                        assert!(surface <= least + 1e-4, "{name}: {surface} after {least}");
                        least = surface;
                    }
                }
                _ => {}
            }
        }
        assert!(tried.is_empty(), "{name}");
        let axes: Vec<&str> = events.iter().filter_map(pushed).collect();
        let all = axes.iter().filter(|axis| ["u", "v", "w"].contains(axis)).count();
        assert!(all == axes.len() && ["u", "v", "w"].iter().all(|axis| axes.contains(axis)), "{name}: {axes:?}");
        // Where few points choose for many, the box around all of them is larger than theirs.
        let surface = outline.measure(Measure::Area);
        // Single precision moves the centre, and all sides grow by that: by some 10^-6 where they are about two long.
        let near = 1e-3 * surface + 4e-5;
        assert!(surface >= least - near, "{name}: {surface} {least}");
        let all = set.iter().all(|shape| matches!(shape, Shape::Triangle(_))) && set.len() * 3 <= 32;
        assert!(!all || surface <= least + near, "{name}: {surface} {least}");
    }
}

/// Points and balls of all sizes, most of them on whole numbers or just beside one: no box is turned thousands of times.
#[test]
fn a_box_is_turned_a_few_times() {
    let random = &mut Random::new(23);
    for run in 0..50_000 {
        let scale = [1.0, 1024.0, 1.0 / 4_194_304.0, 16_777_216.0][random.below(4) as usize];
        let mut number = || {
            let whole = random.below(11) as f32 - 5.0;
            let beside = [whole, whole.next_up(), whole.next_down(), whole / 3.0, whole * 16.0 * f32::EPSILON];
            scale * beside[random.below(12).saturating_sub(7) as usize]
        };
        let mut shape = |round: bool| {
            let [a, b, c] = [0; 3].map(|_| Vec3::new(number(), number(), number()));
            let radius = b.x.abs().max(scale / 1024.0);
            if round { Shape::Sphere(Sphere { center: a, radius }) } else { triangle(a, b, c) }
        };
        let set: Vec<_> = (0..=run % 5).map(|i| shape((run / 7 + i) % 3 == 0)).collect();
        let (_, events) = told(&set, BvhVolume::Obb);
        let chosen = events.iter().filter(|event| matches!(event, Fit::Choose { .. })).count();
        assert!(chosen <= 222, "run {run}: {chosen}");
    }
}

fn pushed(event: &Fit) -> Option<&'static str> {
    if let Fit::Push { axis, .. } = event { Some(axis.name()) } else { None }
}

#[test]
fn a_k_dop_has_two_planes_across_each_of_its_directions() {
    for (name, set) in sets() {
        for (volume, slanted) in [(BvhVolume::KDop6, 0), (BvhVolume::KDop18, 6), (BvhVolume::KDop26, 10)] {
            let (_, events) = told(&set, volume);
            let mut axes: Vec<&str> = events.iter().filter_map(pushed).collect();
            assert_eq!(axes[..3], ["x", "y", "z"], "{name} {volume:?}");
            axes.sort_unstable();
            axes.dedup();
            assert_eq!(axes.len(), 3 + slanted, "{name} {volume:?}");
            // The last word on each direction holds every corner.
            for event in &events {
                let Fit::Push { axis, x, y, z, .. } = *event else { continue };
                let last = events.iter().rfind(|other| pushed(other) == Some(axis.name())).expect("it is there itself");
                let Fit::Push { low, high, .. } = *last else { continue };
                let middle = set.iter().fold(Aabb::EMPTY, |all, shape| all.union(shape.bounds())).center();
                for shape in &set {
                    shape.corners(|corner| {
                        let at = Vec3::new(x, y, z).dot(corner.at - middle);
                        assert!(at >= low - 1e-4 && at <= high + 1e-4, "{name} {volume:?} {axis}: {at}");
                    });
                }
            }
        }
    }
}

#[test]
fn a_hull_grows_corner_by_corner_and_stays_closed() {
    for (name, set) in sets() {
        let (_, events) = told(&set, BvhVolume::Hull);
        let mut faces = std::collections::BTreeMap::new();
        let mut corners = 0;
        let closed = |faces: &std::collections::BTreeMap<u32, [u32; 3]>| {
            // Every edge is passed once in each direction (and so Euler's V − E + F = 2 holds).
            let edges: Vec<[u32; 2]> = faces.values().flat_map(|[a, b, c]| [[*a, *b], [*b, *c], [*c, *a]]).collect();
            assert!(edges.iter().all(|[from, to]| edges.contains(&[*to, *from])), "{name}: an edge is open");
        };
        for event in &events {
            match *event {
                Fit::Seed { count, .. } => {
                    corners += 1;
                    assert_eq!(count, corners, "{name}");
                }
                Fit::Apex { count, far, .. } => {
                    closed(&faces);
                    corners += 1;
                    assert_eq!(count, corners, "{name}");
                    assert!(far > 0.0, "{name}");
                }
                Fit::Hide { face } => assert!(faces.remove(&face).is_some(), "{name}: face {face} is not there"),
                Fit::Make { face, a, b, c, .. } => {
                    assert!(faces.insert(face, [a, b, c]).is_none(), "{name}: face {face} is there twice");
                }
                Fit::Enough { faces: many, corners: kept, .. } => {
                    closed(&faces);
                    assert_eq!(many as usize, faces.len(), "{name}");
                    assert!(kept <= corners, "{name}");
                    assert_eq!(faces.len() as u32, 2 * kept - 4, "{name}: Euler");
                }
                Fit::Plane { face, .. } => assert!(faces.is_empty() || faces.contains_key(&face), "{name}"),
                _ => {}
            }
        }
        let planes = events.iter().filter(|event| matches!(event, Fit::Plane { .. })).count();
        let Some(&Fit::End { planes: told, .. }) = events.last() else { panic!("{name}") };
        assert_eq!(planes as u32, told, "{name}");
        assert_eq!(faces.is_empty(), ["plane", "line", "point"].contains(&name), "{name}");
    }
}

#[test]
fn a_fitting_can_be_given_up() {
    struct Impatient(u32);
    impl Observer<Fit> for Impatient {
        fn on(&mut self, _: Fit) {
            self.0 += 1;
        }

        fn cancelled(&self) -> bool {
            true
        }
    }
    let random = &mut Random::new(5);
    let set: Vec<Shape<'static>> =
        (0..2000).map(|_| triangle(point(random, 1.0), point(random, 1.0), point(random, 1.0))).collect();
    for &volume in BvhVolume::ALL.iter().filter(|volume| **volume != BvhVolume::KDop6) {
        let found = fit_around(&set.as_slice(), volume, Axes::Xyz, &mut Impatient(0));
        assert_eq!(found, Err(Cancelled), "{volume:?}");
    }
}
