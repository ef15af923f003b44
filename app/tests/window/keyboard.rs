//! The window without a screen: every slide walked by keyboard, and what undo, predict and the palette do.

use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;
use raystep::shown::{Beside, RayChoice};
use raystep::window::{App, Remembered, Wishes};
use raystep_accel::Grain;
use raystep_lesson::StageKind;

use crate::window::{Window, library, press, settle, sized, window};

#[test]
fn every_slide_is_walked_by_keyboard_and_back() {
    let mut harness = window("1/1", [1600.0, 1000.0]);
    let slides = harness.state().state.library.slides.len();
    harness.state_mut().state.predict = false;
    harness.state_mut().state.grain = Grain::Visit;
    for slide in 0..slides {
        if slide > 0 {
            press(&mut harness, Key::PageDown);
            settle(&mut harness);
        }
        assert_eq!(harness.state().state.view.slide, slide);
        let last = harness.state().state.playback().unwrap().steps().last();
        press(&mut harness, Key::Home);
        let first_page = harness.state().state.view.clone();
        assert_eq!(first_page.step, 0);
        let mut forth = vec![0];
        while harness.state().state.view.step < last {
            press(&mut harness, Key::ArrowRight);
            let step = harness.state().state.view.step;
            assert!(step > *forth.last().unwrap(), "slide {slide} stands still at {step}");
            forth.push(step);
        }
        let mut back = vec![last];
        while harness.state().state.view.step > 0 {
            press(&mut harness, Key::ArrowLeft);
            back.push(harness.state().state.view.step);
        }
        back.reverse();
        assert_eq!(forth, back, "slide {slide}");
        assert!(harness.state().state.view.same_walk(&first_page));
        press(&mut harness, Key::End);
        assert_eq!(harness.state().state.view.step, last);
    }
}

#[test]
fn every_control_has_a_name() {
    for size in [[1600.0, 1000.0], [1280.0, 800.0], [1024.0, 768.0]] {
        for slide in ["2/13a", "3/20", "5/33", "7/56"] {
            let mut harness = window(slide, size);
            harness.run_steps(2);
            harness.check_accessibility();
        }
    }
}

#[test]
fn nothing_is_cut_off_in_a_small_window() {
    let harness = window("5/33", [1024.0, 768.0]);
    for name in ["Export", "Present", "Predict", "Compare", "Flat", "Solid", "More", "Next step", "Timeline", "Walk"] {
        for node in harness.query_all_by_label(name) {
            let rect = node.rect();
            assert!(rect.left() >= 0.0 && rect.right() <= 1024.5 && rect.bottom() <= 768.5, "{name} lies at {rect:?}");
        }
    }
}

#[test]
fn a_beat_is_heard_before_the_question_behind_it() {
    let mut harness = window("5/33", [1600.0, 1000.0]);
    let playback = harness.state().state.playback().unwrap().clone();
    let speaks = |step| playback.play.beats.contains(&Some(step));
    let posed = playback.posed.iter().find(|posed| speaks(posed.before)).expect("a question right behind a beat");
    press(&mut harness, Key::Home);
    while harness.state().state.view.step < posed.before {
        press(&mut harness, Key::ArrowRight);
        if harness.state().state.question().is_some() && harness.state().state.view.step < posed.before {
            press(&mut harness, Key::Enter);
        }
    }
    let asks = |harness: &Window| (harness.state().state.view.step, harness.state().state.question().is_some());
    assert_eq!(asks(&harness), (posed.before, false), "first what is said at this step");
    press(&mut harness, Key::ArrowRight);
    assert_eq!(asks(&harness), (posed.before, true), "then the question");
    press(&mut harness, Key::ArrowLeft);
    assert_eq!(asks(&harness), (posed.before, false), "and back");
    press(&mut harness, Key::ArrowRight);
    press(&mut harness, Key::ArrowRight);
    assert_eq!(asks(&harness).0, posed.step);
}

#[test]
fn stepping_stops_at_every_beat_of_every_slide() {
    let library = library();
    for slide in library.slides.iter().map(raystep_lesson::Slide::id) {
        let mut harness = window(slide.as_str(), [1600.0, 1000.0]);
        harness.state_mut().state.predict = false;
        harness.state_mut().state.grain = Grain::Visit;
        press(&mut harness, Key::Home);
        let playback = harness.state().state.playback().unwrap().clone();
        let mut stood = vec![0];
        while *stood.last().unwrap() < playback.steps().last() {
            press(&mut harness, Key::ArrowRight);
            stood.push(harness.state().state.view.step);
        }
        for beat in playback.play.beats.iter().flatten() {
            assert!(stood.contains(beat), "slide {slide} jumps over the beat at step {beat}");
        }
    }
}

#[test]
fn playing_follows_the_clock_however_long_a_frame_takes() {
    let mut harness = window("5/33", [1600.0, 1000.0]);
    let state = &mut harness.state_mut().state;
    state.predict = false;
    state.go(0);
    for (speed, seconds, steps) in [(4, 1.0, 3), (4, 20.0, 3), (1, 1.0, 0), (1, 4.0, 3), (36, 0.11, 3)] {
        state.go(0);
        state.speed = speed;
        state.playing = false;
        state.apply(raystep::shown::command::Command::Play);
        let mut stood = Vec::new();
        for _ in 0..3 {
            let before = state.view.step;
            state.tick(seconds);
            stood.extend((state.view.step != before).then_some(state.view.step));
        }
        assert_eq!(stood.len(), steps, "speed {speed}, {seconds} s a frame");
    }
}

#[test]
fn a_question_is_asked_before_its_step_and_answered_by_key() {
    let mut harness = window("5/33", [1600.0, 1000.0]);
    let posed = harness.state().state.playback().unwrap().posed[0].clone();
    press(&mut harness, Key::Home);
    while harness.state().state.question().is_none() {
        press(&mut harness, Key::ArrowRight);
    }
    assert_eq!(harness.state().state.view.step, posed.before);
    let right = posed.choices.iter().position(|choice| choice.right).unwrap();
    let keys = [Key::A, Key::B, Key::C, Key::D];
    press(&mut harness, keys[(right + 1) % posed.choices.len()]);
    assert_eq!(harness.state().state.view.step, posed.before, "a wrong guess does not go on");
    assert!(harness.state().state.answered.is_some_and(|answered| !answered.right));
    press(&mut harness, keys[right]);
    assert_eq!(harness.state().state.view.step, posed.step);
    assert!(harness.state().state.settled().is_some());
}

#[test]
fn changes_are_undone_and_backspace_restores_the_slide() {
    let mut harness = window("5/33", [1600.0, 1000.0]);
    let own = harness.state().state.view.clone();
    harness.state_mut().state.keep();
    harness.state_mut().state.set("max_depth", "1");
    settle(&mut harness);
    assert!(!harness.state().state.view.same_walk(&own));
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    settle(&mut harness);
    assert!(harness.state().state.view.same_walk(&own));
    harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    settle(&mut harness);
    assert!(!harness.state().state.view.same_walk(&own));
    press(&mut harness, Key::Backspace);
    settle(&mut harness);
    assert!(harness.state().state.view.same_walk(&own));
}

/// Clicks what has this name and is no mere text.
#[test]
fn a_slide_that_was_left_before_it_was_there_is_undone_to_where_it_opens() {
    let mut harness = window("5/33", [1280.0, 800.0]);
    harness.key_press(Key::PageDown);
    harness.key_press(Key::PageDown);
    harness.run_steps(1);
    settle(&mut harness);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    harness.run_steps(1);
    settle(&mut harness);
    let state = &harness.state().state;
    assert_eq!(state.slide().unwrap().id(), "5/34");
    assert_eq!(state.view.step, state.playback().unwrap().opening(state.predict));
}

#[test]
fn the_palette_finds_a_slide() {
    let mut harness = window("1/1", [1280.0, 800.0]);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::K);
    harness.run_steps(2);
    harness.event(egui::Event::Text("which child".to_owned()));
    harness.run_steps(2);
    press(&mut harness, Key::Enter);
    settle(&mut harness);
    assert_eq!(harness.state().state.slide().unwrap().id(), "5/33");
}

#[test]
fn the_page_of_keys_fits_a_small_window() {
    let mut harness = window("5/33", [1024.0, 768.0]);
    press(&mut harness, Key::Questionmark);
    harness.run_steps(3);
    for name in ["Answer the open question", "Redo", "comes nearer; stretches the ruler of t", "Close"] {
        let rect = harness.get_by_label(name).rect();
        assert!(rect.top() >= 0.0 && rect.bottom() <= 768.0 && rect.right() <= 1024.0, "{name} lies at {rect:?}");
    }
    press(&mut harness, Key::Escape);
    harness.run_steps(2);
    assert!(harness.query_by_label("comes nearer; stretches the ruler of t").is_none());
}

#[test]
fn while_something_is_made_the_page_stays_and_can_be_walked() {
    let mut harness = window("5/33", [1600.0, 1000.0]);
    let before = harness.state().state.view.clone();
    // So large a scene is not there in the next frame.
    let mesh = std::sync::Arc::new(raystep_scene::Scene::named("teapot:60x60").unwrap());
    let ray = raystep_accel::Ray::new(glam::Vec3::new(-6.0, -3.0, 3.6), glam::Vec3::new(6.1, 2.7, -2.0)).unwrap();
    harness.state_mut().state.show_mesh(mesh, ray);
    harness.run_steps(1);
    assert!(!harness.state().state.is_current());
    assert!(harness.state().state.view.same_page(&before));
    press(&mut harness, Key::Home);
    assert_eq!(harness.state().state.view.step, 0);
    // Wanting what is shown gives up the rest, and nothing is left to be undone.
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    harness.run_steps(2);
    assert!(harness.state().state.is_current());
    assert!(harness.state().state.view.same_page(&before));
}

#[test]
fn slides_open_on_the_stage_that_they_say_and_else_on_the_one_that_was_asked_for() {
    use StageKind::{Flat, Solid};
    let mut harness = window("5/37", [1280.0, 800.0]);
    let shown = |harness: &Window| {
        let state = &harness.state().state;
        (state.slide().unwrap().numbers[0].clone(), state.stage().unwrap().kind)
    };
    let turned = |harness: &mut Window, key| {
        press(harness, key);
        settle(harness);
        shown(harness)
    };
    assert_eq!(shown(&harness), ("37".to_owned(), Flat));
    assert_eq!(turned(&mut harness, Key::PageDown), ("39".to_owned(), Solid));
    assert_eq!(turned(&mut harness, Key::PageDown), ("40".to_owned(), Flat));
    harness.state_mut().state.show_stage(Solid);
    settle(&mut harness);
    assert_eq!(turned(&mut harness, Key::PageUp), ("39".to_owned(), Solid));
    assert_eq!(turned(&mut harness, Key::PageUp), ("37".to_owned(), Solid));
    assert_eq!(turned(&mut harness, Key::PageDown), ("39".to_owned(), Solid));
    // What was asked for stays when the slide's own ray and view come back.
    harness.state_mut().state.show_stage(Flat);
    settle(&mut harness);
    assert_eq!(turned(&mut harness, Key::Backspace), ("39".to_owned(), Flat));

    // A ray that was named is shown where it walks.
    let named = |slide: &str, ray: &str| {
        let wishes = Wishes { slide: Some(slide.to_owned()), ray: Some(ray.to_owned()), ..Wishes::default() };
        let mut harness = sized([1280.0, 800.0])
            .build_eframe(|context| App::wished(&context.egui_ctx, library(), wishes, Remembered::default()));
        settle(&mut harness);
        let state = &harness.state().state;
        (state.stage().unwrap().kind, state.view.ray.clone())
    };
    assert_eq!(named("5/39", "through the lid"), (Flat, RayChoice::Named(1)));
    assert_eq!(named("5/39", "over the floor"), (Solid, RayChoice::Named(1)));
    assert_eq!(named("5/37", "down onto the floor"), (Solid, RayChoice::Named(1)));
    assert_eq!(named("5/39", "nobody"), (Solid, RayChoice::Named(0)));
}

#[test]
fn what_a_text_offers_is_done_by_its_button() {
    let offered = |slide: &str, words: &str| {
        let mut harness = window(slide, [1600.0, 1000.0]);
        harness.state_mut().state.predict = false;
        press(&mut harness, Key::End);
        harness.run_steps(2);
        harness.get_by_label(words).click();
        harness.run_steps(2);
        settle(&mut harness);
        harness
    };
    // Another parameter; undo takes it back.
    let mut harness = offered("3/18", "Build without the second look");
    let prunes = |harness: &Window| {
        let parameters = harness.state().state.playback().unwrap().rule.parameters();
        parameters.into_iter().find(|parameter| parameter.key == "prune").unwrap().value
    };
    assert_eq!(prunes(&harness), "false");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    settle(&mut harness);
    assert_eq!(prunes(&harness), "true");
    // A structure beside.
    let harness = offered("5/40", "Set a grid beside the tree");
    assert_eq!(harness.state().state.beside, Beside::Structure("grid"));
    // Another slide.
    let harness = offered("7/56b", "Slide 56, the same rays as printed");
    assert_eq!(harness.state().state.slide().unwrap().id(), "7/56");
}
