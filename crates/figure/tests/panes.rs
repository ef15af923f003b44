//! The panes on a small flat scene: what they draw, and that nothing is cut off at any step.

use glam::{Vec2, Vec3};
use raystep_accel::{Accel, Change, Grow, KdLayout, PrimId, Prims, Ray, Rule, Shape, Sphere, Structure, Visit};
use raystep_figure::*;

/// Six discs, a structure over them and a walk through it.
struct Played {
    prims: Prims,
    structure: Structure,
    nodes: Nodes,
    ray: Ray,
    events: Vec<Visit>,
    grown: Vec<Grow>,
}

impl Played {
    fn new(kind: &str, settings: &[(&str, &str)]) -> Played {
        let disc = |x, y, radius| Shape::Sphere(Sphere { center: Vec3::new(x, y, 0.0), radius });
        let discs = [disc(1.0, 3.0, 0.5), disc(2.0, 1.0, 0.4), disc(4.0, 3.5, 0.5), disc(5.0, 1.0, 0.5)];
        let more = [disc(7.0, 2.6, 0.5), disc(7.5, 0.5, 0.3)];
        let prims = Prims::Few(discs.into_iter().chain(more).collect());
        let mut rule = Rule::default_for(kind).unwrap();
        for (key, value) in settings {
            rule.set(key, value).unwrap();
        }
        let mut grown = Vec::new();
        let structure = Structure::build(&prims, &rule.flat(), &mut grown).unwrap();
        let ray = Ray::new(Vec3::new(-1.0, 1.8, 0.0), Vec3::new(1.0, 0.1, 0.0)).unwrap();
        let mut events = Vec::new();
        structure.intersect(&prims, &ray, &mut events);
        let nodes = Nodes::of(&structure);
        Played { prims, structure, nodes, ray, events, grown }
    }

    fn walk(&self) -> Walk<'_> {
        let Played { structure, prims, nodes, ray, events, .. } = self;
        Walk { structure, prims, nodes, ray: *ray, events, lost: 0, flat: true, layout: KdLayout::Compact }
    }

    /// The step of the `nth` event of this name.
    fn step(&self, name: &str, nth: usize) -> usize {
        let mut named = self.events.iter().enumerate().filter(|(_, event)| event.name() == name);
        named.nth(nth).map_or_else(|| panic!("no {name}"), |(index, _)| index + 1)
    }
}

/// Marks as text, one a line, points rounded.
fn told(figure: &Figure) -> String {
    let point = |p: Vec2| format!("{:.0},{:.0}", p.x, p.y);
    let line = |mark: &Mark| {
        let ink = match &mark.ink {
            Ink::Line { points } => {
                format!("line {}", points.iter().map(|p| point(*p)).collect::<Vec<_>>().join(" "))
            }
            Ink::Area { points } => format!("area of {}", points.len()),
            Ink::Rect { min, max, .. } => format!("rect {} {}", point(*min), point(*max)),
            Ink::Circle { center, radius } => format!("circle {} r{radius:.0}", point(*center)),
            Ink::Arrowhead { tip, .. } => format!("arrow {}", point(*tip)),
            Ink::Text { at, text, .. } => format!("{text:?} {}", point(*at)),
            other => format!("{other:?}"),
        };
        let place = mark.place.map_or(String::new(), |place| format!("   ({place})"));
        format!("{:<8} {ink}{place}", format!("{:?}", mark.role))
    };
    figure.marks.iter().map(line).collect::<Vec<_>>().join("\n")
}

fn check(name: &str, figure: &Figure) {
    insta::assert_snapshot!(name, told(figure));
}

const LOOK: Look = Look::WINDOW;

#[test]
fn a_plane_cuts_the_ray() {
    let played = Played::new("kd", &[("min_objects", "1")]);
    let walk = played.walk();
    let moment = Moment::at(&walk, played.step("plane", 1));
    check("kd_ruler", &ruler(&walk, &moment, false, Vec2::new(790.0, 118.0), &LOOK));
    check("kd_ruler_line", &ruler_line(&walk, &moment, false, Vec2::new(790.0, 90.0), &LOOK));
    check("kd_tree", &tree(&walk, &moment, &TreeView::default(), Vec2::new(790.0, 160.0), &LOOK));
    check("kd_stack", &stack(&walk, &moment, Vec2::new(400.0, 160.0), &LOOK));
    check("kd_bin", &bin(&moment, Vec2::new(400.0, 160.0), &LOOK));
    check("kd_work", &work(&walk, &moment, None, Vec2::new(400.0, 160.0), &LOOK));
    check("kd_bytes", &bytes(&walk, &moment, false, Vec2::new(790.0, 220.0), &LOOK));
    check("kd_timeline", &timeline(&walk, moment.step, &Ask::new(Vec2::new(1000.0, 80.0), LOOK)));
}

#[test]
fn before_a_question_the_timeline_tells_nothing_behind_it() {
    let played = Played::new("kd", &[("min_objects", "1")]);
    let walk = played.walk();
    let (size, steps) = (Vec2::new(1000.0, 80.0), walk.events.len());
    let track = Track::new(steps, size, &LOOK);
    let behind = |step: usize, told: usize| {
        let figure = timeline(&walk, step, &Ask { told, ..Ask::new(size, LOOK) });
        let signs = figure.marks.iter().filter(|mark| mark.place.is_some());
        let at = signs.filter_map(|mark| match &mark.ink {
            Ink::Text { at, .. } => Some(at.x),
            _ => None,
        });
        at.filter(|x| *x > track.x(told.min(steps)) + 1.0).count()
    };
    let told = steps / 2;
    assert!(behind(2, usize::MAX) == 0 && behind(2, told) == 0, "nothing behind what is told");
    let all = |told| timeline(&walk, 2, &Ask { told, ..Ask::new(size, LOOK) }).marks.len();
    assert!(all(told) < all(usize::MAX) && all(2) < all(told), "what comes before it is told");
}

#[test]
fn a_look_up_shows_its_slot_and_hides_the_others_while_a_question_is_open() {
    let played = Played::new("hashed-grid", &[]);
    let walk = played.walk();
    let moment = Moment::at(&walk, played.step("probe.found", 0));
    let pane = |hide| bytes(&walk, &moment, hide, Vec2::new(790.0, 200.0), &LOOK);
    check("hash_table", &pane(false));
    // What was not looked at yet is no answer to what is in the next slot.
    let unknown = |hide| told(&pane(hide)).matches("\"?\"").count();
    assert_eq!([unknown(false), unknown(true)], [0, 3]);
}

#[test]
fn a_slab_narrows_the_ray() {
    let played = Played::new("bvh", &[]);
    let walk = played.walk();
    let moment = Moment::at(&walk, played.step("slab.narrow", 1));
    check("slab_table", &slabs(&walk, &moment, false, Vec2::new(440.0, 120.0), &LOOK));
    check("slab_ruler", &ruler(&walk, &moment, false, Vec2::new(790.0, 118.0), &LOOK));
}

#[test]
fn the_step_to_the_next_cell_names_its_axis_only_when_taken() {
    let played = Played::new("grid", &[]);
    let walk = played.walk();
    let step = played.step("step", 1);
    let pane = |step, hide| cells(&walk, &Moment::at(&walk, step), hide, Vec2::new(300.0, 150.0), &LOOK);
    check("cells_stepped", &pane(step, false));
    for figure in [pane(step - 1, false), pane(step, true)] {
        assert!(!told(&figure).contains("smallest"));
    }
    // The numbers stand there all the same.
    let numbers = |figure: &Figure| told(figure).lines().filter(|line| line.contains("\"x\"")).count();
    assert_eq!(numbers(&pane(step, true)), numbers(&pane(step, false)));
}

#[test]
fn the_line_of_the_event_is_marked_with_its_numbers() {
    let played = Played::new("kd", &[]);
    let values = Some("({{plane}} − {{o}}) / {{d}} = {{t}}");
    let lines: Vec<ListingLine<'_>> = (0..20)
        .map(|index| ListingLine {
            instead: None,
            indent: index % 3,
            text: "a line",
            current: index == 12,
            values: if index == 12 { values } else { None },
        })
        .collect();
    let event = played.events[played.step("plane", 0) - 1];
    check("listing", &listing("Walk", &lines, Some(&event), true, Vec2::new(300.0, 170.0), &LOOK));
}

#[test]
fn a_build_shows_what_it_weighs() {
    let played = Played::new("kd", &[("min_objects", "1")]);
    let step = played.grown.iter().position(|event| matches!(event, Grow::Split { .. })).unwrap() + 1;
    let moment = GrowMoment::at(&played.grown, step);
    check("build_costs", &costs(&moment, VolumeName::of(&played.structure), false, Vec2::new(440.0, 150.0), &LOOK));
    check("build_tree", &tree_of_build(&moment, &TreeView::default(), Vec2::new(400.0, 150.0), &LOOK));
}

#[test]
fn planes_of_all_directions_are_candidates_side_by_side() {
    let played = Played::new("bsp", &[("min_objects", "1"), ("samples", "2")]);
    let step = played.grown.iter().position(|event| matches!(event, Grow::Split { .. })).unwrap() + 1;
    let moment = GrowMoment::at(&played.grown, step);
    let volume = VolumeName::of(&played.structure);
    check("build_candidates", &costs(&moment, volume, false, Vec2::new(440.0, 150.0), &LOOK));
}

#[test]
fn the_last_moment_of_a_build_is_the_structure() {
    for kind in ["kd", "bvh"] {
        let played = Played::new(kind, &[]);
        let moment = GrowMoment::at(&played.grown, played.grown.len());
        assert_eq!(moment.nodes.len(), played.structure.node_count());
        for (id, node) in &moment.nodes {
            assert_eq!(node.children, played.structure.children(*id));
            assert_eq!(node.settled, played.structure.leaf_prims(*id));
        }
    }
}

#[test]
fn the_moments_of_a_changed_octree_are_its_nodes_and_those_it_touched() {
    let mut played = Played::new("octree", &[("min_objects", "1"), ("max_depth", "4")]);
    let Structure::Octree(tree) = &mut played.structure else { panic!("an octree") };
    let mut changes = Vec::new();
    for change in [Change::Delete(PrimId(4)), Change::Delete(PrimId(0)), Change::Insert(PrimId(0))] {
        let from = played.grown.len();
        tree.change(&played.prims, change, &mut played.grown).unwrap();
        changes.push(Changed { change, from, done: true, anew: Some(("kd-tree".to_owned(), 11)) });
    }
    let Played { prims, structure, grown, .. } = &played;
    let nodes = Nodes::of(structure);
    let lost = std::collections::BTreeMap::new();
    let (events, changes) = (grown.as_slice(), changes.as_slice());
    let build = Build { structure, nodes: &nodes, prims, events, lost: &lost, instead: None, changes, flat: true };
    let moment = GrowMoment::at(grown, grown.len());
    let Some(&Grow::End { nodes: count, references, .. }) = grown.last() else { panic!("a change ends") };
    assert_eq!((moment.nodes.len() as u32, moment.tally.stored as u32), (count, references));
    for (id, node) in &moment.nodes {
        assert_eq!(node.children, structure.children(*id), "node {id}");
        assert_eq!(node.settled, structure.leaf_prims(*id), "node {id}");
        let is_leaf = node.children.is_empty();
        assert!(!is_leaf || node.prims as usize == node.settled.len(), "node {id}: {} primitives", node.prims);
    }
    check("change_work", &work_of_build(&build, &moment, Vec2::new(400.0, 300.0), &LOOK));
}

#[test]
fn what_changed_is_what_is_not_as_before() {
    let played = Played::new("kd", &[("min_objects", "1")]);
    let walk = played.walk();
    let size = Vec2::new(400.0, 160.0);
    let pane = |before: usize, now: usize| {
        changed(&walk, &Moment::at(&walk, before), &Moment::at(&walk, now), false, size, &LOOK)
    };
    let push = played.step("push", 0);
    check("changed_push", &pane(push - 1, push));
    let better = played.step("better", 0);
    check("changed_better", &pane(better - 1, better));
    check("changed_nothing", &pane(0, 0));
    // The same moment twice has no rows.
    assert!(!told(&pane(better, better)).contains('→'));

    let grid = Played::new("grid", &[]);
    let walk = grid.walk();
    let step = grid.step("step", 1);
    let pane = changed(&walk, &Moment::at(&walk, step - 1), &Moment::at(&walk, step), false, size, &LOOK);
    check("changed_step", &pane);

    let weigh = played.grown.iter().position(|event| matches!(event, Grow::Weigh { .. })).unwrap() + 2;
    let [before, now] = [weigh - 1, weigh].map(|step| GrowMoment::at(&played.grown, step));
    let (structure, prims, lost) = (&played.structure, &played.prims, std::collections::BTreeMap::new());
    let nodes = Nodes::of(structure);
    let events = played.grown.as_slice();
    let build = Build { structure, nodes: &nodes, prims, events, lost: &lost, instead: None, changes: &[], flat: true };
    check("changed_weigh", &changed_of_build(&build, &before, &now, false, size, &LOOK));
}

#[test]
fn a_line_of_the_listing_is_found_where_it_is_drawn() {
    let lines: Vec<ListingLine<'_>> = (0..30)
        .map(|index| ListingLine {
            instead: (index == 12).then_some("another line"),
            indent: 0,
            text: ["a", "b", "c"][index % 3],
            current: index == 14,
            values: Some("its numbers"),
        })
        .collect();
    let played = Played::new("kd", &[]);
    let event = played.events[0];
    for height in [120.0, 300.0, 900.0] {
        let size = Vec2::new(300.0, height);
        let figure = listing("Walk", &lines, Some(&event), true, size, &LOOK);
        let drawn = figure.marks.iter().filter_map(|mark| match &mark.ink {
            Ink::Text { at, text, .. } if ["a", "b", "c"].contains(&text.as_str()) => Some((at.y, text.clone())),
            _ => None,
        });
        for (y, text) in drawn {
            let line = line_at(&lines, Some(&event), true, size, &LOOK, y).expect("a line");
            assert_eq!(lines[line].text, text, "at {y} of {height}");
        }
        assert_eq!(line_at(&lines, Some(&event), true, size, &LOOK, 2.0), None);
    }
}

#[test]
fn nothing_is_cut_off_at_any_step() {
    for kind in ["list", "slab", "grid", "hashed-grid", "kd", "bvh"] {
        let played = Played::new(kind, &[]);
        let walk = played.walk();
        for step in 0..=played.events.len() {
            let moment = Moment::at(&walk, step);
            for text in [13.0, 24.0] {
                let look = Look { text, titles: true, least: 0.0 };
                let size = |x: f32, y: f32| Vec2::new(x, y) * (text / 13.0);
                let wide = size(600.0, 130.0);
                let narrow = size(380.0, 150.0);
                let view = TreeView::default();
                let roomy = Vec2::new(wide.x, ruler_height(&walk, &look));
                let told_all = !told(&ruler(&walk, &moment, false, roomy, &look)).contains(" more\"");
                assert!(told_all, "{kind} step {step}: a row is left out of the roomy ruler");
                let panes = [
                    ("ruler", ruler(&walk, &moment, false, wide, &look)),
                    ("line", ruler_line(&walk, &moment, false, wide, &look)),
                    ("tree", tree(&walk, &moment, &view, wide, &look)),
                    ("timeline", timeline(&walk, step, &Ask::new(size(900.0, 80.0), look))),
                    ("stack", stack(&walk, &moment, narrow, &look)),
                    ("bin", bin(&moment, narrow, &look)),
                    (
                        "changed",
                        changed(&walk, &Moment::at(&walk, step.saturating_sub(3)), &moment, false, narrow, &look),
                    ),
                    ("work", work(&walk, &moment, None, narrow, &look)),
                    ("slabs", slabs(&walk, &moment, step % 2 == 0, narrow, &look)),
                    ("bytes", bytes(&walk, &moment, false, wide, &look)),
                    ("cells", cells(&walk, &moment, false, narrow, &look)),
                ];
                for (name, figure) in panes {
                    assert!(figure.marks.len() <= 300, "{kind} {name} step {step}: {} marks", figure.marks.len());
                    for mark in &figure.marks {
                        inside(&figure, mark, &format!("{kind} {name} step {step}"));
                    }
                }
            }
        }
    }
}

/// A mark's text lies in its figure.
fn inside(figure: &Figure, mark: &Mark, what: &str) {
    let Ink::Text { at, text, size, face, anchor, .. } = &mark.ink else { return };
    let width = text_width(text, *face, *size);
    let left = match anchor {
        Anchor::Start => at.x,
        Anchor::Middle => at.x - width / 2.0,
        Anchor::End => at.x - width,
    };
    let fits =
        left >= -0.5 && left + width <= figure.size.x + 0.5 && at.y >= 0.3 * size && at.y + 0.3 * size <= figure.size.y;
    assert!(fits, "{what}: {text:?} at {at} does not fit into {}", figure.size);
}
