//! A kd-tree says the same in each of its four layouts, and takes the bytes that the slides print.

use std::fmt::Write;

use glam::{Vec2, Vec3};
use proptest::prelude::*;
use raystep_accel::*;

fn disc((x, y, radius): (f32, f32, f32)) -> Shape<'static> {
    Shape::Sphere(Sphere { center: Vec3::new(x, y, 0.0), radius })
}

/// A dozen discs, walls between some of them.
fn scene() -> Vec<Shape<'static>> {
    let discs =
        (0..12_u8).map(|i| disc((f32::from(i % 4) * 2.0, f32::from(i / 4) * 1.5, 0.3 + f32::from(i % 3) * 0.2)));
    let walls = (0..4_u8).map(|i| {
        let from = Vec2::new(f32::from(i) * 1.7, 0.7);
        Shape::Wall(Wall { from, to: from + Vec2::new(0.9, 1.2), z: [-0.5, 0.5] })
    });
    discs.chain(walls).collect()
}

fn grown(prims: &[Shape<'_>], rule: KdRule) -> Kd {
    Kd::build(&prims, &KdRule { min_objects: 1, ..rule }, &mut ()).unwrap()
}

#[test]
fn a_node_takes_what_the_slides_print() {
    let bytes = |machine| KdLayout::ALL.iter().map(|layout| layout.bytes(machine)).collect::<Vec<_>>();
    assert_eq!(bytes(Machine::Printed), [25, 21, 12, 8]);
    assert_eq!(bytes(Machine::Bits32), [28, 24, 12, 8]);
    assert_eq!(bytes(Machine::Bits64), [48, 40, 24, 8]);
}

#[test]
fn the_tree_itself_has_the_last_layout() {
    assert_eq!(KdLayout::Compact.bytes_here(), Kd::NODE_BYTES);
}

#[test]
fn bits_that_share_a_word_fill_it() {
    for field in KdLayout::ALL.iter().flat_map(|layout| layout.fields()).filter(|field| !field.bits.is_empty()) {
        assert_eq!(field.bits.iter().map(|(_, bits)| bits).sum::<u32>(), 32, "{field:?}");
    }
}

#[test]
fn a_ray_that_misses_touches_nothing() {
    let mut lines = CacheLines::new(8);
    let ray = Ray::new(Vec3::new(0.0, 50.0, 0.0), Vec3::X).unwrap();
    assert_eq!(grown(&scene(), KdRule::default()).intersect(&scene().as_slice(), &ray, &mut lines), None);
    assert!(lines.touched().is_empty());
}

#[test]
fn an_empty_tree_is_one_leaf_in_every_layout() {
    for &layout in KdLayout::ALL {
        let memory = KdMemory::of(&grown(&[], KdRule::default()), layout).unwrap();
        assert_eq!((memory.children(NodeId::ROOT), memory.split(NodeId::ROOT)), (None, None));
        assert_eq!(memory.leaf_prims(NodeId::ROOT), []);
    }
}

#[test]
fn a_node_of_a_flat_scene_in_four_layouts_and_the_lines_that_a_ray_touches() {
    let (prims, rule) = (scene(), KdRule { axes: Axes::Xy, measure: Measure::Perimeter, ..KdRule::default() });
    let tree = grown(&prims, rule);
    let nodes = || (0..tree.node_count() as u32).map(NodeId);
    let inner = nodes().rfind(|node| tree.split(*node).is_some_and(|(axis, _)| axis == Axis::Y)).unwrap();
    let leaf = nodes().find(|node| tree.leaf_prims(*node).len() > 1).unwrap();
    let ray = Ray::new(Vec3::new(-1.0, 3.4, 0.0), Vec3::new(1.0, -0.45, 0.0)).unwrap();

    let mut text = format!("{} nodes\n", tree.node_count());
    for &layout in KdLayout::ALL {
        let [printed, bits32, bits64] = Machine::ALL.map(|machine| layout.bytes(machine));
        writeln!(text, "\n{}: {printed} bytes, {bits32} and {bits64} as compiled", layout.word()).unwrap();
        let memory = KdMemory::of(&tree, layout).unwrap();
        for node in [inner, leaf] {
            let bytes: String = memory.node(node).iter().map(|byte| format!(" {byte:02x}")).collect();
            writeln!(text, "  node {node}:{bytes}").unwrap();
            for (field, word) in memory.fields(node) {
                writeln!(text, "    {:<24} {}", field.name, spelt(field, word)).unwrap();
            }
        }
        for bytes in [printed, bits64] {
            let mut lines = CacheLines::new(bytes);
            tree.intersect(&prims.as_slice(), &ray, &mut lines);
            writeln!(text, "  a ray touches {} lines at {bytes} bytes: {:?}", lines.touched().len(), lines.touched())
                .unwrap();
        }
    }
    insta::assert_snapshot!(text);
}

/// What stands in a field, and apart what its bits say.
fn spelt(field: &NodeField, mut word: u32) -> String {
    if field.word == Word::Float {
        return f32::from_bits(word).to_string();
    }
    let mut text = word.to_string();
    for (name, bits) in field.bits {
        write!(text, ", {name} {}", word & !(u32::MAX << bits)).unwrap();
        word >>= bits;
    }
    text
}

proptest! {
    /// Any tree is read back from its bytes as it was written.
    #[test]
    fn every_layout_says_what_the_tree_says(
        discs in prop::collection::vec((-9.0..9.0_f32, -9.0..9.0_f32, 0.01..2.0_f32), 0..80),
        split in prop::sample::select(KdSplit::ALL.to_vec()),
    ) {
        let prims: Vec<_> = discs.into_iter().map(disc).collect();
        let tree = grown(&prims, KdRule { split, ..KdRule::default() });
        for &layout in KdLayout::ALL {
            let memory = KdMemory::of(&tree, layout).unwrap();
            let nodes = tree.node_count() * layout.bytes(Machine::Printed);
            prop_assert_eq!(memory.bytes().len(), nodes.next_multiple_of(4) + 4 * tree.reference_count());
            for node in (0..tree.node_count() as u32).map(NodeId) {
                prop_assert_eq!(memory.children(node), tree.children(node));
                prop_assert_eq!(memory.split(node), tree.split(node));
                prop_assert_eq!(memory.leaf_prims(node), tree.leaf_prims(node));
                prop_assert_eq!(memory.fields(node).collect::<Vec<_>>(), layout.node(&tree, node).unwrap());
            }
        }
    }

    /// The lines touched are those that share a byte with a node entered, and room enough for all of these.
    #[test]
    fn a_ray_touches_the_lines_of_the_nodes_that_it_enters(
        discs in prop::collection::vec((-9.0..9.0_f32, -9.0..9.0_f32, 0.01..2.0_f32), 1..80),
        from in (-20.0..20.0_f32, -20.0..20.0_f32),
        to in (-9.0..9.0_f32, -9.0..9.0_f32),
    ) {
        let prims: Vec<_> = discs.into_iter().map(disc).collect();
        let tree = grown(&prims, KdRule::default());
        let (from, to) = (Vec2::from(from).extend(0.0), Vec2::from(to).extend(0.0));
        prop_assume!(from != to);
        let ray = Ray::new(from, to - from).unwrap();
        for bytes in Machine::ALL.iter().flat_map(|m| KdLayout::ALL.iter().map(|layout| layout.bytes(*m))) {
            let mut watch = (CacheLines::new(bytes), Vec::new());
            tree.intersect(&prims.as_slice(), &ray, &mut watch);
            let (lines, events) = watch;
            let mut entered = Vec::new();
            for event in events {
                if let Visit::Enter { place: Place::Node(node), .. } = event {
                    entered.push(node.index() * bytes);
                }
            }
            let holds = |line: usize, begin: usize| begin < (line + 1) * 64 && line * 64 < begin + bytes;
            let last = tree.node_count() * bytes / 64;
            let expected = (0..=last).filter(|line| entered.iter().any(|begin| holds(*line, *begin)));
            prop_assert!(lines.touched().iter().copied().eq(expected));
            prop_assert!(lines.touched().len() * 64 >= entered.len() * bytes);
        }
    }
}
