//! Volumes that are fitted: what happens on each stage, and what is said of wrong slides.

use raystep_lesson::{Facts, Library, Medium, Plays, Tape, check};

const SLIDE: &str = "+++
format = 1
slide = 49
title = \"A sphere\"
plays = \"fit\"
listing = \"fit\"
show = [\"space\", \"work\", \"listing\"]

[flat]
scene = \"flat-twig\"
volume = \"sphere\"

[solid]
scene = \"teapot:2x2\"
volume = \"sphere\"
+++
## The points {at=gather}
{{points point}}.

## Outside {at=far.outside}
Point {{point}} lies {{far}} away.

> ask {field=outside}: Does it lie outside?
> - yes: It does.
> - no: It does not.

## A sphere {at=ball#2}
Around {{few point}}: {{radius}}.

## Done {at=end}
{{count.far}} times through {{gather.points point}}, radius {{sphere.radius}}, {{planes plane}}, {{bytes}} bytes.

# Notes
One minute.
";

const LISTING: &str = "fit(set)
  points ← the corners            | gather : {{points point}}
  the furthest                    | far : {{far}} against {{radius}}
  a sphere around few             | ball : {{few}}
  return it                       | end
";

fn library(slide: &str) -> Library {
    Library::from_files([
        ("07-bvh/49-sphere.md".to_owned(), slide.to_owned()),
        ("listings/fit.txt".to_owned(), LISTING.to_owned()),
    ])
}

fn problems(slide: &str) -> String {
    check(&library(slide), &|_, _| Vec::new()).iter().map(|problem| format!("  {problem}\n")).collect()
}

#[test]
fn a_volume_is_fitted_on_each_stage_and_its_beats_are_told() {
    assert_eq!(problems(SLIDE), "");
    let library = library(SLIDE);
    let slide = &library.slides[0];
    let mut said = String::new();
    for stage in &slide.stages {
        let built = stage.build(slide.plays).unwrap();
        assert_eq!(built.told.as_ref().map(Tape::plays), Some(Plays::Fit));
        let play = built.play(None, &slide.beats).unwrap();
        assert_eq!(play.tape.lost(), 0);
        for (beat, step) in slide.beats.iter().zip(&play.beats) {
            let facts = Facts::at(&play, step.expect("every beat happens")).unwrap();
            said += &format!("{} {}: {}\n", stage.kind.name(), beat.title, beat.text(&facts, Medium::Paper));
            let named = facts.event().fields().iter().filter_map(|field| Some((field, facts.event().field(field)?)));
            for (field, value) in named {
                said += &format!("    {field} {value:?}\n");
            }
        }
    }
    insta::assert_snapshot!(said);
}

#[test]
fn wrong_slides_are_told_what_is_wrong() {
    let mistakes = [
        ("no volume", "volume = \"sphere\"\n\n[solid]", "\n[solid]"),
        ("unknown volume", "volume = \"sphere\"\n\n[solid]", "volume = \"spear\"\n\n[solid]"),
        ("a number", "volume = \"sphere\"\n\n[solid]", "volume = 18\n\n[solid]"),
        (
            "a structure instead",
            "volume = \"sphere\"\n\n[solid]",
            "structure = { kind = \"bvh\", volume = \"sphere\" }\n\n[solid]",
        ),
        ("rays", "volume = \"sphere\"\n\n[solid]", "volume = \"sphere\"\nrays = []\n\n[solid]"),
        ("unknown scene", "flat-twig", "flat-twik"),
        ("unknown event", "{at=far.outside}", "{at=far.outsite}"),
        ("an event of builds", "{at=far.outside}", "{at=weigh}"),
        ("unknown field", "{{few point}}", "{{view point}}"),
        ("another volume's event", "{at=ball#2}", "{at=face.made}"),
        ("a ray for a beat", "{at=end}", "{at=end ray=\"first\"}"),
        ("no listing", "listing = \"fit\"\n", ""),
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
