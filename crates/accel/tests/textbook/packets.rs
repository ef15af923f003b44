//! Packets through small scenes: what each lane finds, how full a packet is, and whole walks as text.

use crate::spell::line;
use glam::Vec3;
use raystep_accel::*;

fn disc(x: f32, y: f32, radius: f32) -> Shape<'static> {
    Shape::Sphere(Sphere { center: Vec3::new(x, y, 0.0), radius })
}

fn ray(from: [f32; 2], d: [f32; 2]) -> Ray {
    Ray::new(Vec3::new(from[0], from[1], 0.0), Vec3::new(d[0], d[1], 0.0)).unwrap()
}

/// One disc left of x = 4, two right of it.
fn scene() -> Vec<Shape<'static>> {
    vec![disc(1.0, 1.0, 0.5), disc(6.0, 1.0, 0.5), disc(7.5, 3.0, 0.5)]
}

/// Four rays from below: the first rises left of the plane, three rise right of it.
fn one_left_three_right() -> Vec<Ray> {
    [1.0, 5.8, 6.0, 7.5].map(|x| ray([x, -1.0], [0.0, 1.0])).to_vec()
}

fn built(kind: &str, settings: &[(&str, &str)]) -> Structure {
    let mut rule = Rule::default_for(kind).unwrap().flat();
    for (key, value) in settings {
        rule.set(key, value).unwrap();
    }
    Structure::build(&scene().as_slice(), &rule, &mut ()).unwrap()
}

fn walked(structure: &Structure, rays: &[Ray], watch: &mut impl Observer<PacketVisit>) -> Found {
    let (prims, packet) = (scene(), Packet::all(rays, Width::Four).next().unwrap());
    structure.walk_packet(&prims.as_slice(), packet, Want::Nearest, watch).unwrap()
}

/// One line an event: its lanes, its name, its fields. The arithmetic of slabs is left out.
fn story(events: &[PacketVisit]) -> String {
    let is_slab = |step| matches!(step, PacketStep::Lane(visit) if visit.grain() == Grain::Arithmetic);
    let told = events.iter().filter(|event| !is_slab(event.step));
    told.map(|event| format!("{} {}\n", event.lanes, line(event.name(), event.fields(), |field| event.field(field))))
        .collect()
}

#[test]
fn one_lane_goes_left_and_three_go_right_in_a_kd_tree() {
    let tree = built("kd", &[("split", "middle"), ("max_depth", "1"), ("min_objects", "1")]);
    let mut events = Vec::new();
    walked(&tree, &one_left_three_right(), &mut events);
    insta::assert_snapshot!(story(&events));
}

#[test]
fn one_lane_goes_left_and_three_go_right_in_a_hierarchy_of_boxes() {
    let tree = built("bvh", &[("split", "middle"), ("leaf_size", "2")]);
    let mut events = Vec::new();
    walked(&tree, &one_left_three_right(), &mut events);
    insta::assert_snapshot!(story(&events));
}

#[test]
fn a_ray_against_the_others_visits_its_far_child_first() {
    let tree = built("kd", &[("split", "middle"), ("max_depth", "1"), ("min_objects", "1")]);
    let rays = [ray([-1.0, 1.0], [1.0, 0.0]), ray([-1.0, 1.1], [1.0, 0.0]), ray([9.0, 1.0], [-1.0, 0.0])];
    let mut events = Vec::new();
    let found = walked(&tree, &rays, &mut events);
    assert_eq!(found.map(|hit| hit.map(|hit| hit.prim.0))[..4], [Some(0), Some(0), Some(1), None]);
    insta::assert_snapshot!(story(&events));
}

#[test]
fn a_packet_that_divides_is_a_quarter_and_three_quarters_full() {
    let tree = built("kd", &[("split", "middle"), ("max_depth", "1"), ("min_objects", "1")]);
    let mut fill = Fill::default();
    walked(&tree, &one_left_three_right(), &mut fill);
    // The root by all four, one leaf by one lane, the other by three.
    assert_eq!(fill, Fill { visits: 3, lane_visits: 4 + 1 + 3, lanes: 12 });
    assert_eq!(fill.share(), Some(2.0 / 3.0));
    assert_eq!(Fill::default().share(), None);
}

#[test]
fn a_packet_of_one_ray_visits_what_the_ray_visits_alone() {
    for (kind, settings) in [
        ("kd", [("min_objects", "1"), ("max_depth", "8")]),
        ("bsp", [("min_objects", "1"), ("max_depth", "8")]),
        ("bvh", [("leaf_size", "1"), ("bins", "8")]),
    ] {
        let tree = built(kind, &settings);
        for one in one_left_three_right() {
            let (mut alone, mut together) = (Cost::default(), Fill::default());
            tree.intersect(&scene().as_slice(), &one, &mut alone);
            walked(&tree, &[one], &mut together);
            assert_eq!(together.visits, alone.node_visits);
            assert_eq!(together.lane_visits, alone.node_visits);
        }
    }
}

#[test]
fn lanes_are_written_in_their_places() {
    assert_eq!(Lanes::of(4, |lane| lane % 3 == 0).to_string(), "0--3");
    assert_eq!(Lanes::of(16, |_| true).to_string(), "0123456789abcdef");
    assert_eq!(Lanes::none(8).to_string(), "--------");
}
