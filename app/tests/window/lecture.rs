//! Before a class: a clicker walks beat by beat, pages are covered, slides are found by number, and the class sees no
//! dialog.

use egui::{Event, Key, Modifiers, pos2};
use egui_kittest::kittest::Queryable;
use raystep::shown::command::Command;
use raystep::shown::{Cover, InHand};

use crate::window::{Window, press, settle, window};

const SIZE: [f32; 2] = [1280.0, 720.0];

/// A window before a class.
fn class(slide: &str) -> Window {
    let mut harness = window(slide, SIZE);
    press(&mut harness, Key::F5);
    assert!(harness.state().state.present);
    harness
}

fn id(harness: &Window) -> String {
    harness.state().state.slide().expect("a slide").id()
}

/// Presses a key and waits for what it calls for.
fn click(harness: &mut Window, key: Key) {
    press(harness, key);
    settle(harness);
    harness.run_steps(2);
}

#[test]
fn a_clicker_walks_through_all_beats_and_questions_and_back_to_where_one_was() {
    let mut harness = class("5/34");
    let playback = harness.state().state.playback().expect("a walk").clone();
    let (mut beats, mut questions, mut answers) = (Vec::new(), 0, 0);
    for _ in 0..200 {
        let state = &harness.state().state;
        if state.question().is_some() {
            questions += 1;
        } else if state.is_settled() {
            answers += 1;
        } else if playback.play.beats.contains(&Some(state.view.step)) && !beats.contains(&state.view.step) {
            beats.push(state.view.step);
        }
        let last = state.view.clone();
        click(&mut harness, Key::PageDown);
        if id(&harness) != "5/34" {
            let mut all: Vec<usize> = playback.play.beats.iter().flatten().copied().collect();
            all.sort_unstable();
            all.dedup();
            assert_eq!(beats, all, "every beat is heard");
            assert_eq!((questions, answers), (playback.posed.len(), playback.posed.len()));
            assert!(questions > 0);
            // Back over the edge: where one was, not at the beginning.
            click(&mut harness, Key::PageUp);
            assert_eq!(id(&harness), "5/34");
            assert_eq!(harness.state().state.view.step, last.step);
            return;
        }
    }
    panic!("the slide has no end");
}

#[test]
fn what_was_never_shown_is_entered_from_behind_at_its_last_beat() {
    let mut harness = class("5/34");
    click(&mut harness, Key::Home);
    click(&mut harness, Key::PageUp);
    assert_eq!(id(&harness), "5/33");
    let state = &harness.state().state;
    let last = state.playback().unwrap().play.beats.iter().flatten().max().copied();
    assert_eq!(Some(state.view.step), last);
}

#[test]
fn a_wrong_guess_and_the_right_answer_stay_until_one_goes_on() {
    let mut harness = class("5/33");
    let posed = harness.state().state.playback().unwrap().posed[0].clone();
    harness.state_mut().state.go(posed.before);
    press(&mut harness, Key::PageDown);
    assert!(harness.state().state.question().is_some(), "the beat is heard first, then it is asked");
    let wrong = posed.choices.iter().position(|choice| !choice.right).unwrap();
    // Letters do other things before a class.
    press(&mut harness, [Key::A, Key::B][wrong]);
    assert_eq!(harness.state().state.answered, None);
    harness.state_mut().state.lecture.cover = None;
    harness.key_press_modifiers(Modifiers::ALT, [Key::A, Key::B][wrong]);
    harness.run_steps(2);
    assert_eq!(harness.state().state.answered.map(|answered| answered.choice), Some(wrong));
    assert!(harness.query_by_label_contains(&format!("Answer {}, wrong", ["A", "B"][wrong])).is_some());
    press(&mut harness, Key::PageDown);
    assert_eq!(harness.state().state.view.step, posed.step);
    assert!(harness.query_by_label_contains(", right: ").is_some());
    assert!(harness.query_by_label_contains(", wrong: ").is_some(), "the wrong guess and its reason stay");
    press(&mut harness, Key::PageDown);
    assert!(harness.query_by_label_contains(", right: ").is_none());
    assert_eq!(harness.state().state.view.step, posed.step, "now the beat is heard");
}

#[test]
fn the_page_is_covered_and_uncovered() {
    let mut harness = class("5/33");
    let cover = |harness: &Window| harness.state().state.lecture.cover;
    let step = harness.state().state.view.step;
    for (key, covered) in [
        (Key::B, Some(Cover::Black)),
        (Key::B, None),
        (Key::Period, Some(Cover::Black)),
        (Key::W, Some(Cover::White)),
        (Key::PageDown, None),
        (Key::W, Some(Cover::White)),
        (Key::Escape, None),
    ] {
        press(&mut harness, key);
        assert_eq!(cover(&harness), covered, "{key:?}");
        assert_eq!(harness.query_by_label("Space").is_some(), covered.is_none());
    }
    assert_eq!(harness.state().state.view.step, step, "what uncovers the page goes no step");
    assert!(harness.state().state.present);
}

#[test]
fn a_slide_is_found_by_its_number() {
    let mut harness = class("1/1");
    let mut go = |keys: &[Key]| {
        for key in keys {
            press(&mut harness, *key);
        }
        click(&mut harness, Key::Enter);
        id(&harness)
    };
    assert_eq!(go(&[Key::Num3, Key::Num3]), "5/33");
    assert_eq!(go(&[Key::Num2, Key::Slash, Key::Num1, Key::Num4]), "2/14");
    assert_eq!(go(&[Key::Num3, Key::Num6]), "5/33", "a slide stands for 33 to 38");
    assert_eq!(go(&[Key::Num9, Key::Num9]), "5/33", "there is none");
    assert_eq!(go(&[Key::Num4, Key::Num0, Key::B]), "5/40b");
    assert_eq!(go(&[Key::Num3, Key::Num3]), "5/33");
    // What is half typed is forgotten by everything else.
    assert_eq!(go(&[Key::Num1, Key::Home, Key::Num2]), "1/2");
    // Also where all of it comes in one frame.
    for key in [Key::Num4, Key::Num0, Key::B, Key::Enter] {
        harness.key_press(key);
    }
    settle(&mut harness);
    assert_eq!(id(&harness), "5/40b");
    assert_eq!(harness.state().state.lecture.cover, None, "b is a letter here");
}

#[test]
fn a_class_sees_no_dialog_and_its_page_can_be_held() {
    let mut harness = class("5/33");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::K);
    harness.run_steps(2);
    press(&mut harness, Key::Questionmark);
    for text in ["Nothing of that name.", "In the study", "Find a command or slide"] {
        assert!(harness.query_by_label_contains(text).is_none(), "{text}");
    }
    press(&mut harness, Key::N);
    assert!(harness.query_by_label_contains("About 8 minutes").is_some());
    press(&mut harness, Key::N);
    let title = |harness: &Window| harness.query_by_label_contains("Where does the plane cut").is_some();
    assert!(title(&harness));
    press(&mut harness, Key::Z);
    click(&mut harness, Key::End);
    assert!(title(&harness), "the class goes on seeing what it saw");
    press(&mut harness, Key::Z);
    harness.run_steps(1);
    assert!(!title(&harness));
}

#[test]
fn a_stroke_of_the_pen_goes_with_its_step() {
    let mut harness = class("5/33");
    press(&mut harness, Key::P);
    assert_eq!(harness.state().state.lecture.in_hand, InHand::Pen);
    harness.hover_at(pos2(300.0, 300.0));
    harness.run_steps(2);
    harness.drag_at(pos2(300.0, 300.0));
    for x in [320.0, 360.0, 400.0] {
        harness.hover_at(pos2(x, 320.0));
        harness.run_steps(1);
    }
    harness.drop_at(pos2(400.0, 320.0));
    harness.run_steps(2);
    assert_eq!(harness.state().strokes(), 1);
    let step = harness.state().state.view.step;
    press(&mut harness, Key::ArrowRight);
    press(&mut harness, Key::ArrowRight);
    assert_ne!(harness.state().state.view.step, step);
    assert_eq!(harness.state().strokes(), 0);
    press(&mut harness, Key::L);
    assert_eq!(harness.state().state.lecture.in_hand, InHand::Pointer);
}

#[test]
fn a_quick_pen_draws_all_places_of_a_frame() {
    let mut harness = class("5/33");
    press(&mut harness, Key::P);
    harness.hover_at(pos2(300.0, 300.0));
    harness.run_steps(2);
    let button = |pressed, pos| Event::PointerButton {
        pos,
        button: egui::PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    };
    let events = &mut harness.input_mut().events;
    events.push(button(true, pos2(300.0, 300.0)));
    events.extend([310.0, 340.0, 350.0].map(|x| Event::PointerMoved(pos2(x, x))));
    events.push(button(false, pos2(360.0, 340.0)));
    harness.step();
    assert_eq!((harness.state().strokes(), harness.state().stroke_points()), (1, 5), "all of it lies in one frame");
}

#[test]
fn presses_that_pile_up_pass_nothing_by() {
    let mut harness = class("5/33");
    harness.state_mut().state.predict = false;
    let beats = harness.state().state.playback().expect("a walk").play.beats.clone();
    let pile = |harness: &mut Window| {
        for pressed in [true, false].repeat(3) {
            let key = Event::Key {
                key: Key::PageDown,
                physical_key: None,
                pressed,
                repeat: false,
                modifiers: Modifiers::NONE,
            };
            harness.input_mut().events.push(key);
        }
        harness.step();
    };
    let now = harness.state().state.view.step;
    let next = beats.iter().flatten().copied().filter(|step| *step > now).min();
    pile(&mut harness);
    assert_eq!(Some(harness.state().state.view.step), next, "one press of three goes on");
    // On the last beat they lead to the next slide, and not past its first page.
    let last = beats.iter().flatten().max().copied().unwrap();
    harness.state_mut().state.go(last);
    harness.step();
    pile(&mut harness);
    for _ in 0..400 {
        if id(&harness) == "5/34" {
            break;
        }
        harness.step();
    }
    let first = harness.state().state.view.step;
    pile(&mut harness);
    assert_eq!((id(&harness).as_str(), harness.state().state.view.step), ("5/34", first));
}

#[test]
fn a_mistake_that_is_played_is_told_on_the_wall() {
    let mut harness = class("5/33");
    let mistake = raystep_accel::Mistake::KdLeftFirst;
    harness.state_mut().state.show_example(mistake);
    settle(&mut harness);
    harness.run_steps(3);
    assert_eq!(harness.state().state.view.example, Some(mistake));
    for text in [mistake.title(), "A ray from the right meets the right child first"] {
        assert!(harness.query_all_by_label_contains(text).next().is_some(), "{text}");
    }
}

#[test]
fn rays_and_stages_turn_by_key_and_nothing_set_for_one_class_stays() {
    let mut harness = class("5/33");
    let ray = |harness: &Window| format!("{:?}", harness.state().state.view.ray);
    for (modifiers, wanted) in
        [(Modifiers::NONE, "Named(1)"), (Modifiers::NONE, "Named(2)"), (Modifiers::SHIFT, "Named(1)")]
    {
        harness.key_press_modifiers(modifiers, Key::Y);
        harness.run_steps(1);
        settle(&mut harness);
        assert_eq!(ray(&harness), wanted);
    }
    click(&mut harness, Key::V);
    assert_eq!(harness.state().state.view.stage, raystep_lesson::StageKind::Solid);
    press(&mut harness, Key::L);
    press(&mut harness, Key::F5);
    press(&mut harness, Key::F5);
    assert_eq!(harness.state().state.lecture, raystep::shown::Lecture::default());
}

#[test]
fn the_speaker_sees_the_answer_the_notes_and_what_comes() {
    let mut harness = window("5/33", [1600.0, 1000.0]);
    press(&mut harness, Key::F6);
    let posed = harness.state().state.playback().unwrap().posed[0].clone();
    harness.state_mut().state.go(posed.before);
    harness.state_mut().state.apply(Command::Onward);
    harness.run_steps(4);
    assert!(harness.state().state.present && harness.state().state.question().is_some());
    for text in ["Right answer, only you see it", "Near is left", "The order of the children"] {
        assert!(harness.query_all_by_label_contains(text).next().is_some(), "{text}");
    }
    for name in ["Black page", "Pen", "Next ray", "Step", "Larger notes", "Five minutes more"] {
        assert!(harness.query_all_by_label(name).next().is_some(), "{name}");
    }
    press(&mut harness, Key::F6);
    harness.run_steps(2);
    assert!(harness.query_by_label_contains("only you see it").is_none());
    assert!(harness.state().state.present);
}

#[test]
fn what_there_is_to_do_stands_on_the_wall_only_while_the_mouse_is_moved() {
    let mut harness = class("3/18");
    harness.state_mut().state.predict = false;
    click(&mut harness, Key::End);
    let button = |harness: &Window| harness.query_by_label("Build without the second look").map(|node| node.rect());
    assert_eq!(button(&harness), None, "nobody in a class presses it");
    harness.hover_at(pos2(300.0, 300.0));
    harness.run_steps(2);
    let there = button(&harness).expect("a hand that moves the mouse may press it");
    // It rests: then nothing shows it any more.
    harness.event(Event::PointerGone);
    harness.run_steps(2);
    assert_eq!(button(&harness), None, "a mouse that lies still shows nothing");
    harness.hover_at(pos2(302.0, 300.0));
    harness.run_steps(2);
    assert_eq!(button(&harness), Some(there), "nothing has moved");
}
