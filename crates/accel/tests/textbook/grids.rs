//! The three grids beside each other: what is stored differs, what a ray meets does not.

use glam::Vec3;
use raystep_accel::*;

/// Small triangles in two far corners of a large box: nearly all cells are empty.
fn sparse() -> Vec<Shape<'static>> {
    let mut random = Random::new(63);
    let mut point =
        |size: f32| Vec3::new(random.range(-size, size), random.range(-size, size), random.range(-size, size));
    (0..300)
        .map(|i| {
            let a = Vec3::splat(if i % 2 == 0 { -20.0 } else { 20.0 }) + point(2.0);
            Shape::Triangle(Triangle { a, b: a + point(0.5), c: a + point(0.5) })
        })
        .collect()
}

/// Rays past and through both corners, some along an axis.
fn rays() -> Vec<Ray> {
    let mut random = Random::new(64);
    let mut point = || Vec3::new(random.range(-30.0, 30.0), random.range(-22.0, 22.0), random.range(-22.0, 22.0));
    (0..2000)
        .filter_map(|i| {
            let (o, to) = (point(), point());
            Ray::new(o, if i % 5 == 0 { Vec3::new(0.0, to.y, 0.0) } else { to - o }).ok()
        })
        .collect()
}

fn walked(grid: &impl Accel, prims: &[Shape<'static>], ray: &Ray) -> (Option<Hit>, Vec<Visit>) {
    let mut events = Vec::new();
    (grid.intersect(&prims, ray, &mut events), events)
}

#[test]
fn a_hashed_grid_holds_the_cells_of_the_uniform_one_and_is_walked_in_the_same_steps() {
    let shapes = sparse();
    let prims = shapes.as_slice();
    for mailbox in [true, false] {
        let rule = GridRule { mailbox, ..GridRule::default() };
        let dense = Grid::build(&prims, &rule, &mut ()).unwrap();
        let hashed = HashedGrid::build(&prims, &rule, &mut ()).unwrap();
        assert_eq!(hashed.lattice, dense.lattice);
        assert_eq!(hashed.reference_count(), dense.reference_count());
        for cell in (0..dense.cell_count() as u32).map(CellId) {
            assert_eq!(hashed.cell_prims(cell), dense.cell_prims(cell), "cell {cell}");
        }
        for ray in rays() {
            // The same walk, event for event, but for the search in the table.
            let (hit, mut events) = walked(&hashed, prims, &ray);
            let probes = events.iter().filter(|event| matches!(event, Visit::Probe { .. })).count();
            events.retain(|event| !matches!(event, Visit::Probe { .. }));
            let entered = events.iter().filter(|event| matches!(event, Visit::Enter { .. })).count();
            assert_eq!((hit, events), walked(&dense, prims, &ray), "{ray:?}");
            assert!(probes >= entered, "{probes} probes for {entered} cells");
        }
    }
}

#[test]
fn a_hashed_grid_takes_less_room_where_most_cells_are_empty() {
    let shapes = sparse();
    let prims = shapes.as_slice();
    let rule = GridRule { cells: [64; 3], ..GridRule::default() };
    let dense = Grid::build(&prims, &rule, &mut ()).unwrap();
    let hashed = HashedGrid::build(&prims, &rule, &mut ()).unwrap();
    assert_eq!(hashed.dense_bytes(), dense.bytes());
    assert!(10 * hashed.bytes() < dense.bytes(), "{} bytes against {}", hashed.bytes(), dense.bytes());
}

#[test]
fn nested_grids_of_one_level_are_a_uniform_grid() {
    let shapes = sparse();
    let prims = shapes.as_slice();
    let rule = GridRule::default();
    let uniform = Grid::build(&prims, &rule, &mut ()).unwrap();
    let nested =
        NestedGrid::build(&prims, &NestedRule { grid: rule, levels: 1, ..NestedRule::default() }, &mut ()).unwrap();
    assert_eq!(nested.lattice, uniform.lattice);
    assert!(nested.finer().is_empty());
    // Nested grids prune with a smaller margin: each cell refers to what the uniform one's does, or to less.
    for cell in (0..uniform.cell_count() as u32).map(CellId) {
        let (held, all) = (nested.cell_prims(cell), uniform.cell_prims(cell));
        assert!(held.iter().all(|prim| all.contains(prim)), "cell {cell}");
    }
    let steps = |(hit, events): (Option<Hit>, Vec<Visit>)| {
        let steps = events.into_iter().filter(|event| matches!(event, Visit::Step { .. } | Visit::End { .. }));
        (hit, steps.collect::<Vec<_>>())
    };
    for ray in rays() {
        assert_eq!(steps(walked(&nested, prims, &ray)), steps(walked(&uniform, prims, &ray)), "{ray:?}");
    }
}

/// So many cells are looked at while grids are built, and so many tests a ray then makes.
fn work(kind: &str, triangles: Vec<Triangle>) -> (u64, u64) {
    let shapes: Vec<Shape<'static>> = triangles.into_iter().map(Shape::Triangle).collect();
    let prims = Prims::Few(shapes);
    let mut looked_at = 0;
    let mut watch = Each(|event| looked_at += u64::from(matches!(event, Grow::Rasterise { .. })));
    let grid = Structure::build(&prims, &Rule::default_for(kind).unwrap(), &mut watch).unwrap();
    let (mut cost, mut hits) = (Cost::default(), 0);
    for i in 0..16 {
        let ray = Ray::new(Vec3::new(0.03 + 0.02 * i as f32, 0.3, 3.0), Vec3::new(0.1, 0.01, -1.0)).unwrap();
        let hit = grid.intersect(&prims, &ray, &mut cost);
        assert_eq!(hit, List.intersect(&prims, &ray, &mut ()), "{kind}: {ray:?}");
        hits += usize::from(hit.is_some());
    }
    assert!(hits > 4, "{kind}: {hits}");
    (looked_at, cost.prim_tests / 16)
}

#[test]
fn what_no_grid_separates_makes_no_large_one() {
    let slanted = Triangle { a: Vec3::ZERO, b: Vec3::new(1.0, 0.3, 0.2), c: Vec3::new(0.1, 1.0, 0.7) };
    let count = 20_000;
    // Long thin ones side by side along a diagonal: all their boxes overlap, and cells separate them.
    let hair = |i: usize| {
        let at = Vec3::new(i as f32 * 1e-4, 0.0, 0.0);
        Triangle { a: at, b: at + Vec3::new(-1.0, 1.0, 0.5), c: at + Vec3::new(-0.999, 1.001, 0.5) }
    };
    for kind in ["grid", "hashed-grid", "nested-grid"] {
        let (looked_at, _) = work(kind, vec![slanted; count]);
        assert!(looked_at <= 4 << 16, "{kind}: {looked_at}");
        let (_, tests) = work(kind, (0..count).map(hair).collect());
        assert!(tests < count as u64 / 4, "{kind}: {tests}");
    }
}
