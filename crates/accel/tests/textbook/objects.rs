//! Every test of two objects as text, on the pair that slide 19's matrix opens it with.

use crate::spell::line;
use glam::Vec3;
use raystep_accel::*;

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

#[test]
fn every_pair_has_two_arrangements_and_the_test_tells_them_apart() {
    for (index, pair) in PAIRS.iter().enumerate() {
        let answers = pair.cases().map(|[first, second]| {
            assert!(first.middle().is_finite());
            pair.observe([&first, &second]).unwrap().1
        });
        assert_ne!(answers[0], answers[1], "{}", pair.name);
        // Both have something to show before they answer.
        for [first, second] in pair.cases() {
            let (steps, _) = pair.observe([&first, &second]).unwrap();
            assert!(steps.len() > 1, "{}: {steps:?}", pair.name);
        }
        let word = |kind: Kind| kind.word().replace(' ', "-");
        assert_eq!(pair.name, format!("{}/{}", word(pair.first), word(pair.second)));
        assert_eq!(Pair::named(pair.name), Some(index));
    }
    assert_eq!(Pair::named("ray/ray"), None);
}

#[test]
fn what_is_moved_there_and_back_is_where_it_was() {
    let by = Vec3::new(0.5, -2.0, 4.0);
    for pair in &PAIRS {
        let [first, second] = pair.example();
        for body in [first, second] {
            let moved = body.moved(by);
            assert_eq!(moved.moved(-by), body, "{}", pair.name);
            // Only a polygon cannot be moved.
            let still = matches!(body, Body::Shape(Shape::Polygon(_)));
            assert_eq!(moved == body, still, "{}", pair.name);
            assert!(still || (moved.middle() - body.middle() - by).length() < 1e-6, "{}", pair.name);
        }
    }
}

#[test]
fn what_is_told_of_a_trial_can_be_asked_for() {
    for (index, pair) in PAIRS.iter().enumerate() {
        let [first, second] = pair.example();
        let (steps, _) = pair.observe([&first, &second]).unwrap();
        for step in std::iter::once(None).chain(steps.into_iter().map(Some)) {
            let trial = Trial { pair: index as u32, case: 1, step };
            let known = Trial::NAMES.iter().find(|(names, _)| names.contains(&trial.name())).unwrap();
            assert_eq!(known.1, trial.fields());
            assert_eq!(trial.field("pair"), Some(Value::Word(pair.name, trial_names())));
            assert!(trial.fields().iter().all(|field| trial.field(field).is_some()), "{}", trial.name());
        }
    }
}

/// The words of the field `pair`.
fn trial_names() -> &'static [&'static str] {
    match (Trial { pair: 0, case: 1, step: None }).field("pair") {
        Some(Value::Word(_, words)) => words,
        other => panic!("no word: {other:?}"),
    }
}
