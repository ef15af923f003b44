//! Pairs of objects: in which order they are tested, how they are moved, and what is said of wrong slides.

use raystep_accel::Event;
use raystep_lesson::{Facts, Library, Medium, Plays, Tape, check};

const SLIDE: &str = "+++
format = 1
slide = 19
title = \"Pairs\"
plays = \"pairs\"
pairs = [\"ray/sphere\", \"box/box\"]
+++
## Laid out {at=pair pair=ray/sphere}
{{pair}}, {{case}}.

## An equation {at=quadratic}
It has solutions {{t1}} and {{t2}}.

> ask {field=real}: Has it any?
> - no: It has.
> - yes: It has none.

## The other {at=quadratic case=2}
> if event=quadratic.none: None now.

> window: [Nearer](set:ray_sphere_2=0 -1.2 0)

## Boxes {at=shadow.apart pair=box/box}
Apart along {{of}}.

# Notes
One minute.
";

fn library(slide: &str) -> Library {
    Library::from_files([("03-uniform-grid/19-pairs.md".to_owned(), slide.to_owned())])
}

fn problems(slide: &str) -> String {
    check(&library(slide), &|_, _| Vec::new()).iter().map(|problem| format!("  {problem}\n")).collect()
}

#[test]
fn each_pair_is_tested_in_two_arrangements_and_moved_ones_anew() {
    assert_eq!(problems(SLIDE), "");
    let library = library(SLIDE);
    let slide = &library.slides[0];
    let stage = &slide.stages[0];
    let built = stage.build(slide.plays).unwrap();
    let told = built.told.clone().unwrap();
    assert_eq!(told.plays(), Plays::Pairs);
    let answers = |tape: &Tape| -> Vec<String> {
        let ends = tape.events().filter(|event| event.name().starts_with("met") || event.name().starts_with("touch"));
        ends.map(|event| format!("{:?} {:?} {}", event.field("pair"), event.field("case"), event.name())).collect()
    };
    let own = answers(&told);
    assert_eq!(own.len(), 4);
    let play = built.play(None, &slide.beats).unwrap();
    let mut said = String::new();
    for (beat, step) in slide.beats.iter().zip(&play.beats) {
        let facts = Facts::at(&play, step.unwrap()).unwrap();
        said += &format!("{step:?} {}\n", beat.text(&facts, Medium::Window));
        for choice in beat.ask.iter().flat_map(|ask| ask.choices(&play, step.unwrap())) {
            said += &format!("   {:?}{}\n", choice.value, if choice.right { ", right" } else { "" });
        }
    }
    insta::assert_snapshot!(said);

    // Moved back onto the other arrangement, the test answers as it does there; and nothing else changes.
    let set = |value: &str| vec![("ray_sphere_2".to_owned(), value.to_owned())];
    let moved = answers(&told.clone().moved(&set("0 -1.2 0")));
    let name = |answer: &String| answer.rsplit(' ').next().unwrap().to_owned();
    assert_eq!(name(&moved[1]), name(&own[0]));
    assert_ne!(name(&moved[1]), name(&own[1]));
    assert_eq!([&moved[0], &moved[2], &moved[3]], [&own[0], &own[2], &own[3]]);
    // What cannot be read counts for nothing, and what is given up is back where it was.
    assert_eq!(answers(&told.clone().moved(&set("up"))), own);
    assert_eq!(answers(&told.clone().moved(&set("0 -1.2 0")).moved(&[])), own);
    assert!(matches!(told.event(0), Some(Event::Pair(trial)) if trial.step.is_none()));
}

#[test]
fn wrong_slides_are_told_what_is_wrong() {
    let mistakes = [
        ("unknown pair", "\"box/box\"]", "\"box/bux\"]"),
        ("a pair twice", "\"box/box\"]", "\"ray/sphere\"]"),
        ("no pair", "[\"ray/sphere\", \"box/box\"]", "[]"),
        ("rays", "pairs = [", "rays = []\npairs = ["),
        ("unknown event", "{at=quadratic}", "{at=quadratix}"),
        ("unknown field", "solutions {{t1}}", "solutions {{t3}}"),
        ("a pair that is not tested", "pair=box/box}", "pair=ray/cone}"),
        ("a third arrangement", "case=2}", "case=3}"),
        ("a ray for a beat", "{at=pair pair=ray/sphere}", "{at=pair ray=first}"),
        ("moved too far", "0 -1.2 0)", "0 -1000 0)"),
        ("moved by a word", "0 -1.2 0)", "down)"),
        ("another's body", "set:ray_sphere_2", "set:ray_cone_2"),
    ];
    let mut table = String::new();
    for (what, from, to) in mistakes {
        assert!(SLIDE.contains(from), "the good slide has no {from:?}");
        let found = problems(&SLIDE.replacen(from, to, 1));
        assert!(!found.is_empty(), "{what} goes unnoticed");
        table += &format!("{what}\n{found}");
    }
    insta::assert_snapshot!(table);
}
