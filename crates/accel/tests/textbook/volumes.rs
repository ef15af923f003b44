//! What every volume and every builder keeps to.

use glam::{Quat, Vec3};
use raystep_accel::*;

fn point(random: &mut Random, size: f32) -> Vec3 {
    Vec3::new(random.range(-size, size), random.range(-size, size), random.range(-size, size))
}

fn triangle(a: Vec3, b: Vec3, c: Vec3) -> Shape<'static> {
    Shape::Triangle(Triangle { a, b, c })
}

/// Sets from easy to nasty: a soup, round things, all in one plane, on one line, in one point.
fn sets() -> Vec<Vec<Shape<'static>>> {
    let random = &mut Random::new(7);
    let soup = (0..30).map(|_| triangle(point(random, 1.0), point(random, 1.0), point(random, 1.0))).collect();
    let round = (0..20)
        .flat_map(|i| {
            let (center, radius) = (point(random, 1.0), random.range(0.0, 0.5));
            let normal = point(random, 1.0).normalize_or(Vec3::Z);
            let second = Shape::Disc(Disc { center: center + normal, normal, radius });
            [Shape::Sphere(Sphere { center, radius: if i == 0 { 0.0 } else { radius } }), second]
        })
        .collect();
    let mut flat = |at: fn(f32, f32) -> Vec3| {
        let mut one = || at(random.range(-1.0, 1.0), random.range(-1.0, 1.0));
        (0..10).map(|_| triangle(one(), one(), one())).collect()
    };
    let (plane, line) = (flat(|u, v| Vec3::new(u, v, u * 0.5 - v)), flat(|u, _| Vec3::new(u, u * 2.0, 1.0 - u)));
    let far =
        (0..10).map(|i| triangle(Vec3::splat(1.5e5), Vec3::splat(1.5e5 + i as f32), Vec3::new(1.5e5, 1.5e5, 1e5)));
    vec![soup, round, plane, line, vec![triangle(Vec3::ONE, Vec3::ONE, Vec3::ONE); 3], far.collect()]
}

fn rule(volume: BvhVolume, builder: BvhBuilder) -> BvhRule {
    BvhRule { volume, builder, leaf_size: 1, ..BvhRule::default() }
}

fn rules() -> impl Iterator<Item = BvhRule> {
    BvhVolume::ALL.iter().flat_map(|&volume| BvhBuilder::ALL.iter().map(move |&builder| rule(volume, builder)))
}

/// Points on a shape, those that stick out furthest.
fn points_of(shape: &Shape<'_>) -> Vec<Vec3> {
    match shape {
        Shape::Triangle(t) => vec![t.a, t.b, t.c],
        Shape::Sphere(s) => {
            Vec3::AXES.into_iter().flat_map(|n| [s.center + n * s.radius, s.center - n * s.radius]).collect()
        }
        Shape::Disc(d) => {
            let (u, v) = d.normal.any_orthonormal_pair();
            let rim = |n: Vec3| d.center + n * (d.radius * 0.99999);
            vec![rim(u), rim(-u), rim(v), rim(-v), rim((u + v).normalize()), rim((u - v).normalize())]
        }
        _ => unreachable!("none of these is in the sets"),
    }
}

/// Whether a point lies in the body that rays are tested against.
fn holds(tree: &AnyBvh, node: NodeId, p: Vec3) -> bool {
    let ray = Ray::new(p, Vec3::new(0.3, -0.7, 0.2)).unwrap().within(0.0, 0.0).unwrap();
    !tree.meet(node, &ray, &mut ()).is_empty()
}

#[test]
fn every_node_holds_the_primitives_below_it() {
    for set in sets() {
        for rule in rules() {
            let tree = AnyBvh::build(&set.as_slice(), &rule, &mut ()).unwrap();
            let mut waiting = vec![(NodeId::ROOT, vec![])];
            let mut seen = 0;
            while let Some((node, mut path)) = waiting.pop() {
                path.push(node);
                for prim in tree.leaf_prims(node) {
                    seen += 1;
                    for p in points_of(&set[prim.index()]) {
                        for &above in &path {
                            assert!(holds(&tree, above, p), "{rule:?}: node {above} leaves out {p} of {prim}");
                        }
                    }
                }
                waiting.extend(tree.children(node).into_iter().flatten().map(|child| (child, path.clone())));
            }
            assert_eq!(seen, set.len());
        }
    }
}

#[test]
fn a_thousand_triangles_give_1999_nodes_under_every_builder() {
    let random = &mut Random::new(3);
    let mut one = || {
        let at = point(random, 5.0);
        triangle(at, at + point(random, 0.3), at + point(random, 0.3))
    };
    let set: Vec<Shape<'static>> = (0..1000).map(|_| one()).collect();
    for &builder in BvhBuilder::ALL {
        for volume in [BvhVolume::Aabb, BvhVolume::Sphere, BvhVolume::KDop14] {
            let tree = AnyBvh::build(&set.as_slice(), &rule(volume, builder), &mut ()).unwrap();
            assert_eq!(tree.node_count(), 1999, "{volume:?} {builder:?}");
        }
    }
}

/// A tree over points, as nested brackets.
fn brackets(tree: &AnyBvh, node: NodeId, names: &[f32]) -> String {
    match tree.children(node) {
        None => tree.leaf_prims(node).iter().map(|prim| names[prim.index()].to_string()).collect(),
        Some(children) => {
            let mut parts = children.map(|child| brackets(tree, child, names));
            parts.sort_by_key(|part| (part.starts_with(char::is_numeric), part.clone()));
            format!("({})", parts.join(","))
        }
    }
}

#[test]
fn four_points_on_a_line_show_from_which_end_a_tree_was_built() {
    let names = [0.0, 1.0, 3.0, 7.0];
    let set = names.map(|x| Shape::Sphere(Sphere { center: Vec3::X * x, radius: 0.0 }));
    for volume in BvhVolume::ALL {
        let told = |builder| {
            let rule = BvhRule { split: BvhSplit::Median, ..rule(*volume, builder) };
            brackets(&AnyBvh::build(&set.as_slice(), &rule, &mut ()).unwrap(), NodeId::ROOT, &names)
        };
        assert_eq!(told(BvhBuilder::BottomUp), "(((0,1),3),7)", "{volume:?}");
        assert_eq!(told(BvhBuilder::Ploc), "(((0,1),3),7)", "{volume:?}");
        assert_eq!(told(BvhBuilder::TopDown), "((0,1),(3,7))", "{volume:?}");
    }
}

#[test]
fn no_scene_makes_a_tree_too_deep() {
    let mut set: Vec<Shape<'static>> =
        (0..120).map(|i| Shape::Sphere(Sphere { center: Vec3::X * 2.0_f32.powi(60 - i), radius: 0.0 })).collect();
    set.extend([Shape::Sphere(Sphere { center: Vec3::ZERO, radius: 1.0 }); 300]);
    for rule in rules() {
        let tree = AnyBvh::build(&set.as_slice(), &rule, &mut ()).unwrap();
        let mut waiting = vec![(NodeId::ROOT, 0)];
        while let Some((node, depth)) = waiting.pop() {
            assert!(depth < Bvh::DEEPEST, "{rule:?}");
            waiting.extend(tree.children(node).into_iter().flatten().map(|child| (child, depth + 1)));
        }
        assert_eq!(tree.node_count(), 2 * set.len() - 1);
    }
}

#[test]
fn the_corners_of_a_hull_are_corners_of_its_set() {
    for set in sets() {
        let ids = || (0..set.len() as u32).map(PrimId);
        let bounds = ids().fold(Aabb::EMPTY, |all, prim| all.union(set.as_slice().bounds(prim)));
        let hull = Hull::fit(&set.as_slice(), ids(), &bounds, Axes::Xyz, &mut ()).expect("nobody cancels");
        let mut corners = Vec::new();
        for shape in &set {
            shape.corners(|corner| corners.push(corner.at));
        }
        assert!(hull.corners.iter().all(|corner| corners.contains(corner)));
        for p in set.iter().flat_map(points_of) {
            for (n, offset) in &hull.planes {
                let out = n.as_dvec3().dot((p - bounds.center()).as_dvec3()) - f64::from(*offset);
                assert!(out <= 1e-5 * f64::from(bounds.extent().length()), "{out}");
            }
        }
    }
}

#[test]
fn a_merged_sphere_holds_both() {
    let random = &mut Random::new(1);
    for _ in 0..1000 {
        let mut one = || Sphere { center: point(random, 2.0), radius: random.range(0.0, 1.0) };
        let (a, b) = (one(), one());
        let both = a.union(b);
        for part in [a, b] {
            assert!((part.center - both.center).length() + part.radius <= both.radius * 1.000_01);
        }
    }
}

/// The twelve triangles of a box with sides 1, 2 and 3, turned.
fn turned_box(turn: Quat) -> Vec<Shape<'static>> {
    let corner = |i: usize| turn * Vec3::new((i & 1) as f32, (i >> 1 & 1) as f32 * 2.0, (i >> 2) as f32 * 3.0);
    let sides = [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]];
    let halves = |[a, b, c, d]: [usize; 4]| {
        [triangle(corner(a), corner(b), corner(c)), triangle(corner(a), corner(c), corner(d))]
    };
    sides.into_iter().flat_map(halves).collect()
}

#[test]
fn a_turned_box_is_held_tightest_by_its_own_box_and_by_its_hull() {
    let set = turned_box(Quat::from_axis_angle(Vec3::new(1.0, 2.0, 3.0).normalize(), 0.7));
    let of = |volume| Appraisal::of(&set.as_slice(), volume, 2000, 5);
    for volume in [BvhVolume::Obb, BvhVolume::Hull] {
        let found = of(volume);
        assert!((found.content - 6.0).abs() < 0.02, "{volume:?}: {found:?}");
        assert!((found.area - 22.0).abs() < 0.05, "{volume:?}: {found:?}");
        assert!(found.vain_share() < 0.02, "{volume:?}: {found:?}");
    }
    let contents = [BvhVolume::Hull, BvhVolume::KDop26, BvhVolume::KDop14, BvhVolume::Aabb].map(|v| of(v).content);
    assert!(contents.is_sorted(), "{contents:?}");
    // The sphere around its diagonal.
    let radius = 14.0_f32.sqrt() / 2.0;
    assert!((of(BvhVolume::Sphere).area / (4.0 * std::f32::consts::PI * radius * radius) - 1.0).abs() < 1e-4);
    // What is met in vain is met, and the rays are the same for all.
    assert_eq!(
        of(BvhVolume::Aabb).met - of(BvhVolume::Aabb).in_vain,
        of(BvhVolume::Sphere).met - of(BvhVolume::Sphere).in_vain
    );
}

#[test]
fn simple_volumes_cost_little_and_let_much_in() {
    let set = turned_box(Quat::from_axis_angle(Vec3::new(1.0, 2.0, 3.0).normalize(), 0.7));
    let of = |volume| Appraisal::of(&set.as_slice(), volume, 2000, 5);
    // A sphere is one equation, a box three slabs, an 18-DOP nine; a hull has as many faces as the box.
    let table = [
        (BvhVolume::Sphere, 1.0),
        (BvhVolume::Aabb, 3.0),
        (BvhVolume::Obb, 3.0),
        (BvhVolume::KDop18, 9.0),
        (BvhVolume::Hull, 6.0),
    ];
    for (volume, most) in table {
        let cuts = of(volume).cuts;
        assert!(cuts > 0.0 && cuts <= most, "{volume:?}: {cuts}");
        // What is drawn of it is what was measured.
        let outline = Appraisal::outline(&set.as_slice(), volume);
        assert!((outline.content() - of(volume).content).abs() < 1e-6, "{volume:?}");
    }
    assert_eq!(of(BvhVolume::Sphere).cuts, 1.0);
    assert_eq!(of(BvhVolume::Aabb).cuts, 3.0);
    assert!(of(BvhVolume::Sphere).vain_share() > of(BvhVolume::Obb).vain_share());
}
