//! What the pictures of a walk contain, as text.

use std::fmt::Write;
use std::sync::Arc;

use glam::{Vec2, Vec3};
use raystep_accel::{
    Accel, Axes, Instances, KdLayout, KdRule, Measure, Mesh, Model, NodeId, Place, Prims, Ray, Rule, Shape, Sphere,
    Structure, Transform, Visit,
};
use raystep_figure::{
    Camera, Depth, Figure, Film, Form, Ink, Moment, Nodes, Reel, Role, Scenery, Space, Theme, Walk, ghost, labels,
    shaded, space, space_to, stage,
};

/// Discs in the four quarters of a square, two in each.
fn discs() -> Prims {
    let places = [[0.5, 0.5], [1.5, 1.2], [3.2, 0.6], [4.4, 1.4], [0.8, 3.3], [1.7, 4.2], [3.4, 3.1], [4.5, 4.4]];
    let disc = |[x, y]: [f32; 2]| Shape::Sphere(Sphere { center: Vec3::new(x, y, 0.0), radius: 0.4 });
    Prims::Few(places.map(disc).to_vec())
}

fn kd() -> Rule {
    let mut rule = KdRule { axes: Axes::Xy, measure: Measure::Perimeter, ..KdRule::default() };
    rule.min_objects = 2;
    Rule::Kd(rule)
}

struct Stand {
    prims: Prims,
    structure: Structure,
    nodes: Nodes,
    ray: Ray,
    events: Vec<Visit>,
}

impl Stand {
    fn new(rule: &Rule) -> Stand {
        let prims = discs();
        let structure = Structure::build(&prims, rule, &mut ()).expect("nobody cancels");
        let ray = Ray::new(Vec3::new(-1.0, 0.2, 0.0), Vec3::new(1.0, 0.7, 0.0)).expect("a ray");
        let mut events = Vec::new();
        structure.intersect(&prims, &ray, &mut events);
        let nodes = Nodes::of(&structure);
        Stand { prims, structure, nodes, ray, events }
    }

    fn walk(&self) -> Walk<'_> {
        Walk {
            structure: &self.structure,
            prims: &self.prims,
            nodes: &self.nodes,
            ray: self.ray,
            events: &self.events,
            lost: 0,
            flat: true,
            layout: KdLayout::Compact,
        }
    }

    /// The step of the `n`th event of a name, counted from 1.
    fn step(&self, name: &str, n: usize) -> usize {
        let found = self.events.iter().enumerate().filter(|(_, event)| event.name() == name).nth(n - 1);
        found.expect("the event happens").0 + 1
    }
}

fn told(space: &Space) -> String {
    let mut out = String::new();
    for mark in &space.marks {
        let place = mark.place.map_or_else(String::new, |place| place.to_string());
        let form = match &mark.form {
            Form::Box(b) => format!("box {:.2},{:.2} – {:.2},{:.2}", b.min.x, b.min.y, b.max.x, b.max.y),
            Form::Sphere(s) => format!("circle {:.2},{:.2}: {:.2}", s.center.x, s.center.y, s.radius),
            Form::Body(edges) => format!("body of {} edges", edges.len()),
            Form::Polygon(corners) => format!("polygon of {} corners", corners.len()),
            Form::Sheet(b) => format!("sheet {:.2},{:.2} – {:.2},{:.2}", b.min.x, b.min.y, b.max.x, b.max.y),
            Form::Segment(a, b) => format!("segment {:.2},{:.2} – {:.2},{:.2}", a.x, a.y, b.x, b.y),
            Form::Arrow(a, b) => format!("arrow {:.2},{:.2} – {:.2},{:.2}", a.x, a.y, b.x, b.y),
            Form::Point(a) => format!("point {:.2},{:.2}", a.x, a.y),
            Form::Prim(_) => "shape".to_owned(),
            Form::Axes(b) => format!("axes {:.2},{:.2} – {:.2},{:.2}", b.min.x, b.min.y, b.max.x, b.max.y),
            Form::Number { text, .. } => format!("number {text}"),
            Form::Label { text, .. } => format!("label “{text}”"),
        };
        let _ = writeln!(out, "{:9} {form:38} {place}", format!("{:?}", mark.role));
    }
    out
}

#[test]
fn a_kd_walk_at_its_second_plane() {
    let stand = Stand::new(&kd());
    let mut moment = Moment::at(&stand.walk(), stand.step("plane", 2));
    moment.guesses = vec![(Place::Node(NodeId(3)), "lower".to_owned())];
    insta::assert_snapshot!(told(&space(&stand.walk(), &moment)));
}

#[test]
fn a_kd_walk_at_its_end() {
    let stand = Stand::new(&kd());
    let moment = Moment::at(&stand.walk(), stand.events.len());
    insta::assert_snapshot!(told(&space(&stand.walk(), &moment)));
}

#[test]
fn volumes_are_drawn_as_what_they_are() {
    for volume in ["sphere", "obb", "kdop18", "hull"] {
        let mut rule = Rule::default_for("bvh").expect("a kind");
        rule.set("volume", volume).expect("a volume");
        let stand = Stand::new(&rule.flat());
        let moment = Moment::at(&stand.walk(), stand.step("volume.hit", 2));
        insta::assert_snapshot!(volume, told(&space(&stand.walk(), &moment)));
    }
}

#[test]
fn edges_of_a_body_are_drawn_once() {
    let mut rule = Rule::default_for("bvh").expect("a kind");
    rule.set("volume", "obb").expect("a volume");
    let stand = Stand::new(&rule);
    let walk = Walk { flat: false, ..stand.walk() };
    let space = space_to(&walk, &Moment::start(&walk), Depth::Down(9));
    let edges: Vec<usize> = space
        .marks
        .iter()
        .filter_map(|mark| match &mark.form {
            Form::Body(edges) => Some(edges.len()),
            _ => None,
        })
        .collect();
    assert!(edges.len() > 4 && edges.iter().all(|&count| count == 12), "{edges:?}");
}

#[test]
fn what_happens_in_an_instance_is_drawn_where_it_stands() {
    let [a, b, c] = [Vec3::ZERO, Vec3::X, Vec3::Y];
    let mesh = Mesh { corners: vec![a, b, c], triangles: vec![[0, 1, 2]] };
    let rule = Rule::default_for("bvh").expect("a kind");
    let model = Arc::new(Model::build(mesh, &rule, &mut ()).expect("nobody cancels"));
    let shift = Vec3::new(10.0, 20.0, 30.0);
    let instances = Instances::new(vec![model], &[(0, Transform::moved(shift))]).expect("it can be undone");
    let prims = Prims::Instances(instances);
    let structure = Structure::build(&prims, &rule, &mut ()).expect("nobody cancels");
    let ray = Ray::new(Vec3::new(10.2, 20.2, 35.0), Vec3::NEG_Z).expect("a ray");
    let mut events = Vec::new();
    structure.intersect(&prims, &ray, &mut events);
    let nodes = Nodes::of(&structure);
    let walk = Walk {
        structure: &structure,
        prims: &prims,
        nodes: &nodes,
        ray,
        events: &events,
        lost: 0,
        flat: false,
        layout: KdLayout::Compact,
    };
    let moved = [a, b, c].map(|corner| corner + shift).to_vec();
    let drawn = |step: usize, role: Role| {
        let space = space(&walk, &Moment::at(&walk, step));
        space.marks.iter().any(|mark| mark.role == role && mark.form == Form::Polygon(moved.clone()))
    };
    let step = |name: &str| events.iter().position(|event| event.name() == name).expect("it happens") + 1;
    assert!(!drawn(step("local"), Role::Hit));
    assert!(drawn(step("test.hit"), Role::Hit), "{events:?}");
    assert!(drawn(step("better"), Role::Best));
}

#[test]
fn a_moment_is_the_same_from_the_start_and_from_a_film() {
    for kind in ["list", "slab", "grid", "kd", "bvh"] {
        let stand = Stand::new(&Rule::default_for(kind).expect("a kind"));
        let walk = stand.walk();
        let reel = Reel::new(walk);
        let film = Film::new(&reel);
        for step in 0..=stand.events.len() {
            assert_eq!(*film.at(&reel, step).state::<Moment>(), Moment::at(&walk, step), "{kind} at {step}");
        }
        assert_eq!(Moment::at(&walk, usize::MAX).step, stand.events.len());
    }
}

#[test]
fn labels_stay_in_the_picture_and_off_each_other() {
    for rule in [kd(), Rule::default_for("grid").expect("a kind"), Rule::default_for("bvh").expect("a kind")] {
        let stand = Stand::new(&rule);
        let walk = stand.walk();
        for step in 0..=stand.events.len() {
            let space = space(&walk, &Moment::at(&walk, step));
            for size in [Vec2::new(760.0, 560.0), Vec2::new(420.0, 380.0)] {
                let camera = Camera::frame(&space.bounds, size.x / size.y, true);
                let figure = labels(&space, &stand.prims, &camera, size);
                check_labels(&figure, size, step);
            }
        }
    }
}

fn check_labels(figure: &Figure, page: Vec2, step: usize) {
    let mut boxes: Vec<(Vec2, Vec2, &str)> = Vec::new();
    for mark in &figure.marks {
        let Ink::Text { at, text, size, face, boxed, .. } = &mark.ink else { continue };
        let (aside, high) = if *boxed { (0.5, 0.8) } else { (0.0, 0.5) };
        let half = Vec2::new(raystep_figure::text_width(text, *face, *size) * 0.5 + size * aside, size * high);
        let (min, max) = (*at - half, *at + half);
        assert!(min.cmpge(Vec2::ZERO).all() && max.cmple(page).all(), "step {step}: “{text}” reaches out");
        for (other_min, other_max, other) in &boxes {
            let apart = max.cmple(*other_min).any() || min.cmpge(*other_max).any();
            assert!(apart, "step {step}: “{text}” covers “{other}”");
        }
        boxes.push((min, max, text));
    }
}

#[test]
fn a_shaded_picture_has_the_same_bytes_every_time() {
    let stand = Stand::new(&Rule::default_for("bvh").expect("a kind"));
    let walk = stand.walk();
    let space = space(&walk, &Moment::at(&walk, 20));
    let camera = Camera::frame(&space.bounds, 1.5, false);
    let image =
        || shaded(&stand.structure, &stand.prims, &camera, 60, 40, &Theme::PRINT, &|| true).expect("nobody gives up");
    let first = image();
    assert_eq!(first, image());
    assert!(first.image.rgba.chunks(4).any(|pixel| pixel[3] == 255) && first.image.rgba[3] == 0);
    let figure = stage(&space, &stand.prims, &camera, Vec2::new(60.0, 40.0), Scenery::Shaded(&first));
    assert!(matches!(figure.marks[0].ink, Ink::Image { .. }));
}

#[test]
fn the_step_before_leaves_a_ghost() {
    let stand = Stand::new(&kd());
    let walk = stand.walk();
    let pop = stand.step("pop", 1);
    let (before, now) = (Moment::at(&walk, pop - 1), Moment::at(&walk, pop));
    let left = before.here.expect("a node");
    let mut drawn = space(&walk, &now);
    ghost(&walk, &before, &now, &mut drawn);
    assert_eq!((drawn.marks[0].role, drawn.marks[0].place), (Role::Ghost, Some(left)), "below everything else");
    // Who stands where he stood leaves none.
    let mut same = space(&walk, &now);
    ghost(&walk, &now, &now, &mut same);
    assert!(same.marks.iter().all(|mark| mark.role != Role::Ghost));
}
