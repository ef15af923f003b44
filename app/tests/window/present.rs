//! The presenter's page: everything that is said and asked there is seen at once.

use egui::{Key, Rect, pos2};
use egui_kittest::kittest::{NodeT, Queryable};
use raystep::shown::command::Command;
use raystep::window::{App, Remembered, Wishes};
use raystep_lesson::{Slide, StageKind};

use crate::window::{Window, library, settle, sized, window};

/// The panes that may stand below space.
const PANES: [&str; 8] = ["t along the ray", "Tree", "Cells", "Pairs", "Slabs", "Bytes", "Walk", "Stack"];

/// How far texts and answers reach out of the room that they have.
fn out_of_room(harness: &Window, size: [f32; 2]) -> f32 {
    let body = (size[1] / 27.0).min(size[0] / 36.0);
    let below: Vec<Rect> =
        PANES.iter().filter_map(|name| harness.query_by_label(name)).map(|node| node.rect()).collect();
    let (right, foot) = (size[0] - body * 1.4, size[1] - body * 2.3);
    let roles = [egui::accesskit::Role::Label, egui::accesskit::Role::Button];
    let shown = roles.into_iter().flat_map(|role| harness.query_all_by_role(role));
    let words = shown.filter(|node| node.accesskit_node().label().as_deref() != Some("Back to the study page"));
    let out = words.map(|node| node.rect()).map(|words| {
        let beside = below.iter().filter(|pane| pane.right() > words.left() + 1.0);
        let floor = beside.map(Rect::top).fold(foot, f32::min);
        (words.bottom() - floor).max(words.right() - right - 1.0)
    });
    out.fold(0.0, f32::max)
}

#[test]
fn nothing_that_is_said_or_asked_is_cut_off() {
    let mut looked = 0;
    for size in [[1920.0, 1080.0], [1280.0, 720.0], [1024.0, 768.0], [3840.0, 2160.0]] {
        let mut harness: Window = sized(size).build_eframe(|context| {
            let mut app = App::wished(&context.egui_ctx, library(), Wishes::default(), Remembered::default());
            app.state.present = true;
            app
        });
        settle(&mut harness);
        let slides = harness.state().state.library.slides.clone();
        for (index, slide) in slides.iter().enumerate() {
            for stage in StageKind::ALL.into_iter().filter(|kind| slide.stage(*kind).is_some()) {
                let state = &mut harness.state_mut().state;
                state.show_slide(index);
                state.show_stage(stage);
                settle(&mut harness);
                let rays = slide.stage(stage).map_or(0, |stage| stage.rays.len());
                for ray in 0..rays.max(1) {
                    if rays > 0 {
                        harness.state_mut().state.show_ray(raystep::shown::RayChoice::Named(ray), false);
                        settle(&mut harness);
                    }
                    looked += look(&mut harness, size, &format!("{} {stage:?}, ray {ray}", slide.id()));
                }
            }
        }
    }
    println!("{looked} pages");
    assert!(looked > 5000);
}

/// Looks at every beat, and every question: open, with each wrong answer, and answered. Says how many pages there were.
fn look(harness: &mut Window, size: [f32; 2], what: &str) -> usize {
    let playback = harness.state().state.playback().expect("a walk").clone();
    let mut looked = 0;
    let mut check = |harness: &mut Window, what: &str| {
        loop {
            // Where the mouse is moved stand the buttons of what there is to do as well.
            harness.hover_at(pos2(2.0, 2.0 + (looked % 2) as f32));
            harness.run_steps(1);
            let out = out_of_room(harness, size);
            assert!(out <= 1.0, "{what} at {size:?}: {out} out of the room");
            looked += 1;
            let [at, many] = harness.state().pages();
            if at + 1 >= many {
                break;
            }
            harness.key_press(Key::PageDown);
            harness.run_steps(1);
            assert_eq!(harness.state().pages(), [at + 1, many], "{what}");
        }
    };
    for step in playback.play.beats.iter().flatten() {
        harness.state_mut().state.go(*step);
        check(harness, &format!("{what}, step {step}"));
    }
    for posed in &playback.posed {
        let open = |harness: &mut Window| {
            harness.state_mut().state.go(posed.before);
            if harness.state().state.question().is_none() {
                harness.state_mut().state.apply(Command::Onward);
            }
        };
        open(harness);
        check(harness, &format!("{what}, question before step {}", posed.step));
        for wrong in (0..posed.choices.len()).filter(|choice| !posed.choices[*choice].right) {
            open(harness);
            harness.state_mut().state.apply(Command::Answer(wrong as u8));
            check(harness, &format!("{what}, wrong answer {wrong} before step {}", posed.step));
            harness.state_mut().state.apply(Command::Onward);
            assert!(harness.state().state.is_settled());
            check(harness, &format!("{what}, answered {wrong} at step {}", posed.step));
        }
    }
    looked
}

/// What a question says to look at, and the panes that this is.
const SPOKEN_OF: [(&str, &str); 7] = [
    ("look at the tree", "Tree"),
    ("in the tree", "Tree"),
    ("on the stack", "Stack"),
    ("look at the listing", "Walk"),
    ("on the ruler", "t along the ray"),
    ("look at the table", "Cells"),
    ("the table shows when", "Cells"),
];

#[test]
fn a_question_speaks_of_panes_that_are_there() {
    let mut harness = window("5/33", [1280.0, 720.0]);
    harness.state_mut().state.apply(Command::Present);
    let slides = harness.state().state.library.slides.clone();
    let speaks = |slide: &Slide| {
        let asks = slide.beats.iter().filter_map(|beat| beat.ask.as_ref());
        asks.map(|ask| ask.question.to_lowercase()).any(|text| SPOKEN_OF.iter().any(|(words, _)| text.contains(words)))
    };
    let mut found = 0;
    for (index, slide) in slides.iter().enumerate().filter(|(_, slide)| speaks(slide)) {
        for stage in &slide.stages {
            harness.state_mut().state.show_slide(index);
            harness.state_mut().state.show_stage(stage.kind);
            settle(&mut harness);
            let playback = harness.state().state.playback().expect("a walk").clone();
            for posed in &playback.posed {
                let asked = slide.beats[posed.beat].ask.as_ref().map(|ask| ask.question.to_lowercase());
                harness.state_mut().state.go(posed.before);
                harness.state_mut().state.apply(Command::Onward);
                harness.run_steps(2);
                for (words, pane) in SPOKEN_OF {
                    if asked.as_ref().is_some_and(|text| text.contains(words)) {
                        assert!(harness.query_by_label(pane).is_some(), "{}: {words:?} and no {pane}", slide.id());
                        found += 1;
                    }
                }
            }
        }
    }
    assert!(found > 0);
}

#[test]
fn what_changed_stands_there_where_there_is_room() {
    let check = |slide: &str, size: [f32; 2]| {
        let wishes = Wishes { slide: Some(slide.to_owned()), ..Wishes::default() };
        let mut harness: Window = sized(size).build_eframe(|context| {
            let mut app = App::wished(&context.egui_ctx, library(), wishes, Remembered::default());
            app.state.present = true;
            app.state.predict = false;
            app
        });
        settle(&mut harness);
        let last = harness.state().state.playback().unwrap().steps().last();
        let mut shown = 0;
        for step in 1..=last {
            harness.state_mut().state.go(step);
            harness.run_steps(2);
            let Some(changed) = harness.query_by_label("Changed").map(|node| node.rect()) else { continue };
            shown += 1;
            for name in ["Stack", "Tree", "t along the ray", "Space", "Picture"] {
                if let Some(other) = harness.query_by_label(name) {
                    assert!(!changed.intersects(other.rect()), "{slide}, step {step}: {changed:?} covers {name}");
                }
            }
            assert!(changed.bottom() < size[1] && changed.height() > 40.0, "{slide}, step {step}: {changed:?}");
        }
        assert!(shown * 2 > last, "{slide} at {size:?}: shown at {shown} of {last} steps");
    };
    for size in [[1600.0, 900.0], [1920.0, 1080.0]] {
        for slide in ["2/13b", "3/20", "5/33", "5/30"] {
            check(slide, size);
        }
    }
}
