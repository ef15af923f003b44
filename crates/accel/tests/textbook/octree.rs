//! The octree answers as brute force does, and a changed one is the one that would have been built.

use glam::Vec3;
use raystep_accel::{
    Accel, Axes, Cost, Each, Grow, List, Octree, OctreeRule, Place, PrimId, Random, Ray, Shape, Sphere, Triangle, Visit,
};

fn soup(random: &mut Random, n: usize) -> Vec<Shape<'static>> {
    let mut point = |spread: f32| {
        Vec3::new(random.range(-spread, spread), random.range(-spread, spread), random.range(-spread, spread))
    };
    (0..n)
        .map(|i| {
            let a = point(5.0);
            if i % 3 == 0 {
                Shape::Sphere(Sphere { center: a, radius: 0.3 })
            } else {
                Shape::Triangle(Triangle { a, b: a + point(1.0), c: a + point(1.0) })
            }
        })
        .collect()
}

fn ray(random: &mut Random) -> Ray {
    let mut number = |far: f32| if random.below(5) == 0 { 0.0 } else { random.range(-far, far) };
    let o = Vec3::new(number(8.0), number(8.0), number(8.0));
    let d = Vec3::new(number(1.0), number(1.0), number(1.0));
    Ray::new(o, if d == Vec3::ZERO { Vec3::X } else { d }).unwrap()
}

fn check(tree: &Octree, prims: &[Shape<'static>], random: &mut Random) {
    for _ in 0..5000 {
        let ray = ray(random);
        let mut visits = Vec::new();
        assert_eq!(tree.intersect(&prims, &ray, &mut visits), List.intersect(&prims, &ray, &mut ()), "{ray:?}");
        let pushes = visits.iter().filter(|visit| matches!(visit, Visit::Push { .. })).count();
        let pops = visits.iter().filter(|visit| matches!(visit, Visit::Pop { .. } | Visit::Drop { .. })).count();
        assert_eq!(pushes, pops);
    }
}

#[test]
fn an_octree_answers_as_brute_force_does() {
    let mut random = Random::new(43);
    for (n, rule) in [
        (0, OctreeRule::default()),
        (1, OctreeRule::default()),
        (200, OctreeRule::default()),
        (200, OctreeRule { max_depth: 3, min_objects: 1, mailbox: false, ..OctreeRule::default() }),
        (60, OctreeRule { axes: Axes::Xy, ..OctreeRule::default() }),
    ] {
        let prims = soup(&mut random, n);
        check(&Octree::build(&prims.as_slice(), &rule, &mut ()).unwrap(), &prims, &mut random);
    }
}

#[test]
fn at_most_four_children_of_eight_are_met() {
    let mut random = Random::new(44);
    let prims = soup(&mut random, 100);
    let tree = Octree::build(&prims.as_slice(), &OctreeRule::default(), &mut ()).unwrap();
    for _ in 0..2000 {
        let (mut pushed, mut most) = (0, 0);
        tree.intersect(
            &prims.as_slice(),
            &ray(&mut random),
            &mut Each(|visit| match visit {
                Visit::Enter { .. } => pushed = 0,
                Visit::Push { .. } => {
                    pushed += 1;
                    most = most.max(pushed);
                }
                _ => {}
            }),
        );
        assert!(most <= 3, "{most} children wait beside the one that is walked");
    }
}

/// Leaves with their cells, whatever ids the nodes have.
fn leaves(tree: &Octree) -> Vec<(String, Vec<PrimId>)> {
    let cells = tree.node_bounds();
    let mut leaves: Vec<_> = (0..tree.node_count() as u32)
        .map(raystep_accel::NodeId)
        .filter(|node| !cells[node.index()].is_empty() && tree.children(*node).is_empty())
        .map(|node| (format!("{:?}", cells[node.index()]), tree.leaf_prims(node).to_vec()))
        .collect();
    leaves.sort();
    leaves
}

#[test]
fn a_changed_octree_is_the_one_that_would_have_been_built() {
    let mut random = Random::new(45);
    let prims = soup(&mut random, 150);
    let rule = OctreeRule { max_depth: 6, min_objects: 3, ..OctreeRule::default() };
    let built = Octree::build(&prims.as_slice(), &rule, &mut ()).unwrap();
    let mut changed = built.clone();
    for round in 0..40 {
        let prim = PrimId(random.below(prims.len() as u32));
        let mut touched = 0;
        changed.remove(
            &prims.as_slice(),
            prim,
            &mut Each(|event| touched += usize::from(matches!(event, Grow::Touch { .. }))),
        );
        assert!(touched < built.node_count(), "round {round}: {touched} nodes touched");
        let gone = leaves(&changed);
        assert!(gone.iter().all(|(_, held)| !held.contains(&prim)));
        changed.insert(&prims.as_slice(), prim, &mut ()).unwrap();
        assert_eq!(leaves(&changed), leaves(&built), "round {round}");
    }
    check(&changed, &prims, &mut random);
}

#[test]
fn a_primitive_outside_is_refused() {
    let prims = [
        Shape::Sphere(Sphere { center: Vec3::ZERO, radius: 1.0 }),
        Shape::Sphere(Sphere { center: Vec3::splat(9.0), radius: 1.0 }),
    ];
    let mut tree = Octree::build(&&prims[..1], &OctreeRule::default(), &mut ()).unwrap();
    let before = tree.clone();
    assert!(tree.insert(&&prims[..], PrimId(1), &mut ()).is_err());
    assert_eq!(tree, before);
}

#[test]
fn folding_the_build_rebuilds_the_tree() {
    let mut random = Random::new(46);
    let prims = soup(&mut random, 120);
    let mut grown = Vec::new();
    let tree = Octree::build(&prims.as_slice(), &OctreeRule::default(), &mut grown).unwrap();
    let mut settled = vec![Vec::new(); tree.node_count()];
    let mut divided = 0;
    for event in grown {
        match event {
            Grow::Settle { prim, place: Place::Node(node) } => settled[node.index()].push(prim),
            Grow::Divide { node, first, ways, .. } => {
                assert_eq!(
                    tree.children(node),
                    (first.0..first.0 + ways).map(raystep_accel::NodeId).collect::<Vec<_>>()
                );
                divided += 1;
            }
            Grow::Open { node, bounds, .. } => assert_eq!(tree.node_bounds()[node.index()], bounds),
            _ => {}
        }
    }
    assert_eq!(divided * 8 + 1, tree.node_count());
    for (node, prims) in settled.iter().enumerate() {
        assert_eq!(tree.leaf_prims(raystep_accel::NodeId(node as u32)), prims.as_slice());
    }
}

/// Two balls of many thin triangles around one point each: every leaf near a point is crowded at any depth.
fn two_crowds() -> Vec<Shape<'static>> {
    let mut random = Random::new(47);
    let mut point = || Vec3::new(random.range(-1.0, 1.0), random.range(-1.0, 1.0), random.range(-1.0, 1.0));
    (0..400)
        .map(|i| {
            let center = Vec3::splat(if i % 2 == 0 { -3.0 } else { 3.0 });
            let b = center + point();
            Shape::Triangle(Triangle { a: center, b, c: b + 0.01 * point() })
        })
        .collect()
}

#[test]
fn one_crowd_does_not_take_the_room_of_another() {
    let prims = two_crowds();
    let rule = OctreeRule { max_depth: 16, min_objects: 1, ..OctreeRule::default() };
    let tree = Octree::build(&prims.as_slice(), &rule, &mut ()).unwrap();
    let cells = tree.node_bounds();
    // References on each side of the middle: both crowds are divided as finely.
    let mut sides = [0.0_f32; 2];
    for (node, cell) in (0..).map(raystep_accel::NodeId).zip(&cells) {
        sides[usize::from(cell.center().x > 0.0)] += tree.leaf_prims(node).len() as f32;
    }
    assert!((0.5..2.0).contains(&(sides[0] / sides[1])), "{sides:?}");
}

#[test]
fn a_ray_tests_few_primitives_of_a_closed_surface() {
    // A ball of 128 × 64 quads, each two triangles: six of them meet at every corner.
    let at = |i: u32, j: u32| {
        let (u, v) = (i as f32 / 128.0 * std::f32::consts::TAU, j as f32 / 64.0 * std::f32::consts::PI);
        Vec3::new(u.cos() * v.sin(), u.sin() * v.sin(), v.cos())
    };
    let quads = (0..128).flat_map(|i| (0..64).map(move |j| (i, j)));
    let prims: Vec<_> = quads
        .flat_map(|(i, j)| {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            [Shape::Triangle(Triangle { a, b, c }), Shape::Triangle(Triangle { a, b: c, c: d })]
        })
        .collect();
    let tree = Octree::build(&prims.as_slice(), &OctreeRule::default(), &mut ()).unwrap();
    let mut random = Random::new(48);
    let (mut cost, rays) = (Cost::default(), 500);
    for _ in 0..rays {
        let o = Vec3::new(-3.0, random.range(-1.0, 1.0), random.range(-1.0, 1.0));
        tree.intersect(&prims.as_slice(), &Ray::new(o, Vec3::X).unwrap(), &mut cost);
    }
    assert!(cost.prim_tests < 15 * rays, "{} tests by {rays} rays", cost.prim_tests);
}

#[test]
fn identical_primitives_end_with_a_bounded_tree() {
    let prims = vec![Shape::Sphere(Sphere { center: Vec3::ONE, radius: 0.5 }); 500];
    let rule = OctreeRule { max_depth: OctreeRule::DEEPEST, ..OctreeRule::default() };
    let tree = Octree::build(&prims.as_slice(), &rule, &mut ()).unwrap();
    assert!(tree.node_count() < 100_000, "{} nodes", tree.node_count());
}
