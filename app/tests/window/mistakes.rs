//! A mistake beside the right walk, and the ray that shows it.

use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;
use raystep::shown::{Beside, RayChoice};

use crate::window::{press, settle, window};

#[test]
fn a_ray_of_ones_own_that_shows_no_mistake_is_not_taken_away_without_a_word() {
    let mut harness = window("5/33", [1280.0, 800.0]);
    let own = raystep_accel::Ray::new([0.1, 1.2, 0.0].into(), [1.0, 0.1, 0.0].into()).unwrap();
    harness.state_mut().state.show_ray(RayChoice::Own(own), false);
    settle(&mut harness);
    press(&mut harness, Key::M);
    settle(&mut harness);
    harness.run_steps(3);
    assert!(matches!(harness.state().state.view.ray, RayChoice::Named(_)));
    assert!(harness.query_by_label_contains("Your own ray does not show it").is_some());
    // Nothing broken any more: back to where one was.
    press(&mut harness, Key::M);
    settle(&mut harness);
    assert_eq!(harness.state().state.view.ray, RayChoice::Own(own));
    // As if one had not been away: undo leads to what came before that.
    for (keys, there) in
        [(Modifiers::COMMAND, RayChoice::Named(0)), (Modifiers::COMMAND | Modifiers::SHIFT, RayChoice::Own(own))]
    {
        harness.key_press_modifiers(keys, Key::Z);
        harness.run_steps(1);
        settle(&mut harness);
        assert_eq!(harness.state().state.view.ray, there);
    }
    press(&mut harness, Key::M);
    settle(&mut harness);
    harness.run_steps(3);
    assert!(matches!(harness.state().state.view.ray, RayChoice::Named(_)));
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    harness.run_steps(1);
    settle(&mut harness);
    assert_eq!(harness.state().state.view.ray, RayChoice::Own(own));
}

#[test]
fn a_mistake_is_played_on_a_ray_that_shows_it() {
    for slide in ["2/13b", "3/20", "5/33", "7/56b"] {
        let mut harness = window(slide, [1600.0, 1000.0]);
        let mistakes = harness.state().state.playback().unwrap().mistakes.len();
        assert!(mistakes > 0, "{slide}");
        harness.state_mut().state.beside = Beside::Mistake(mistakes - 1);
        settle(&mut harness);
        harness.run_steps(2);
        assert!(harness.query_by_label("Space, beside").is_some(), "{slide}");
    }
}
