//! Boards, and walks side by side: what they show, in which order, and what is said of wrong ones.

use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};

use raystep_accel::{Mesh, Ray};
use raystep_fast::{Race, Told};
use raystep_lesson::{Beat, BoardTape, Built, Care, Facts, Library, Medium, Stopwatch, Tape, check};

const SLIDE: &str = include_str!("good_board.md");
const WALKS: &str = include_str!("good_walks.md");

fn library(slide: &str) -> Library {
    Library::from_files([("03-uniform-grid/22-board.md".to_owned(), slide.to_owned())])
}

fn problems(slide: &str) -> String {
    check(&library(slide), &|_, _| Vec::new()).iter().map(|problem| format!("  {problem}\n")).collect()
}

#[test]
fn a_board_is_filled_step_by_step_and_its_texts_know_its_numbers() {
    assert_eq!(problems(SLIDE), "");
    let library = library(SLIDE);
    let slide = &library.slides[0];
    assert_eq!(slide.notes, "Three minutes.");
    let play = slide.stages[0].build(slide.plays).unwrap().play(None, &slide.beats).unwrap();
    let mut told = String::new();
    for (beat, step) in slide.beats.iter().zip(&play.beats) {
        let step = step.unwrap();
        let facts = Facts::at(&play, step).unwrap();
        told += &format!("{step}: {}\n", beat.text(&facts, Medium::Paper));
        for field in ["x", "y", "printed", "computed", "tests", "visits", "nodes", "first", "last", "mean", "most"] {
            if let Some(value) = facts.field(field) {
                told += &format!("   {field} {value:?}\n");
            }
        }
        for choice in beat.ask.iter().flat_map(|ask| ask.choices(&play, step)) {
            told += &format!("   {:?}{}\n", choice.label, if choice.right { ", right" } else { "" });
        }
    }
    insta::assert_snapshot!(told);
}

#[test]
fn numbers_that_are_moved_by_hand_move_what_names_them_and_nothing_else() {
    let library = library(SLIDE);
    let slide = &library.slides[0];
    let built = slide.stages[0].build(slide.plays).unwrap();
    let mut told = String::new();
    let set = |key: &str, value: &str| (key.to_owned(), value.to_owned());
    let settings =
        [vec![], vec![set("N", "800")], vec![set("N", "8"), set("N", "16")], vec![set("N", "9e9"), set("k", "1")]];
    for settings in settings {
        let moved = built.told.clone().unwrap().moved(&settings);
        let Tape::Board(board) = &moved else { panic!("a board") };
        let meter = board.board.meter().unwrap();
        told += &format!("{settings:?}: gives {}\n", meter.gives[0].formula.at(0.0, &board.numbers));
        let numbers = meter.numbers.iter().map(|number| board.numbers.get(&number.name).unwrap());
        told += &format!("   {:?}\n", numbers.collect::<Vec<_>>());
        let built = Built { told: Some(moved.clone()), ..built.clone() };
        let play = built.play(None, &slide.beats).unwrap();
        for (beat, step) in slide.beats.iter().zip(&play.beats) {
            let facts = Facts::at(&play, step.unwrap()).unwrap();
            told += &format!("   {:?}: {}", beat.title, beat.text(&facts, Medium::Window).replace('\n', " "));
            told += &format!(" y {:?}, N {:?}\n", facts.field("y"), facts.field("N"));
        }
        // Back to where the slide has them.
        let back = moved.moved(&[]);
        assert_eq!(format!("{back:?}"), format!("{:?}", built.told.clone().unwrap().moved(&[])));
    }
    insta::assert_snapshot!(told);
}

/// A machine on which whatever is done takes a hundredth of a second, and which has no graphics card.
#[derive(Default)]
struct Slow(AtomicU32);

impl Stopwatch for Slow {
    fn seconds(&self) -> f64 {
        f64::from(self.0.fetch_add(1, Ordering::Relaxed)) * 0.01
    }

    fn goes_on(&self) -> bool {
        true
    }

    fn graphics_card(&self, _: &Race<'_>, _: &Mesh, _: &[Ray]) -> Option<Result<Told, String>> {
        Some(Err("there is none".to_owned()))
    }
}

#[test]
fn times_are_told_once_they_are_measured_and_paper_has_none() {
    let library = library(SLIDE);
    let slide = &library.slides[0];
    let built = slide.stages[0].build(slide.plays).unwrap();
    let Some(Tape::Board(filled)) = built.told.clone() else { panic!("a board") };
    assert_eq!(filled.times(), (3, 3));
    let text = |filled: &Arc<BoardTape>| {
        let told = Built { told: Some(Tape::Board(filled.clone())), ..built.clone() };
        let play = told.play(None, &slide.beats).unwrap();
        let said =
            |(beat, step): (&Beat, &Option<usize>)| beat.text(&Facts::at(&play, step.unwrap()).unwrap(), Medium::Paper);
        slide.beats.iter().zip(&play.beats).map(said).collect::<Vec<_>>().join("\n")
    };
    let before = text(&filled);
    assert!(
        before.contains("In the window.") && !before.contains("million rays") && !before.contains("became {{speed}}")
    );

    let watch = Slow::default();
    let mut further = filled.clone();
    for left in [2, 1, 0] {
        let fineness = further.fineness();
        further = further.timed_further(&built.scene, &watch).unwrap();
        assert_eq!(further.times(), (3, left));
        assert!(further.fineness() > fineness);
    }
    let after = text(&further);
    assert!(after.contains("{{speed}} million rays") && after.contains("{{row.speed}} became {{speed}}."), "{after}");
    assert!(!after.contains("In the window."));
    for timing in further.timed.iter().flatten() {
        let timed = timing.as_ref().unwrap();
        assert!(timed.speed > 0.0 && timed.spread[0] <= timed.speed && timed.speed <= timed.spread[1], "{timed:?}");
        assert!(timed.build > 0.0);
    }
    // What is counted is the same, timed or not, and so is all of it for paper.
    assert_eq!(format!("{:?}", further.measured), format!("{:?}", filled.measured));
    assert_eq!(format!("{:?}", further.untold().events), format!("{:?}", filled.events));
}

#[test]
fn what_follows_the_meter_is_measured_where_it_stands() {
    let library = library(SLIDE);
    let slide = &library.slides[0];
    let built = slide.stages[0].build(slide.plays).unwrap();
    let tape = built.told.clone().unwrap();
    let moved = tape.moved(&[("N".to_owned(), "8".to_owned())]);
    let Tape::Board(stale) = &moved else { panic!("a board") };
    assert!(stale.care() == Care::Draft && !stale.is_finished());
    let of = |tape: &BoardTape| tape.counted.iter().flatten().last().unwrap().mean();
    let coarse = stale.clone().filled(&built.scene, Care::Draft, &mut ()).unwrap();
    let fine = coarse.clone().filled(&built.scene, Care::Full, &mut ()).unwrap();
    assert!(coarse.fineness() < fine.fineness() && fine.is_finished());
    // Nodes of 80 triangles are not divided in it, nodes of 9 are.
    assert!(of(&fine) * 1.5 < of(stale), "{} after {}", of(&fine), of(stale));
    let written = SLIDE.replace("min_objects = \"{{N}}\"", "min_objects = 8");
    let own = self::library(&written).slides[0].stages[0].build(slide.plays).unwrap();
    let Some(Tape::Board(own)) = own.told else { panic!("a board") };
    assert_eq!(own.counted, fine.counted);
    let same = |a: &BoardTape, b: &BoardTape| format!("{:?}", a.measured) == format!("{:?}", b.measured);
    assert!(same(stale, &fine), "what does not move is not measured anew");
}

#[test]
fn a_board_stands_bare_before_anything_is_measured_and_is_then_filled_as_at_once() {
    let library = library(SLIDE);
    let slide = &library.slides[0];
    let full = slide.stages[0].build(slide.plays).unwrap();
    let Some(Tape::Board(whole)) = full.told.clone() else { panic!("a board") };
    let mut tape = Arc::new(BoardTape::fill(&whole.board, &full.scene, Care::Bare, &mut ()).unwrap());
    assert!(tape.measured.iter().all(Option::is_none) && tape.counted.iter().all(Option::is_none));
    assert!(tape.grown.iter().all(Vec::is_empty));
    let many = tape.places.len();
    let (waiting, _) = (many - tape.filled_to(Care::Draft).0, tape.filled_to(Care::Draft).1);
    assert!(waiting > 3, "{waiting}");

    // A text that names what waits has its room, and says so.
    let texts = |tape: &Arc<BoardTape>| {
        let play = Built { told: Some(Tape::Board(tape.clone())), ..full.clone() }.play(None, &slide.beats).unwrap();
        let told = |(beat, step): (&Beat, &Option<usize>)| {
            let facts = Facts::at(&play, step.unwrap()).unwrap();
            let care = ["tests", "mean", "first", "nodes", "printed", "speed"].map(|name| facts.care(name));
            let known = ["tests", "mean", "first"].map(|name| facts.field(name).is_some());
            (beat.text(&facts, Medium::Window), care, known)
        };
        slide.beats.iter().zip(&play.beats).map(told).collect::<Vec<_>>()
    };
    let (bare, last) = (texts(&tape), texts(&whole));
    for ((bare, cares, known), (last, _, measured)) in bare.iter().zip(&last) {
        assert_eq!(bare, last, "the same is said, before its numbers are filled in");
        assert_eq!(known, measured);
        assert_eq!(cares[4..], [Care::Full; 2], "what is not measured, or timed, is as it is");
    }
    assert!(bare.iter().any(|(_, cares, _)| cares.contains(&Care::Bare)));

    let mut rounds = 0;
    while tape.care() < Care::Full {
        let before = tape.fineness();
        tape = tape.filled_further(&full.scene, &mut ()).unwrap();
        assert!(tape.fineness() > before);
        rounds += 1;
        if rounds == waiting {
            assert_eq!(tape.care(), Care::Draft, "all of it coarsely first");
            let nodes = |(_, cares, _): &(String, [Care; 6], _)| cares[3];
            assert!(texts(&tape).iter().all(|text| nodes(text) == Care::Full), "nodes are counted without rays");
        }
    }
    assert!(rounds <= waiting * 2);
    assert_eq!(format!("{:?}", tape.events), format!("{:?}", whole.events), "as if it was filled at once");
}

#[test]
fn wrong_boards_are_told_what_is_wrong() {
    let mistakes = [
        ("nothing on it", "[[chart]]", "[[chrat]]"),
        ("rays", "scene =", "rays = []\nscene ="),
        ("unknown column", "tells = \"printed\"", "tells = \"pinted\""),
        (
            "no columns",
            "{ tells = \"printed\", head = \"as printed\" },\n  { tells = \"computed\", head = \"computed\" },\n  { tells = \"tests\", head = \"Measured here|tests\" },",
            "",
        ),
        ("no formula", "2 * 10^3", "2 * 1e3"),
        ("formula with a name", "2 * 10^3", "2 * n"),
        ("law without an end", ", to = 1000, step = 3", ", step = 3"),
        ("law in another name", "3 / 8 * x", "3 / 8 * y"),
        ("law and point", "point = [\"8\", \"3\"]", "law = \"x\", point = [\"8\", \"3\"]"),
        ("point of one number", "point = [\"8\", \"3\"]", "point = [\"8\"]"),
        ("unknown scale", "scale = \"log\"", "scale = \"lgo\""),
        ("axis from nothing", "from = 1, to = 1000 }\ny", "from = 0, to = 1000 }\ny"),
        ("axis backwards", "from = 0, to = 400", "from = 400, to = 0"),
        ("no axis", "y = {", "z = {"),
        ("unknown structure", "kind = \"grid\" } },", "kind = \"gird\" } },"),
        ("unknown parameter", "kind = \"grid\" } },", "kind = \"grid\", max_depth = 3 } },"),
        ("unknown count", "title = \"Where\"", "title = \"Where\"\nof = \"test\""),
        ("no map", "maps = [", "mups = ["),
        ("unknown event", "{at=point}", "{at=pint}"),
        ("unknown field", "{{x}}", "{{t}}"),
        ("a number that is not there", "{{tests}} tests.", "{{total}} in all."),
        ("empty answer", "answer=\"all of them\"", "answer=\"\""),
        ("empty notes", "Three minutes.", ""),
        ("number without a name", "{ name = \"N\", note", "{ note"),
        ("number called as an axis", "name = \"N\"", "name = \"x\""),
        ("number called as a function", "name = \"N\"", "name = \"sin\""),
        ("number with a long name", "name = \"N\"", "name = \"Noooooooo\""),
        ("number that is there twice", "name = \"k\"", "name = \"N\""),
        ("number beyond its ends", "is = 80", "is = 8000"),
        ("number that runs backwards", "from = 8, to = 1000, is", "from = 1000, to = 8, is"),
        ("number of factors from 0", "from = 8, to = 1000, is", "from = 0, to = 1000, is"),
        ("number with an unknown scale", "is = 80, scale = \"log\"", "is = 80, scale = \"logs\""),
        ("formula with another number", "3 / 8 * N * k", "3 / 8 * M"),
        ("what follows from nothing", "3 / 8 * N * k", "3 / 8"),
        ("printed beside what moves", "2 * 10^3", "2 * N"),
        ("name with another number", "yours: {{y}} s", "yours: {{z}} s"),
        ("text with another number", "{{N}} objects take", "{{M}} objects take"),
        ("setting that cannot be", "set:N=8)", "set:N=7.5)"),
        ("setting of another number", "set:N=8)", "set:M=8)"),
        ("meter without numbers", "numbers = [", "nombers = ["),
        ("unknown key of a row", "note = \"usual\"", "noote = \"usual\""),
        ("packets of three", "note = \"usual\"", "lanes = 3"),
        ("packets through a grid", "note = \"usual\"", "lanes = 4"),
        ("unknown time", "tells = \"speed\"", "tells = \"sped\""),
        ("unknown way to run", "runs = \"threads\"", "runs = \"thread\""),
        ("another tree on a graphics card", "runs = \"threads\"", "runs = \"gpu\""),
        ("a textbook's structure on threads", "note = \"usual\"", "runs = \"threads\""),
        ("unknown instructions", "isa = \"portable\"", "isa = \"avx3\""),
        ("instructions for a textbook's structure", "note = \"usual\"", "isa = \"avx2\""),
        ("times of nothing", "fast = \"fast-bvh8\", isa", "fast = \"fast-bvh9\", isa"),
        ("a time where none is told", "{{row.speed}} became", "{{row.sped}} became"),
        ("timed or not", "timed=no", "timed=never"),
        ("a structure that follows no number", "min_objects = \"{{N}}\"", "min_objects = \"{{M}}\""),
        ("a structure that cannot follow so far", "min_objects = \"{{N}}\"", "max_depth = \"{{N}}\""),
        (
            "a line that moves",
            "{ name = \"linear\", law = \"3 / 8 * x\", from = 8, to = 1000,",
            "{ name = \"linear\", scenes = [\"teapot:1x1\", \"teapot:2x2\"], structure = { kind = \"kd\", max_depth = \"{{N}}\" },",
        ),
        (
            "seconds of another fast structure",
            "{ name = \"linear\", law = \"3 / 8 * x\", from = 8, to = 1000,",
            "{ name = \"linear\", scenes = [\"teapot:1x1\", \"teapot:2x2\"], of = \"seconds\", fast = \"fast-kd\",",
        ),
        ("unknown layout", "note = \"usual\"", "layout = \"plan\""),
        ("a layout of a grid", "note = \"usual\"", "layout = \"plain\""),
    ];
    let mut table = String::new();
    for (what, from, to) in mistakes {
        assert!(SLIDE.contains(from), "the good board has no {from:?}");
        let found = problems(&SLIDE.replacen(from, to, 1));
        assert!(!found.is_empty(), "{what} goes unnoticed");
        table += &format!("{what}\n{found}");
    }
    insta::assert_snapshot!(table);
}

#[test]
fn walks_side_by_side_go_on_in_step_and_are_told_apart() {
    assert_eq!(problems(WALKS), "");
    let library = library(WALKS);
    let slide = &library.slides[0];
    let stage = &slide.stages[0];
    let built = stage.build(slide.plays).unwrap();
    let mut told = String::new();
    for ray in &stage.rays {
        let play = built.play(Some(ray.ray), &slide.beats).unwrap();
        let Tape::Walks(walks) = &play.tape else { panic!("walks side by side") };
        // Nobody is ahead of the others by more than its own next step.
        assert!(walks.reached.is_sorted(), "{:?}", walks.reached);
        let done: Vec<usize> = walks.walks.iter().map(Tape::len).collect();
        assert_eq!(done.iter().sum::<usize>(), play.tape.len());
        told += &format!("{}: {done:?}\n", ray.name);
        for (beat, step) in slide.beats.iter().zip(&play.beats) {
            let Some(facts) = step.and_then(|step| Facts::at(&play, step)) else { continue };
            told += &format!("  {step:?} {:?}\n", facts.event());
            for fact in ["kd.count.test", "bsp.count.test", "count.test", "kd.plane.plane", "bsp.enter.t_near"] {
                told += &format!("     {fact} {:?}\n", facts.field(fact));
            }
            for choice in beat.ask.iter().flat_map(|ask| ask.choices(&play, step.unwrap())) {
                told += &format!("     {:?}{}\n", choice.label, if choice.right { ", right" } else { "" });
            }
        }
    }
    insta::assert_snapshot!(told);
}

#[test]
fn wrong_walks_side_by_side_are_told_what_is_wrong() {
    let mistakes = [
        ("one structure", ", { kind = \"bsp\" }]", "]"),
        ("none", "structures =", "structure ="),
        ("unknown structure", "{ kind = \"bsp\" }", "{ kind = \"bps\" }"),
        ("of another", "of=bsp", "of=bvh"),
        ("fact of another", "{{kd.count.test}}", "{{octree.count.test}}"),
        ("unknown event", "{{kd.count.test}}", "{{kd.count.tset}}"),
        ("least of nothing", "least=test", "least=tset"),
        ("answer that is none", "- bsp:", "- bvh:"),
        ("camera", "rays = [", "camera = { center = [4, 2], half_height = 3 }\nrays = ["),
    ];
    let mut table = String::new();
    for (what, from, to) in mistakes {
        assert!(WALKS.contains(from), "the good slide has no {from:?}");
        let found = problems(&WALKS.replacen(from, to, 1));
        assert!(!found.is_empty(), "{what} goes unnoticed");
        table += &format!("{what}\n{found}");
    }
    insta::assert_snapshot!(table);
}
