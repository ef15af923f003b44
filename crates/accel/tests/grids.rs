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
