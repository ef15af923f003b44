//! How space and the ruler are looked at: levels of boxes and a stretched ruler, by key and mouse, and undone.

use egui::{Key, Modifiers, vec2};
use egui_kittest::kittest::Queryable;
use raystep::shown::command::Command;
use raystep_figure::Depth;

use crate::window::{self, Window, press, settle};

fn window(slide: &str) -> Window {
    window::window(slide, [1600.0, 1000.0])
}

fn undo(harness: &mut Window) {
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    harness.run_steps(2);
}

fn depth(harness: &Window) -> Depth {
    harness.state().state.depth()
}

#[test]
fn levels_of_boxes_follow_keys_and_undo() {
    let mut harness = window("5/33");
    harness.state_mut().state.apply(Command::Solid);
    settle(&mut harness);
    assert_eq!(depth(&harness), Depth::Path);
    for level in 1..=3 {
        press(&mut harness, Key::Plus);
        assert_eq!(depth(&harness), Depth::Down(level));
    }
    press(&mut harness, Key::Minus);
    assert_eq!(depth(&harness), Depth::Down(2));
    undo(&mut harness);
    assert_eq!(depth(&harness), Depth::Down(3));
    for level in [2, 1] {
        undo(&mut harness);
        assert_eq!(depth(&harness), Depth::Down(level));
    }
    undo(&mut harness);
    assert_eq!(depth(&harness), Depth::Path);
    // Above the first level there is the path alone, and nothing above that.
    press(&mut harness, Key::Minus);
    assert_eq!(depth(&harness), Depth::Path);
    // Backspace looks again as the slide does.
    press(&mut harness, Key::Plus);
    press(&mut harness, Key::Backspace);
    assert_eq!((depth(&harness), harness.state().state.view.depth), (Depth::Path, None));
}

#[test]
fn levels_of_boxes_follow_the_slider() {
    let mut harness = window("5/33");
    assert!(harness.query_by_label("Boxes down to level").is_none(), "a flat picture shows them all");
    harness.state_mut().state.apply(Command::Solid);
    settle(&mut harness);
    harness.get_by_label("Boxes down to level").focus();
    harness.run_steps(2);
    press(&mut harness, Key::ArrowRight);
    press(&mut harness, Key::ArrowRight);
    assert_eq!(depth(&harness), Depth::Down(2));
    harness.get_by_label("path only").click();
    harness.run_steps(3);
    assert_eq!(depth(&harness), Depth::Path);
    undo(&mut harness);
    assert_eq!(depth(&harness), Depth::Down(2));
}

#[test]
fn the_wheel_stretches_the_ruler_and_a_key_shows_all_of_it() {
    let mut harness = window("5/33");
    let ruler = harness.get_by_label("t along the ray").rect();
    harness.hover_at(ruler.center());
    harness.run_steps(2);
    let part = |harness: &Window| harness.state().state.view.part;
    assert_eq!(part(&harness), None);
    let step = harness.state().state.view.step;
    for _ in 0..3 {
        harness.event(egui::Event::MouseWheel {
            unit: egui::MouseWheelUnit::Point,
            delta: vec2(0.0, 120.0),
            phase: egui::TouchPhase::Move,
            source: egui::MouseWheelSource::Unknown,
            modifiers: Modifiers::NONE,
        });
        harness.run_steps(12);
    }
    let stretched = part(&harness).expect("a part of the ray");
    assert!(stretched.far - stretched.near < 6.0, "{stretched:?}");
    // A drag shifts it.
    harness.drag_at(ruler.center());
    harness.run_steps(1);
    harness.hover_at(ruler.center() + vec2(-60.0, 0.0));
    harness.run_steps(2);
    harness.drop_at(ruler.center() + vec2(-60.0, 0.0));
    harness.run_steps(2);
    let shifted = part(&harness).expect("still a part");
    assert!(shifted.near > stretched.near, "{stretched:?}, then {shifted:?}");
    undo(&mut harness);
    assert_eq!(part(&harness), Some(stretched));
    press(&mut harness, Key::T);
    assert_eq!(part(&harness), None);
    undo(&mut harness);
    assert_eq!(part(&harness), Some(stretched));
    undo(&mut harness);
    assert_eq!((part(&harness), harness.state().state.view.step), (None, step), "the wheel is undone in one");
}
