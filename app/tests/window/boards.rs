//! Boards in the window: the page stands before anything on it is measured, then it is filled entry by entry, coarsely
//! first, and nothing moves.

use std::collections::HashMap;
use std::sync::Arc;

use egui::Key;
use egui_kittest::kittest::Queryable;
use glam::Vec2;
use raystep::shown::Playback;
use raystep_figure::{Ask, Figure, Ink, Look, Pane};
use raystep_lesson::{BoardTape, Care, Entry, Plays, Tape};

use crate::window::{Window, library, press, until, window};

const SIZE: [f32; 2] = [1180.0, 760.0];

fn playback(harness: &Window) -> Arc<Playback> {
    harness.state().state.playback().expect("something is shown").clone()
}

fn board(playback: &Playback) -> &Arc<BoardTape> {
    match &playback.play.tape {
        Tape::Board(filled) => filled,
        _ => panic!("no board"),
    }
}

/// The place of a slide.
fn place(id: &str) -> usize {
    library().slides.iter().position(|slide| slide.id() == id).expect("a slide")
}

/// Goes to a slide, up to the first frame in which it stands.
fn open(harness: &mut Window, slide: usize) {
    harness.state_mut().state.show_slide(slide);
    for _ in 0..2000 {
        harness.step();
        let state = &harness.state().state;
        if state.view.slide == slide && state.is_current() {
            return;
        }
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    panic!("the slide does not come");
}

/// What is made of a board from the first frame on, in the order in which it comes.
fn fillings(harness: &mut Window) -> Vec<Arc<Playback>> {
    let mut all = vec![playback(harness)];
    for _ in 0..20_000 {
        harness.step();
        let now = playback(harness);
        if !Arc::ptr_eq(&now, all.last().expect("the first one")) {
            all.push(now);
        }
        if harness.state().is_idle() {
            return all;
        }
        std::thread::sleep(std::time::Duration::from_millis(2));
    }
    panic!("the measuring has no end");
}

#[test]
fn the_first_picture_of_every_board_stands_before_anything_is_traced_or_measured() {
    let mut harness = window("5/33", SIZE);
    let boards: Vec<usize> = library()
        .slides
        .iter()
        .enumerate()
        .filter(|(_, slide)| slide.plays == Plays::Board)
        .map(|(at, _)| at)
        .collect();
    assert!(boards.len() >= 20);
    let mut waits = 0;
    for slide in boards {
        open(&mut harness, slide);
        let shown = playback(&harness);
        let filled = board(&shown);
        let id = &library().slides[slide].id();
        for (entry, at) in filled.places.iter().enumerate() {
            if filled.care_of(entry) == Care::Bare {
                waits += 1;
            } else {
                // Pictures that another test made in full stand.
                let known = matches!(filled.board.entry(*at), Some(Entry::Picture(_)));
                assert!(known || filled.rendered[entry].is_none(), "{id}: {entry}");
            }
            assert!(filled.measured[entry].is_none() && filled.counted[entry].is_none(), "{id}: {entry}");
            assert!(filled.appraised[entry].is_none() && filled.timed[entry].is_none(), "{id}: {entry}");
            assert!(filled.grown[entry].is_empty(), "{id}: {entry}");
        }
    }
    assert!(waits > 40, "{waits} entries of all boards are measured");
}

/// The texts that a figure has once, with where they stand and how large they are.
fn texts(playback: &Playback, step: usize) -> HashMap<String, [i32; 3]> {
    let figure = drawn(playback, step);
    let mut texts: HashMap<String, Vec<[i32; 3]>> = HashMap::new();
    for mark in &figure.marks {
        if let Ink::Text { at, text, size, .. } = &mark.ink {
            let at = [at.x, at.y, *size * 10.0].map(|along| along.round() as i32);
            texts.entry(text.clone()).or_default().push(at);
        }
    }
    let once = texts.into_iter().filter(|(_, places)| places.len() == 1);
    once.map(|(text, places)| (text, places[0])).collect()
}

fn drawn(playback: &Playback, step: usize) -> Figure {
    let reel = playback.reel();
    let at = reel.at(step);
    reel.still(&at).draw(Pane::Picture, &Ask::new(Vec2::new(1000.0, 640.0), Look::WINDOW))
}

/// What is written.
fn words(figure: &Figure) -> String {
    let texts = figure.marks.iter().filter_map(|mark| match &mark.ink {
        Ink::Text { text, .. } => Some(text.as_str()),
        _ => None,
    });
    texts.collect::<Vec<_>>().join("|")
}

#[test]
fn a_board_is_filled_entry_by_entry_coarsely_first_and_nothing_moves() {
    // A table, a table beside a chart or maps, and pictures.
    for id in ["8/58", "3/22", "5/42", "6/47"] {
        let mut harness = window("5/33", SIZE);
        open(&mut harness, place(id));
        let all = fillings(&mut harness);
        let cares = |filled: &BoardTape| (0..filled.places.len()).map(|at| filled.care_of(at)).collect::<Vec<_>>();
        for pair in all.windows(2) {
            let (before, after) = (cares(board(&pair[0])), cares(board(&pair[1])));
            let changed: Vec<usize> = (0..before.len()).filter(|at| before[*at] != after[*at]).collect();
            assert!(changed.len() <= 1, "{id}: one after the other: {changed:?}");
            for at in changed {
                assert!(
                    before[..at].iter().all(|care| *care > before[at]),
                    "{id}: in the order in which they are seen"
                );
                let coarse = before.iter().all(|care| *care > Care::Bare);
                assert!(
                    after[at] < Care::Full || coarse || before[at] == Care::Bare,
                    "{id}: all of them coarsely first"
                );
            }
        }
        let (first, last) = (&all[0], &all[all.len() - 1]);
        assert!(board(last).is_finished() && !last.is_draft(), "{id}");
        let step = last.steps().last();
        let (before, after) = (texts(first, step), texts(last, step));
        let stays: Vec<&String> = before.keys().filter(|text| after.contains_key(*text)).collect();
        assert!(stays.len() > 2, "{id}: {stays:?}");
        for text in stays {
            assert_eq!(before[text], after[text], "{id}: {text} moves");
        }
        for playback in [first, last] {
            assert!(!words(&drawn(playback, step)).contains('\u{2248}'), "{id}");
        }
        let signs = ["\u{2026}", "not traced yet", "not counted yet"];
        let waits = |playback: &Playback| signs.iter().any(|sign| words(&drawn(playback, step)).contains(sign));
        assert!(waits(first) && !waits(last), "{id}");
        let rough = all.iter().filter(|playback| words(&drawn(playback, step)).contains('\u{2248}')).count();
        // Volumes are known without a ray.
        assert_eq!(rough > 0, id != "6/47", "{id}");
    }
}

#[test]
fn measuring_says_how_far_it_is_and_can_be_given_up() {
    let mut harness = window("5/33", SIZE);
    open(&mut harness, place("5/41"));
    harness.step();
    assert!(harness.query_by_label_contains("Measuring with").is_some());
    press(&mut harness, Key::Escape);
    until(&mut harness, |window| window.state().is_idle());
    let left = playback(&harness);
    assert!(left.is_draft());
    harness.run_steps(5);
    assert!(harness.query_by_label_contains("Measuring with").is_none());
    assert!(Arc::ptr_eq(&left, &playback(&harness)), "nothing comes any more");
    // What is newly asked for goes first, and what was left goes on when one is back.
    open(&mut harness, place("5/33"));
    open(&mut harness, place("5/41"));
    assert_eq!(board(&playback(&harness)).fineness(), board(&left).fineness(), "what was measured stands");
    until(&mut harness, |window| board(&playback(window)).fineness() > board(&left).fineness());
}

#[test]
fn texts_say_what_waits_and_what_few_rays_tell() {
    let mut harness = window("5/33", SIZE);
    open(&mut harness, place("8/58"));
    let says = |harness: &Window, sign: &str| harness.query_all_by_label_contains(sign).next().is_some();
    assert!(says(&harness, "\u{2026} tests a ray"), "the sentence has its room");
    until(&mut harness, |window| board(&playback(window)).care() >= Care::Draft || window.state().is_idle());
    until(&mut harness, |window| window.state().is_idle());
    assert!(!says(&harness, "\u{2026} tests a ray") && !says(&harness, "\u{2248}"));
}
