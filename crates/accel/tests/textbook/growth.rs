//! What builders tell is all there is to know: folding it gives the finished structure.

use glam::Vec3;
use raystep_accel::*;

/// Small triangles at random places.
fn mesh(seed: u64, count: usize) -> Mesh {
    let mut random = Random::new(seed);
    let mut mesh = Mesh::default();
    for i in 0..count as u32 {
        let mut point =
            |size: f32| Vec3::new(random.range(-size, size), random.range(-size, size), random.range(-size, size));
        let center = point(5.0);
        mesh.corners.extend([center + point(0.3), center + point(0.3), center + point(0.3)]);
        mesh.triangles.push([3 * i, 3 * i + 1, 3 * i + 2]);
    }
    mesh
}

fn bvh_rules() -> impl Iterator<Item = BvhRule> {
    BvhSplit::ALL.iter().map(|&split| BvhRule { split, leaf_size: 1, ..BvhRule::default() })
}

/// The rule that `kind key=value ...` spells.
fn rule(line: &str) -> Rule {
    let mut words = line.split(' ');
    let mut rule = Rule::default_for(words.next().unwrap()).unwrap();
    for (key, value) in words.map(|word| word.split_once('=').unwrap()) {
        rule.set(key, value).unwrap();
    }
    rule
}

#[test]
fn cells_hold_what_settled_in_them() {
    let mesh = mesh(1, 200);
    for line in
        ["grid resolution=3n", "grid resolution=density", "hashed-grid factor=2", "nested-grid factor=1 levels=3"]
    {
        let mut events: Vec<Grow> = Vec::new();
        let structure = Structure::build(&mesh, &rule(line), &mut events).unwrap();
        let grid = structure.grid().unwrap();

        let mut cells: Vec<Vec<PrimId>> = Vec::new();
        for event in events {
            match event {
                Grow::Resolve { nx, ny, nz, bounds, .. } => {
                    assert_eq!(([nx, ny, nz], bounds), (grid.lattice().resolution, grid.lattice().bounds));
                    cells = vec![Vec::new(); (nx * ny * nz) as usize];
                }
                Grow::Refine { cell, first, nx, ny, nz, prims } => {
                    // What the cell held goes into a grid of its own.
                    let held = std::mem::take(&mut cells[cell.index()]);
                    assert_eq!((held.len() as u32, cells.len()), (prims, first.index()));
                    cells.resize(cells.len() + (nx * ny * nz) as usize, Vec::new());
                }
                Grow::Settle { prim, place: Place::Cell(cell) } => cells[cell.index()].push(prim),
                _ => {}
            }
        }
        assert_eq!(cells.len(), grid.cell_count());
        for (cell, prims) in (0..).map(CellId).zip(&cells) {
            assert_eq!(grid.cell_prims(cell), prims);
            let [x, y, z] = grid.cell_place(cell);
            assert_eq!(grid.around(cell).0.cell_at(x, y, z), cell);
        }
    }
}

#[test]
fn nodes_are_what_was_opened_and_split() {
    let mesh = mesh(2, 200);
    for rule in bvh_rules() {
        let mut events: Vec<Grow> = Vec::new();
        let bvh = Bvh::build(&mesh, &rule, &mut events).unwrap();

        let mut bounds = vec![Aabb::EMPTY; bvh.node_count()];
        let mut children = vec![None; bvh.node_count()];
        let mut prims: Vec<Vec<PrimId>> = vec![Vec::new(); bvh.node_count()];
        for event in events {
            match event {
                Grow::Open { node, bounds: b, .. } => bounds[node.index()] = b,
                Grow::Split { node, below, above, .. } => children[node.index()] = Some([below, above]),
                Grow::Settle { prim, place: Place::Node(node) } => prims[node.index()].push(prim),
                _ => {}
            }
        }
        assert_eq!(bvh.node_bounds(), bounds);
        for node in (0..bvh.node_count() as u32).map(NodeId) {
            assert_eq!(bvh.children(node), children[node.index()]);
            assert_eq!(bvh.leaf_prims(node), prims[node.index()]);
        }
    }
}

#[test]
fn one_primitive_a_leaf_gives_the_same_number_of_nodes_under_every_rule() {
    let mesh = mesh(3, 1000);
    for rule in bvh_rules() {
        assert_eq!(Bvh::build(&mesh, &rule, &mut ()).unwrap().node_count(), 1999);
    }
}

#[test]
fn no_scene_makes_a_hierarchy_too_deep() {
    // Centres at ever smaller distances, the worst case of the middle rule, and many in one place.
    let mut shapes: Vec<Shape<'static>> =
        (0..250).map(|i| Shape::Sphere(Sphere { center: Vec3::X * 2.0_f32.powi(125 - i), radius: 0.0 })).collect();
    shapes.extend([Shape::Sphere(Sphere { center: Vec3::ZERO, radius: 1.0 }); 100]);
    for rule in bvh_rules() {
        let bvh = Bvh::build(&shapes.as_slice(), &rule, &mut ()).unwrap();
        let mut deepest = 0;
        let mut waiting = vec![(NodeId::ROOT, 0)];
        while let Some((node, depth)) = waiting.pop() {
            deepest = deepest.max(depth);
            waiting.extend(bvh.children(node).into_iter().flatten().map(|child| (child, depth + 1)));
        }
        assert!(deepest < Bvh::DEEPEST, "{deepest} under {:?}", rule.split);
        assert_eq!(bvh.node_count(), 2 * shapes.len() - 1);
    }
}

#[test]
fn grids_stay_within_memory() {
    // A thousand needles across everything, and a resolution that nobody can afford.
    let mut mesh = Mesh::default();
    for i in 0..1000_u32 {
        let shift = Vec3::splat(i as f32);
        mesh.corners.extend([shift, Vec3::new(1e4, 1e4, 0.0) - shift, Vec3::new(0.0, 1e4, 1e4) + shift]);
        mesh.triangles.push([3 * i, 3 * i + 1, 3 * i + 2]);
    }
    for kind in ["grid", "nested-grid levels=6 more_than=1 inner_factor=20"] {
        let rule = rule(&format!("{kind} nx=512 ny=512 nz=512"));
        let structure = Structure::build(&mesh, &rule, &mut ()).unwrap();
        let grid = structure.grid().unwrap();
        assert!(grid.lattice().cell_count() < 1 << 18 && grid.reference_count() > 1000, "{kind}");
        assert!(structure.bytes() < 300 << 20, "{kind}: {} bytes", structure.bytes());
    }
}

/// Gives up at the first question.
struct GivesUp;

impl Observer<Grow> for GivesUp {
    fn on(&mut self, _: Grow) {}

    fn cancelled(&self) -> bool {
        true
    }
}

#[test]
fn builders_give_up_when_told() {
    let mesh = mesh(4, 10);
    for kind in ["grid", "nested-grid", "hashed-grid", "kd", "bvh"] {
        let rule = Rule::default_for(kind).unwrap();
        assert_eq!(Structure::build(&mesh, &rule, &mut GivesUp), Err(Cancelled), "{kind}");
    }
}

#[test]
fn what_is_weighed_says_where_its_cost_comes_from() {
    let mesh = mesh(5, 120);
    let lines = [
        "kd split=sah",
        "kd split=median",
        "kd split=sah empty_bonus=0.5 traversal_cost=3 intersection_cost=7",
        "bsp",
        "bsp planes=candidates",
        "bvh split=sweep",
        "bvh split=binned",
        "bvh split=middle",
        "bvh split=median",
    ];
    for line in lines {
        // No triangle in space lies in an upright plane: a flat BSP tree has nothing to cut there.
        let flat = (line != "bsp").then(|| rule(line).flat());
        for rule in [Some(rule(line)), flat].into_iter().flatten() {
            let mut events: Vec<Grow> = Vec::new();
            Structure::build(&mesh, &rule, &mut events).unwrap();
            let weighed = events.iter().filter(|event| matches!(event, Grow::Weigh { .. }));
            assert!(weighed.clone().next().is_some(), "{line}: {rule:?}");
            for event in weighed {
                let &Grow::Weigh {
                    below,
                    above,
                    size,
                    size_below,
                    size_above,
                    p_below,
                    p_above,
                    step,
                    test,
                    bonus,
                    cost,
                    ..
                } = event
                else {
                    continue;
                };
                assert_eq!((p_below, p_above), (size_below / size, size_above / size), "{line}: {event:?}");
                assert_eq!(bonus < 1.0, line.starts_with("kd") && (below == 0 || above == 0), "{line}: {event:?}");
                let sum = bonus * (step + test * (p_below * below as f32 + p_above * above as f32));
                assert!((sum - cost).abs() <= 1e-6 * cost.abs(), "{line}: {sum}: {event:?}");
            }
        }
    }
}

#[test]
fn what_is_cut_by_hand_is_weighed_last_and_taken_whatever_it_costs() {
    let check = |line: &str, cut: &str| {
        let mesh = mesh(9, 60);
        let built = |rule: &Rule| {
            let mut events: Vec<Grow> = Vec::new();
            let structure = Structure::build(&mesh, rule, &mut events).unwrap();
            (structure, events)
        };
        let (plain, mut by_hand) = (rule(line), rule(line));
        by_hand.set("cut", cut).unwrap();
        let chosen = by_hand.by_hand().unwrap().cuts().next().unwrap();
        let ((usual, before), (other, after)) = (built(&plain), built(&by_hand));
        let of_node = |events: &[Grow]| {
            let events = events.iter().filter(|event| event.place() == Place::Node(chosen.node));
            events.copied().filter(|event| matches!(event, Grow::Weigh { .. } | Grow::Split { .. })).collect::<Vec<_>>()
        };
        let (before, after) = (of_node(&before), of_node(&after));
        // All that was weighed is weighed again; then the cut that was chosen, and that one is taken.
        let usual_weighed = before.iter().filter(|event| matches!(event, Grow::Weigh { .. })).count();
        let alone = matches!(plain, Rule::Bvh(BvhRule { split: BvhSplit::Middle | BvhSplit::Median, .. }));
        let usual_weighed = if alone { 0 } else { usual_weighed };
        assert_eq!(after[..usual_weighed], before[..usual_weighed], "{line} {cut}");
        let [weigh, Grow::Split { axis, plane, .. }] = after[usual_weighed..] else {
            panic!("{line} {cut}: {:?}", &after[usual_weighed..])
        };
        assert_eq!((axis, plane), (chosen.axis.into(), chosen.at), "{line} {cut}");
        // Asked for it alone, the builder tells the same.
        assert_eq!(Structure::weigh(&mesh, &plain, chosen), Some(weigh), "{line} {cut}");
        assert_eq!(Structure::weigh(&mesh, &by_hand, chosen), Some(weigh), "{line} {cut}");
        // Rays do not care where nodes are cut.
        assert_ne!(usual, other, "{line} {cut}");
        let mut random = Random::new(3);
        let mut point = |size: f32| Vec3::new(random.range(-size, size), random.range(-size, size), size);
        for _ in 0..300 {
            let ray = Ray::new(point(6.0), -point(3.0)).unwrap();
            let hit = |structure: &Structure| structure.intersect(&mesh, &ray, &mut ());
            assert_eq!(hit(&other), hit(&Structure::List(List)), "{line} {cut} {ray:?}");
        }
    };
    for split in ["sah", "middle", "median"] {
        check(&format!("kd split={split} max_depth=5"), "0:x=-4.5");
        check(&format!("kd split={split} max_depth=5"), "2:y=1.25");
    }
    check("kd split=sah intersection_cost=0.1", "0:z=0.5");
    for split in ["sweep", "binned", "middle", "median"] {
        check(&format!("bvh split={split}"), "0:x=-3");
        check(&format!("bvh split={split}"), "1:z=0.75");
    }
    // What leaves one side empty, or names no node that is weighed, is no cut.
    let none = |line: &str, node, at| {
        let cut = HandCut { node: NodeId(node), axis: Axis::X, at };
        assert_eq!(Structure::weigh(&mesh(9, 60), &rule(line), cut), None, "{line} {cut}");
    };
    none("kd", 0, 100.0);
    none("bvh", 0, -100.0);
    none("kd", 4000, 0.0);
    none("octree", 0, 0.0);
    none("bvh builder=bottom-up", 0, 0.0);
}
