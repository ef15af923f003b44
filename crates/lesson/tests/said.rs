//! What a beat says and offers at its step, in the window and on paper.

use raystep_lesson::{Act, Beat, Facts, Library, Medium, Play};

const SLIDE: &str = include_str!("good_slide.md");

/// The last beat of the good slide, saying `text` where a node is thrown away, and its play on the ray `far hit`.
fn told<R>(text: &str, ask: impl Fn(&Beat, &Facts<'_>) -> R) -> R {
    let beside = "structure = { kind = \"kd\", max_depth = 6, min_objects = 2 }\nbeside = { kind = \"list\" }";
    let slide = SLIDE.replace("structure = { kind = \"kd\", max_depth = 6, min_objects = 2 }", beside);
    let slide = slide.replace("The best is {{best_t}}.", text);
    let library = Library::from_files([("05-kd-tree/1-first.md".to_owned(), slide)]);
    assert!(library.problems.is_empty(), "{text}: {:?}", library.problems);
    let slide = &library.slides[0];
    let stage = &slide.stages[0];
    let built = stage.build(slide.plays).unwrap();
    let other = stage.build_beside(&built.scene, slide.plays).unwrap();
    let play: Play = built.play_with(other.as_ref(), Some(stage.rays[1].ray), &slide.beats).unwrap();
    let beat = slide.beats.last().unwrap();
    let facts = Facts::at(&play, play.beats.last().copied().flatten().unwrap()).unwrap();
    ask(beat, &facts)
}

#[test]
fn a_paragraph_is_said_where_it_belongs() {
    // The node thrown away begins at t = 5.1, the best hit is at t = 4.25, found after one other test.
    let both = [
        ("Plain {{t_near}}.", true),
        ("> if best_t<t_near: Before.", true),
        ("> if best_t>=t_near: Not before.", false),
        ("> if better.t<=best_t and better.t>=best_t: The same hit.", true),
        ("> if better.before>1000: The first.", true),
        ("> if count.drop=1 and count.better=1: Once.", true),
        ("> if count.drop>1: Again.", false),
        ("> if stage=flat: Flat.", true),
        ("> if stage!=flat: Solid.", false),
        ("> if event=drop: {{best_t}}.", true),
        ("> if skip.prim=3: Skipped.", false),
        ("> if skip.prim!=3: Skipped another.", false),
        ("Never skipped {{skip.prim}}.", false),
        ("The plane before was {{plane.plane}}.", true),
    ];
    for (text, said) in both {
        for medium in [Medium::Window, Medium::Paper] {
            let found = told(text, |beat, facts| beat.text(facts, medium));
            assert_eq!(!found.is_empty(), said, "{text}: {found:?}");
        }
    }
    let of_one = [
        ("> paper: {{beside.count.test}} tests.", Medium::Paper),
        ("> paper if beside.count.test>count.test: {{beside.end.t}}.", Medium::Paper),
        ("> window: Words.", Medium::Window),
        ("> window if count.drop=1: Words.", Medium::Window),
    ];
    for (text, medium) in of_one {
        let said = |medium| told(text, |beat, facts| !beat.text(facts, medium).is_empty());
        let here = [Medium::Window, Medium::Paper].map(said);
        assert_eq!(here, [medium == Medium::Window, medium == Medium::Paper], "{text}");
    }
}

#[test]
fn facts_are_of_events_that_have_happened() {
    let fact = |name: &str| {
        let value = told("", |_, facts| facts.field(name));
        value.map(|value| format!("{value:?}"))
    };
    let known = [
        ("count.drop", Some("Count(1)")),
        ("count.end", Some("Count(0)")),
        ("count.test", Some("Count(5)")),
        ("beside.count.test", Some("Count(12)")),
        ("beside.hit", Some("Flag(true)")),
        ("drop.t_near", None),
        ("end.t", None),
        ("split.side", Some("Word(\"near\", [\"both\", \"near\", \"far\"])")),
    ];
    for (name, value) in known {
        assert_eq!(fact(name).as_deref(), value, "{name}");
    }
}

#[test]
fn links_of_the_window_are_buttons() {
    let offers = |text: &str| {
        told(text, |beat, facts| {
            let offers = beat.offers(facts).map(|offer| (offer.words.clone(), offer.act.clone()));
            (beat.text(facts, Medium::Window), offers.collect::<Vec<_>>())
        })
    };
    let set =
        |pairs: &[(&str, &str)]| Act::Set(pairs.iter().map(|(a, b)| ((*a).to_owned(), (*b).to_owned())).collect());
    let table = [
        ("> window: [Less](set:max_depth=3)", "", vec![("Less", set(&[("max_depth", "3")]))]),
        (
            "> window: Or [less deep](set:max_depth=3,min_objects=1) and [a grid](compare:grid).",
            "Or  and .",
            vec![("less deep", set(&[("max_depth", "3"), ("min_objects", "1")])), ("a grid", Act::Compare("grid"))],
        ),
        ("> window if count.drop>1: [Less](set:max_depth=3)", "", vec![]),
        ("> window: [Again](slide:5/33)", "", vec![("Again", Act::Slide("5/33".to_owned()))]),
    ];
    // Before a class what is for a hand on the mouse is not said.
    let on_the_wall = |text: &str| told(text, |beat, facts| beat.text(facts, Medium::Wall));
    assert_eq!(on_the_wall("> window: Drag the knob."), "");
    assert_eq!(on_the_wall("> window: Drag the knob. [Less](set:max_depth=3)"), "");
    for (text, said, acts) in table {
        let acts: Vec<(String, Act)> = acts.into_iter().map(|(words, act)| (words.to_owned(), act)).collect();
        assert_eq!(offers(text), (said.to_owned(), acts), "{text}");
    }
}
