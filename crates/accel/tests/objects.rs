//! Every test of two objects as text, on the pair that slide 19's matrix opens it with.

mod spell;

use glam::Vec3;
use raystep_accel::*;
use spell::line;

#[test]
fn every_pair_tells_its_steps() {
    for pair in &PAIRS {
        let [first, second] = pair.example();
        let (steps, answer) = pair.observe([&first, &second]).unwrap();
        let story: String = steps
            .iter()
            .map(|step| line(step.name(), step.fields(), |field| step.field(field)).trim_end().to_owned() + "\n")
            .collect();
        let name = format!("{} and {}", pair.first.word(), pair.second.word()).replace(' ', "_");
        insta::assert_snapshot!(name, format!("{}, after {}: {answer}\n{story}", pair.idea, pair.source));
    }
}

#[test]
fn a_test_ends_with_its_answer_and_only_there() {
    for pair in &PAIRS {
        let [first, second] = pair.example();
        let (steps, answer) = pair.observe([&first, &second]).unwrap();
        let ends: Vec<_> = steps.iter().map(|step| step.grain() == Grain::Visit).collect();
        assert_eq!(ends.iter().position(|&end| end), Some(steps.len() - 1));
        match steps.last() {
            Some(Step::Probe(Probe::Met { hit, t })) => assert_eq!((*hit, t.is_finite()), (answer, answer)),
            Some(Step::Probe(Probe::Touch { touch })) => assert_eq!(*touch, answer),
            other => panic!("no answer: {other:?}"),
        }
        // Nobody watching changes nothing.
        assert_eq!(first.meets(&second, &mut ()), Some(answer));
        for step in &steps {
            let names: Vec<_> =
                Probe::NAMES.iter().chain(Visit::NAMES).filter(|(names, _)| names.contains(&step.name())).collect();
            assert!(names.iter().any(|(_, fields)| *fields == step.fields()), "{}", step.name());
        }
    }
}

#[test]
fn the_matrix_has_every_pair_once_and_refuses_all_others() {
    for (i, pair) in PAIRS.iter().enumerate() {
        let kinds = |pair: &Pair| (pair.first, pair.second);
        assert!(PAIRS[..i].iter().all(|before| kinds(before) != kinds(pair)));
        let [first, second] = pair.example();
        assert_eq!((first.kind(), second.kind()), (Some(pair.first), Some(pair.second)));
        if pair.first != pair.second {
            assert_eq!(second.meets(&first, &mut ()), None);
            assert_eq!(pair.observe([&second, &first]), None);
        }
    }
    let disc = Body::Shape(Shape::Disc(Disc { center: Vec3::ZERO, normal: Vec3::Z, radius: 1.0 }));
    assert_eq!(disc.kind(), None);
    assert_eq!(Body::Point(Vec3::ZERO).meets(&disc, &mut ()), None);
}
