//! The BSP tree answers as brute force does, and its cells are what its planes leave of the box.

use glam::{Vec2, Vec3};
use raystep_accel::*;

fn soup(random: &mut Random, n: usize) -> Vec<Shape<'static>> {
    let mut point = |spread: f32| {
        Vec3::new(random.range(-spread, spread), random.range(-spread, spread), random.range(-spread, spread))
    };
    (0..n)
        .map(|i| {
            let a = point(5.0);
            match i % 4 {
                0 => Shape::Sphere(Sphere { center: a, radius: 0.3 }),
                1 => Shape::Disc(Disc { center: a, normal: point(1.0).normalize(), radius: 0.4 }),
                _ => Shape::Triangle(Triangle { a, b: a + point(1.0), c: a + point(1.0) }),
            }
        })
        .collect()
}

fn flat(random: &mut Random, n: usize) -> Vec<Shape<'static>> {
    let mut point = |spread: f32| Vec2::new(random.range(-spread, spread), random.range(-spread, spread));
    (0..n)
        .map(|i| {
            let from = point(5.0);
            match i % 3 {
                0 => Shape::Sphere(Sphere { center: from.extend(0.0), radius: 0.3 }),
                1 => {
                    let outline = vec![from, from + point(1.0), from + point(1.0)].leak();
                    Shape::Prism(Prism { outline, z: [-0.5, 0.5] })
                }
                _ => Shape::Wall(Wall { from, to: from + point(2.0), z: [-0.5, 0.5] }),
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

/// Every choice of planes and of what becomes of straddlers.
fn rules() -> impl Iterator<Item = BspRule> {
    let each = BspPlanes::ALL.iter().flat_map(|&planes| Straddlers::ALL.iter().map(move |&s| (planes, s)));
    each.map(|(planes, straddlers)| BspRule { planes, straddlers, min_objects: 1, ..BspRule::default() })
}

#[test]
fn a_bsp_tree_answers_as_brute_force_does() {
    let mut random = Random::new(50);
    for rule in rules() {
        for n in [0, 1, 7, 150] {
            let prims = soup(&mut random, n);
            let tree = Bsp::build(&prims.as_slice(), &rule, &mut ()).unwrap();
            for _ in 0..5000 {
                let ray = ray(&mut random);
                let right = List.intersect(&prims.as_slice(), &ray, &mut ());
                assert_eq!(tree.intersect(&prims.as_slice(), &ray, &mut ()), right, "{rule:?} {ray:?}");
            }
        }
    }
}

#[test]
fn a_flat_scene_is_split_by_lines() {
    let mut random = Random::new(51);
    let prims = flat(&mut random, 60);
    for rule in rules() {
        let rule = BspRule { axes: Axes::Xy, measure: Measure::Perimeter, ..rule };
        let tree = Bsp::build(&prims.as_slice(), &rule, &mut ()).unwrap();
        let nodes = (0..tree.node_count() as u32).map(NodeId);
        let planes: Vec<_> = nodes.filter_map(|node| tree.plane(node)).collect();
        assert!(planes.len() > 10 && planes.iter().all(|plane| plane.normal.z == 0.0));
        for _ in 0..5000 {
            let mut ray = ray(&mut random);
            if ray.d.truncate() == Vec2::ZERO {
                continue;
            }
            (ray.o.z, ray.d.z) = (0.0, 0.0);
            let right = List.intersect(&prims.as_slice(), &ray, &mut ());
            assert_eq!(tree.intersect(&prims.as_slice(), &ray, &mut ()), right, "{rule:?} {ray:?}");
        }
    }
}

#[test]
fn a_plane_cuts_a_cell_into_cells_that_share_it() {
    let mut random = Random::new(52);
    let prims = soup(&mut random, 80);
    for rule in rules() {
        let tree = Bsp::build(&prims.as_slice(), &rule, &mut ()).unwrap();
        let cells = tree.cells();
        for node in (0..tree.node_count() as u32).map(NodeId) {
            assert_eq!(tree.cell(node), cells[node.index()]);
            let Some((plane, children)) = tree.plane(node).zip(tree.children(node)) else { continue };
            let whole = &cells[node.index()];
            let [below, above] = children.map(|child| &cells[child.index()]);
            // All corners lie on their side.
            let height = |p: &Vec3| plane.normal.dot(*p) - plane.at;
            assert!(below.faces().flatten().all(|p| height(&p) < 1e-4));
            assert!(above.faces().flatten().all(|p| height(&p) > -1e-4));
            // The surfaces of both are the surface of the whole, and the cut twice.
            let sheet = whole.section(plane);
            assert!(sheet.len() > 2 && sheet.iter().all(|p| height(p).abs() < 1e-4));
            let cut: Vec3 = (2..sheet.len()).map(|i| (sheet[i - 1] - sheet[0]).cross(sheet[i] - sheet[0])).sum();
            let sum = below.measure(Measure::Area) + above.measure(Measure::Area);
            let expected = whole.measure(Measure::Area) + cut.length();
            assert!((sum - expected).abs() < 1e-3 * expected, "node {node}: {sum} instead of {expected}");
        }
    }
}

#[test]
fn a_polygon_in_the_way_of_many_is_cut_and_each_fragment_refers_to_it() {
    // One long wall from corner to corner, between short ones.
    let wall =
        |from: [f32; 2], to: [f32; 2]| Shape::Wall(Wall { from: Vec2::from(from), to: Vec2::from(to), z: [-0.5, 0.5] });
    let mut prims = vec![wall([0.0, 0.0], [8.0, 4.0])];
    for i in 0..8_u8 {
        let (x, y) = (f32::from(i) + 0.5, f32::from(i) * 0.5 + 0.25);
        prims.extend([wall([x, y + 0.5], [x + 0.2, y + 0.9]), wall([x, y - 0.5], [x + 0.2, y - 0.9])]);
    }
    let rule = BspRule {
        planes: BspPlanes::Candidates,
        min_objects: 1,
        axes: Axes::Xy,
        measure: Measure::Perimeter,
        traversal_cost: 0.0,
        ..BspRule::default()
    };
    // The leaves that refer to the long one: how many, and in how many of their cells it lies.
    let leaves = |straddlers| {
        let tree = Bsp::build(&prims.as_slice(), &BspRule { straddlers, ..rule }, &mut ()).unwrap();
        let leaves = || (0..tree.node_count() as u32).map(NodeId);
        for prim in (0..prims.len() as u32).map(PrimId) {
            assert!(leaves().any(|leaf| tree.leaf_prims(leaf).contains(&prim)), "nothing refers to {prim}");
        }
        let referring: Vec<NodeId> = leaves().filter(|leaf| tree.leaf_prims(*leaf).contains(&PrimId(0))).collect();
        let lies_in = |leaf: &&NodeId| prims[0].overlaps(&tree.cell(**leaf).bounds().padded(0.02));
        (referring.len(), referring.iter().filter(lies_in).count())
    };
    // Cut, it has a fragment in each cell on its way, and none beside.
    let (referring, on_its_way) = leaves(Straddlers::Cut);
    assert!(referring > 1 && on_its_way == referring, "{on_its_way} of {referring}");
    // Whole, its ends put it on both sides of planes that cut cells beside its way.
    let (referring, on_its_way) = leaves(Straddlers::Both);
    assert!(referring > on_its_way && on_its_way > 1, "{on_its_way} of {referring}");
}

#[test]
fn the_same_seed_gives_the_same_tree() {
    let mut random = Random::new(53);
    let prims = soup(&mut random, 200);
    let built = |seed: u32| Bsp::build(&prims.as_slice(), &BspRule { seed, ..BspRule::default() }, &mut ()).unwrap();
    assert_eq!(built(1), built(1));
    assert_ne!(built(1), built(2));
}

#[test]
fn identical_triangles_end_with_a_bounded_tree() {
    let corners = vec![Vec3::ZERO, Vec3::new(1.0, 0.2, 0.3), Vec3::new(0.3, 1.0, 0.8)];
    let pile = Mesh { corners, triangles: vec![[0, 1, 2]; 100_000] };
    for rule in rules() {
        let tree = Bsp::build(&pile, &BspRule { max_depth: 64, min_objects: 0, ..rule }, &mut ()).unwrap();
        assert!(tree.node_count() < 200 && tree.reference_count() < 3_300_000, "{rule:?}: {}", tree.node_count());
    }
}

#[test]
fn a_plane_test_costs_four_numbers_and_a_dot_product() {
    assert_eq!(Kd::PLANE_TEST, PlaneTest { numbers: 1, products: 0, sums: 1, quotients: 1 });
    assert_eq!(Bsp::PLANE_TEST, PlaneTest { numbers: 4, products: 6, sums: 5, quotients: 1 });
    assert_eq!((Kd::NODE_BYTES, Bsp::NODE_BYTES), (8, 20));
}
