//! Trees in panes of every size: small ones whole and legible, and of large ones nothing lost.

use std::collections::BTreeSet;

use glam::{Vec2, Vec3};
use raystep_accel::{Accel, KdLayout, Place, Prims, Ray, Rule, Shape, Sphere, Structure, Visit};
use raystep_figure::{
    Anchor, Face, Figure, Ink, Look, Moment, Nodes, Role, TreeView, Walk, text_width, tree, tree_height,
};

/// Discs strewn over a square, a structure over them, and a walk through it.
struct Stand {
    prims: Prims,
    structure: Structure,
    nodes: Nodes,
    ray: Ray,
    events: Vec<Visit>,
}

impl Stand {
    fn new(discs: u32, kind: &str, settings: &[(&str, &str)]) -> Stand {
        let mut seed = 7_u32;
        let mut random = || {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (seed >> 8) as f32 / (1 << 24) as f32
        };
        let disc = |x, y, radius| Shape::Sphere(Sphere { center: Vec3::new(x, y, 0.0), radius });
        let discs = (0..discs).map(|_| disc(10.0 * random(), 10.0 * random(), 0.02 + 0.1 * random())).collect();
        let mut rule = Rule::default_for(kind).expect("a kind");
        for (key, value) in settings {
            rule.set(key, value).expect("a parameter");
        }
        let prims = Prims::Few(discs);
        let structure = Structure::build(&prims, &rule.flat(), &mut ()).expect("nobody cancels");
        let ray = Ray::new(Vec3::new(-1.0, 0.7, 0.0), Vec3::new(1.0, 0.7, 0.0)).expect("a ray");
        let mut events = Vec::new();
        structure.intersect(&prims, &ray, &mut events);
        let nodes = Nodes::of(&structure);
        Stand { prims, structure, nodes, ray, events }
    }

    fn walk(&self) -> Walk<'_> {
        let Stand { structure, prims, nodes, ray, events, .. } = self;
        Walk { structure, prims, nodes, ray: *ray, events, lost: 0, flat: true, layout: KdLayout::Compact }
    }

    /// The tree at a few steps of the walk.
    fn trees(&self, size: Vec2, look: &Look) -> Vec<Figure> {
        let walk = self.walk();
        let steps = [0, self.events.len() / 3, self.events.len() / 2, self.events.len()];
        let at = |step| tree(&walk, &Moment::at(&walk, step), &TreeView::default(), size, look);
        steps.into_iter().map(at).collect()
    }
}

/// A node that is drawn: its number, the size of its digits, and its mark.
struct Drawn {
    node: u32,
    digits: f32,
    min: Vec2,
    max: Vec2,
}

fn drawn(figure: &Figure) -> Vec<Drawn> {
    let mut drawn = Vec::new();
    for pair in figure.marks.windows(2) {
        let (Some(place @ Place::Node(node)), Ink::Text { text, size, face: Face::MonoMedium, .. }) =
            (pair[1].place, &pair[1].ink)
        else {
            continue;
        };
        let (min, max) = match pair[0].ink {
            Ink::Circle { center, radius } => (center - radius, center + radius),
            Ink::Rect { min, max, .. } => (min, max),
            // The line of ancestors has no marks.
            _ => continue,
        };
        assert_eq!((pair[0].place, text), (Some(place), &node.0.to_string()));
        drawn.push(Drawn { node: node.0, digits: *size, min, max });
    }
    drawn
}

fn texts(figure: &Figure) -> Vec<(&str, Option<Place>, Role, Vec2, Vec2)> {
    let texts = figure.marks.iter().filter_map(|mark| match &mark.ink {
        Ink::Text { at, text, size, face, anchor, .. } => {
            let width = text_width(text, *face, *size);
            let left = match anchor {
                Anchor::Start => at.x,
                Anchor::Middle => at.x - width / 2.0,
                Anchor::End => at.x - width,
            };
            let (min, max) = (Vec2::new(left, at.y - size * 0.4), Vec2::new(left + width, at.y + size * 0.4));
            Some((text.as_str(), mark.place, mark.role, min, max))
        }
        _ => None,
    });
    texts.collect()
}

/// What is wrong with a tree in a pane, whatever its size.
fn check_pane(what: &str, figure: &Figure) {
    let nodes = drawn(figure);
    for (index, a) in nodes.iter().enumerate() {
        assert!(a.digits >= 11.0, "{what}: {} has digits of {}", a.node, a.digits);
        assert!(a.min.cmpge(Vec2::ZERO).all() && a.max.cmple(figure.size).all(), "{what}: {} is cut off", a.node);
        for b in &nodes[index + 1..] {
            let apart = a.max.cmplt(b.min).any() || b.max.cmplt(a.min).any();
            assert!(apart, "{what}: {} covers {}", a.node, b.node);
        }
    }
    let texts = texts(figure);
    for (index, (text, place, _, min, max)) in texts.iter().enumerate() {
        let inside = min.cmpge(Vec2::splat(-0.5)).all() && max.cmple(figure.size + 0.5).all();
        assert!(inside, "{what}: “{text}” is cut off");
        for (other, _, _, other_min, other_max) in &texts[index + 1..] {
            let apart = max.cmple(*other_min).any() || min.cmpge(*other_max).any();
            assert!(apart, "{what}: “{text}” covers “{other}”");
        }
        for node in nodes.iter().filter(|node| *place != Some(Place::Node(raystep_accel::NodeId(node.node)))) {
            let apart = max.cmple(node.min).any() || min.cmpge(node.max).any();
            assert!(apart, "{what}: “{text}” lies on {}", node.node);
        }
    }
    // Every kind of mark below a node has a word in the heading.
    let says = |words: &str| texts.iter().any(|(text, ..)| *text == words);
    let has = |place: fn(&Place) -> bool, ink: fn(&Ink) -> bool| {
        figure
            .marks
            .iter()
            .any(|mark| mark.place.as_ref().is_some_and(place) && mark.role == Role::Scene && ink(&mark.ink))
    };
    let circle = |ink: &Ink| matches!(ink, Ink::Circle { .. });
    let area = |ink: &Ink| matches!(ink, Ink::Area { .. });
    let (prim, node) =
        (|place: &Place| matches!(place, Place::Prim(_)), |place: &Place| matches!(place, Place::Node(_)));
    if figure.size.x >= 500.0 {
        for (occurs, words) in [
            (has(prim, circle), "a primitive"),
            (has(node, circle), "so many primitives"),
            (has(node, area), "so many nodes below, not drawn"),
        ] {
            assert!(!occurs || says(words), "{what}: a sign without “{words}”");
        }
    }
}

#[test]
fn a_small_tree_is_drawn_whole_in_digits_that_can_be_read() {
    let mut tried = BTreeSet::new();
    for discs in 1..=24 {
        for (kind, settings) in [
            ("kd", &[("min_objects", "1"), ("max_depth", "6")][..]),
            ("kd", &[("min_objects", "2"), ("split", "middle")]),
            ("bvh", &[("leaf_size", "1")]),
            ("bvh", &[("leaf_size", "2"), ("builder", "bottom-up")]),
            ("octree", &[]),
            ("bsp", &[("min_objects", "2")]),
        ] {
            let stand = Stand::new(discs, kind, settings);
            let count = stand.structure.node_count();
            if count > 31 {
                continue;
            }
            tried.insert(count);
            for text in [13.0, 15.0] {
                let look = Look { text, titles: true, least: 0.0 };
                let height = tree_height(&stand.nodes, &look).expect("a small tree has a height");
                for width in [640.0, 800.0] {
                    let what = format!("{kind} over {discs} in {width} × {height} at {text}");
                    for figure in stand.trees(Vec2::new(width, height), &look) {
                        assert_eq!(drawn(&figure).len(), count, "{what}");
                        check_pane(&what, &figure);
                    }
                }
            }
        }
    }
    assert!(tried.len() > 12, "{tried:?}");
}

#[test]
fn more_room_makes_larger_digits() {
    let stand = Stand::new(9, "kd", &[("min_objects", "2")]);
    let digits = |width: f32, height: f32, titles: bool| {
        let figure = &stand.trees(Vec2::new(width, height), &Look { text: 13.0, titles, least: 0.0 })[0];
        drawn(figure)[0].digits
    };
    assert!(digits(800.0, 300.0, true) > digits(500.0, 90.0, true));
    assert!(digits(1000.0, 625.0, false) >= 22.0);
}

#[test]
fn of_a_large_tree_nothing_is_lost() {
    for (kind, settings) in [
        ("kd", &[("min_objects", "1"), ("max_depth", "14")][..]),
        ("bvh", &[("leaf_size", "1")]),
        ("octree", &[("max_depth", "6")]),
    ] {
        let stand = Stand::new(700, kind, settings);
        let all = stand.structure.node_count();
        for (width, height) in [(800.0, 174.0), (640.0, 134.0), (380.0, 150.0), (1000.0, 400.0)] {
            let look = Look::WINDOW;
            for figure in stand.trees(Vec2::new(width, height), &look) {
                let what = format!("{kind} in {width} × {height}");
                check_pane(&what, &figure);
                let shown = drawn(&figure).len();
                let texts: Vec<&str> = texts(&figure).into_iter().map(|(text, ..)| text).collect();
                assert!(texts.contains(&format!("{shown} of {all} nodes drawn").as_str()), "{what}: {texts:?}");
                // Beside the rows stands how many nodes each level has; all levels make the tree.
                let rows = texts.iter().filter(|text| text.starts_with("level"));
                let counted: usize = rows.map(|row| last_number(row)).sum();
                assert!(counted == all || width < 400.0, "{what}: {texts:?}");
            }
        }
    }
}

/// The last number in a text.
fn last_number(text: &str) -> usize {
    let number = text.split(|letter: char| !letter.is_ascii_digit()).rfind(|word| !word.is_empty());
    number.expect("a number").parse().expect("a number")
}
