//! The numbers that the lecture and its questions reckon with, in our own structures.

use glam::Vec3;
use raystep_accel::*;

fn ray(o: [f32; 2], d: [f32; 2]) -> Ray {
    Ray::new(Vec3::new(o[0], o[1], 0.0), Vec3::new(d[0], d[1], 0.0)).unwrap()
}

fn flat_box(min: [f32; 2], max: [f32; 2]) -> Aabb {
    Aabb::new(Vec3::new(min[0], min[1], -1.0), Vec3::new(max[0], max[1], 1.0))
}

/// The interval that is left, rounded to what a student writes down; nothing on a miss.
fn left(bounds: &Aabb, ray: &Ray) -> Option<(f32, f32)> {
    let part = slab(bounds, ray, Interval::ALL, Place::World, &mut ());
    let round = |t: f32| (t * 1000.0).round() / 1000.0;
    (!part.is_empty()).then(|| (round(part.near), round(part.far)))
}

#[test]
fn slabs_of_slides_12_to_15() {
    let bounds = flat_box([1.0, 2.0], [3.0, 6.0]);
    // The x plane that comes first is the upper one: without the swap a false miss.
    let mut events: Vec<Visit> = Vec::new();
    let towards = ray([5.0, 1.0], [-1.0, 1.0]);
    slab(&bounds, &towards, Interval::ALL, Place::World, &mut events);
    assert!(matches!(events[0], Visit::Divide { axis: Direction::Along(Axis::X), t1: 4.0, t2: 2.0, .. }));
    assert!(matches!(events[1], Visit::Order { axis: Direction::Along(Axis::X), t1: 2.0, t2: 4.0, swapped: true, .. }));
    assert_eq!(left(&bounds, &towards), Some((2.0, 4.0)));

    // Every pair of slabs may overlap, the box is missed all the same.
    assert_eq!(left(&flat_box([2.0, 7.0], [6.0, 9.0]), &ray([0.0, 0.0], [1.0, 1.0])), None);
    // The box lies behind the ray; from inside, the interval begins behind it.
    assert_eq!(left(&flat_box([-5.0, -1.0], [-2.0, 1.0]), &ray([0.0, 0.0], [1.0, 0.0])), Some((-5.0, -2.0)));
    assert_eq!(left(&flat_box([-2.0, -1.0], [3.0, 1.0]), &ray([0.0, 0.0], [1.0, 0.0])), Some((-2.0, 3.0)));
    // Parallel to the x slab: outside, inside, on its plane.
    for (x, met) in [(0.5, None), (2.0, Some((1.0, 5.0))), (3.0, Some((1.0, 5.0)))] {
        assert_eq!(left(&bounds, &ray([x, 1.0], [0.0, 1.0])), met);
        assert_eq!(left(&bounds, &ray([x, 1.0], [-0.0, 1.0])), met);
    }
    // A flat box, which a strict comparison would miss.
    assert_eq!(left(&flat_box([2.0, -1.0], [2.0, 1.0]), &ray([0.0, 0.0], [1.0, 0.0])), Some((2.0, 2.0)));
}

fn disc(x: f32, y: f32, radius: f32) -> Shape<'static> {
    Shape::Sphere(Sphere { center: Vec3::new(x, y, 0.0), radius })
}

/// A kd-tree with one cut, through the middle of its box across x.
fn halved(shapes: &[Shape<'static>]) -> Kd {
    let rule = KdRule { split: KdSplit::Middle, max_depth: 1, min_objects: 0, axes: Axes::Xy, ..KdRule::default() };
    Kd::build(&shapes, &rule, &mut ()).unwrap()
}

fn walk(shapes: &[Shape<'static>], ray: &Ray) -> (Option<Hit>, Vec<Visit>) {
    let mut events: Vec<Visit> = Vec::new();
    let hit = halved(shapes).intersect(&shapes, ray, &mut events);
    (hit, events)
}

/// How the root was split: near child, t of the plane, which children.
fn split(events: &[Visit]) -> (NodeId, f32, Side) {
    let told = events.iter().find_map(|event| match *event {
        Visit::Split { near, t, side, .. } => Some((near, t, side)),
        _ => None,
    });
    told.unwrap()
}

#[test]
fn near_is_where_the_ray_comes_from() {
    // The box runs from x = −2 to 10, the plane is x = 4.
    let shapes = [disc(-1.0, 0.0, 1.0), disc(9.0, 5.0, 1.0)];
    let (_, events) = walk(&shapes, &ray([12.0, 2.0], [-1.0, 0.0]));
    assert_eq!(split(&events), (NodeId(2), 8.0, Side::Both));
    let push = events.iter().find(|event| event.name() == "push").unwrap();
    assert!(matches!(push, Visit::Push { node: NodeId(1), t_near: 8.0, depth: 1, .. }));
}

#[test]
fn the_side_of_the_origin_may_be_passed_by() {
    // The box runs from x = 0 to 10, the plane x = 5 is crossed before the ray's range begins.
    let shapes = [disc(1.0, 0.0, 1.0), disc(9.0, 0.0, 1.0)];
    let ray = ray([3.0, 0.0], [1.0, 0.0]).within(3.0, 8.0).unwrap();
    let (hit, events) = walk(&shapes, &ray);
    assert_eq!(split(&events), (NodeId(1), 2.0, Side::Far));
    assert!(events.iter().all(|event| event.name() != "push"));
    assert_eq!(hit.map(|hit| hit.prim), Some(PrimId(1)));
}

/// The scene of "one shape on both sides": its box runs from x = 2 to 14, the plane is x = 8.
fn straddler() -> Vec<Shape<'static>> {
    let from_to = Wall { from: glam::Vec2::new(6.0, -1.5), to: glam::Vec2::new(10.0, 0.5), z: [-1.0, 1.0] };
    vec![Shape::Wall(from_to), disc(8.66, 0.12, 0.2), disc(2.5, 1.0, 0.5), disc(13.5, -0.8, 0.5)]
}

#[test]
fn a_hit_beyond_the_near_leaf_settles_nothing() {
    let (hit, events) = walk(&straddler(), &ray([0.0, 0.0], [1.0, 0.0]));
    let tested: Vec<(&str, Place)> = events
        .iter()
        .filter(|event| matches!(event, Visit::Test { .. } | Visit::Skip { .. } | Visit::Pop { .. }))
        .map(|event| (event.name(), event.place()))
        .collect();
    // In the near leaf the wall is hit at 9, behind the plane at 8: the far leaf must be opened.
    assert_eq!(tested[0], ("test.hit", Place::Prim(PrimId(0))));
    assert!(tested.contains(&("pop", Place::Node(NodeId(2)))));
    // There the wall is not tested again, and the disc is nearer.
    assert!(tested.contains(&("skip", Place::Prim(PrimId(0)))));
    assert_eq!(hit.map(|hit| (hit.prim, (hit.t * 10.0).round())), Some((PrimId(1), 85.0)));
}

#[test]
fn a_hit_before_the_far_interval_closes_it() {
    let shapes = [disc(5.0, 0.0, 1.0), disc(12.0, 0.0, 1.0), disc(3.5, 3.0, 0.5)];
    let (hit, events) = walk(&shapes, &ray([0.0, 0.0], [1.0, 0.0]));
    assert_eq!(hit.map(|hit| hit.prim), Some(PrimId(0)));
    assert!(events.iter().any(|event| matches!(event, Visit::Drop { node: NodeId(2), t_near: 8.0, .. })));
    assert!(matches!(events.last(), Some(Visit::End { why: Ending::Settled, .. })));
}

#[test]
fn a_ray_in_the_plane_is_on_both_sides() {
    let shapes = [disc(1.0, 0.0, 1.0), disc(9.0, 0.0, 1.0), disc(5.0, 4.0, 0.5)];
    for zero in [0.0, -0.0] {
        let (hit, events) = walk(&shapes, &ray([5.0, -3.0], [zero, 1.0]));
        let (_, t, side) = split(&events);
        assert!(t.is_nan() && side == Side::Both);
        assert_eq!(hit.map(|hit| (hit.prim, hit.t)), Some((PrimId(2), 6.5)));
    }
}

#[test]
fn three_times_the_cube_root_gives_27_cells_an_object() {
    let corners: Vec<Vec3> = (0..64).map(|i| Vec3::new((i % 4) as f32, (i / 4 % 4) as f32, (i / 16) as f32)).collect();
    let shapes: Vec<_> = corners.iter().map(|&center| Shape::Sphere(Sphere { center, radius: 0.4 })).collect();
    let rule = GridRule { resolution: Resolution::Cubic, factor: 3.0, ..GridRule::default() };
    let grid = Grid::build(&shapes.as_slice(), &rule, &mut ()).unwrap();
    assert_eq!((grid.lattice.resolution, grid.cell_count()), ([12; 3], 27 * 64));
}
