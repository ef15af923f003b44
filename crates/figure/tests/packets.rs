//! Packets in figures: who takes part stands beside each node, nothing is cut off, and what is counted is what happened.

use glam::{Vec2, Vec3};
use raystep_accel::{
    Accel, Cost, Fill, Lanes, Observer, Packet, PacketStep, PacketVisit, Place, Prims, Ray, Rule, Shape, Sphere,
    Structure, Want,
};
use raystep_figure::*;

/// Six discs, a structure over them, and rays that walk through it together and one by one.
struct Played {
    prims: Prims,
    structure: Structure,
    nodes: Nodes,
    rays: Vec<Ray>,
    events: Vec<PacketVisit>,
    alone: Vec<Cost>,
}

impl Played {
    /// A fan of so many rays.
    fn new(kind: &str, many: usize) -> Played {
        let disc = |x, y, radius| Shape::Sphere(Sphere { center: Vec3::new(x, y, 0.0), radius });
        let discs = [disc(1.0, 3.0, 0.5), disc(2.0, 1.0, 0.4), disc(4.0, 3.5, 0.5), disc(5.0, 1.0, 0.5)];
        let more = [disc(7.0, 2.6, 0.5), disc(7.5, 0.5, 0.3)];
        let prims = Prims::Few(discs.into_iter().chain(more).collect());
        let mut rule = Rule::default_for(kind).unwrap();
        let smallest = if kind == "bvh" { "leaf_size" } else { "min_objects" };
        rule.set(smallest, "1").unwrap();
        let structure = Structure::build(&prims, &rule.flat(), &mut ()).unwrap();
        let ray = |lane: usize| {
            let share = lane as f32 / (many - 1) as f32;
            Ray::new(Vec3::new(-1.0, 1.8, 0.0), Vec3::new(1.0, 0.25 - 0.4 * share, 0.0)).unwrap()
        };
        let rays: Vec<Ray> = (0..many).map(ray).collect();
        let mut events = Vec::new();
        structure.walk_packet(&prims, Packet::of(&rays).unwrap(), Want::Nearest, &mut events).unwrap();
        let alone = rays.iter().map(|ray| {
            let mut cost = Cost::default();
            structure.intersect(&prims, ray, &mut cost);
            cost
        });
        let (nodes, alone) = (Nodes::of(&structure), alone.collect());
        Played { prims, structure, nodes, rays, events, alone }
    }

    fn walk(&self) -> PacketWalk<'_> {
        let Played { prims, structure, nodes, rays, events, alone } = self;
        PacketWalk { structure, prims, nodes, rays, events, lost: 0, alone, flat: true }
    }
}

const SIZE: Vec2 = Vec2::new(520.0, 330.0);

fn texts(figure: &Figure) -> Vec<String> {
    let text = |mark: &Mark| match &mark.ink {
        Ink::Text { text, .. } => Some(text.clone()),
        _ => None,
    };
    figure.marks.iter().filter_map(text).collect()
}

#[test]
fn every_pane_shows_every_step_and_nothing_lies_outside() {
    for (kind, many) in [("kd", 2), ("kd", 4), ("bsp", 4), ("bvh", 4), ("kd", 8), ("bvh", 16)] {
        let played = Played::new(kind, many);
        let walk = played.walk();
        let mut at = walk.start();
        for step in 0..=walk.len() {
            walk.advance(&mut at, step);
            for pane in Pane::ALL {
                let what = format!("{kind}, {many} rays, {pane:?} at step {step}");
                let drawn = walk.draw(&at, pane, &Ask::new(SIZE, Look::WINDOW));
                assert_eq!(drawn.is_some(), walk.panes().contains(&pane), "{what}");
                for mark in drawn.iter().flat_map(|figure| &figure.marks) {
                    let points = match &mark.ink {
                        Ink::Line { points } => points.clone(),
                        Ink::Rect { min, max, .. } => vec![*min, *max],
                        Ink::Circle { center, .. } => vec![*center],
                        Ink::Text { at, text, size, face, anchor, .. } => {
                            let width = text_width(text, *face, *size);
                            let left = match anchor {
                                Anchor::Start => at.x,
                                Anchor::Middle => at.x - width * 0.5,
                                Anchor::End => at.x - width,
                            };
                            vec![Vec2::new(left, at.y), Vec2::new(left + width, at.y)]
                        }
                        _ => continue,
                    };
                    let inside =
                        |p: &Vec2| (-1.0..=SIZE.x + 1.0).contains(&p.x) && (-1.0..=SIZE.y + 1.0).contains(&p.y);
                    assert!(points.iter().all(inside), "{what}: {mark:?}");
                }
            }
            assert!(walk.space(&at, Depth::Path).is_some());
        }
    }
}

#[test]
fn a_moment_is_what_the_events_say() {
    for (kind, many) in [("kd", 4), ("bsp", 5), ("bvh", 16)] {
        let played = Played::new(kind, many);
        let walk = played.walk();
        let (mut moment, mut fill, mut tests) = (PacketMoment::start(), Fill::default(), 0);
        for (index, event) in played.events.iter().enumerate() {
            moment.advance(&walk, index + 1);
            fill.on(*event);
            if let PacketStep::Lane(raystep_accel::Visit::Test { .. }) = event.step {
                tests += 1;
            }
            assert_eq!((moment.fill, moment.tested.len()), (fill, tests), "{kind} at {index}");
            let lanes: u64 = moment.entered.iter().map(|(_, lanes)| u64::from(lanes.count())).sum();
            assert_eq!((moment.entered.len() as u64, lanes), (fill.visits, fill.lane_visits));
            // Of everybody who takes part it is known where.
            for (node, lanes) in moment.here.iter().chain(&moment.stack).copied() {
                assert!(lanes.iter().all(|lane| moment.part(node, lane).is_some()), "{kind} at {index}: {node}");
            }
        }
        assert!(moment.over && moment.stack.is_empty());
        for (lane, ray) in played.rays.iter().enumerate() {
            let hit = played.structure.intersect(&played.prims, ray, &mut ());
            assert_eq!(moment.best[lane].map(|hit| (hit.t, hit.prim)), hit.map(|hit| (hit.t, hit.prim)), "{kind}");
        }
    }
}

#[test]
fn who_takes_part_stands_beside_each_node() {
    let played = Played::new("kd", 4);
    let walk = played.walk();
    let parts = played.events.iter().position(|event| event.name() == "packet.pop").unwrap();
    let mut at = walk.start();
    walk.advance(&mut at, parts + 1);
    let mut told = String::new();
    for pane in [Pane::Ruler, Pane::Stack, Pane::Work] {
        let figure = walk.draw(&at, pane, &Ask::new(SIZE, Look::WINDOW)).unwrap();
        told += &format!("{pane:?}: {:?}\n", texts(&figure));
    }
    let tree = walk.draw(&at, Pane::Tree, &Ask::new(SIZE, Look::WINDOW)).unwrap();
    let mut cells = std::collections::BTreeMap::new();
    let small = |mark: &&Mark| matches!(mark.ink, Ink::Rect { min, max, .. } if max.x - min.x < 12.0);
    for mark in tree.marks.iter().filter(small) {
        if let (Some(Place::Node(node)), Role::Lane | Role::Edge) = (mark.place, mark.role) {
            let filled: &mut String = cells.entry(node).or_default();
            filled.push(if mark.role == Role::Lane { '1' } else { '0' });
        }
    }
    told += &format!("Tree: {cells:?}\n");
    let space = walk.space(&at, Depth::Path).unwrap();
    let labels = space.marks.iter().filter_map(|mark| match &mark.form {
        Form::Label { text, .. } => Some(text.clone()),
        _ => None,
    });
    told += &format!("Space: {:?}\n", labels.collect::<Vec<_>>());
    insta::assert_snapshot!(told);
}

#[test]
fn what_happens_is_said_in_words() {
    let played = Played::new("kd", 4);
    let mut told = String::new();
    for event in played.events.iter().filter(|event| !matches!(event.step, PacketStep::Lane(_))) {
        told += &format!("{}\n", sentence(event, VolumeName::BOX));
    }
    insta::assert_snapshot!(told);
    assert_eq!(value(&raystep_accel::Value::Lanes(Lanes::one(4, 1))), "□■□□");
}
