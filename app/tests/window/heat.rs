//! Heat maps in the window: of any solid slide by a key, of boards, and the way from a pixel into its ray's walk; all
//! structures measured, and several beside the walk.

use std::sync::Arc;
use std::time::Instant;

use egui::{Key, Pos2, pos2};
use egui_kittest::kittest::Queryable;
use glam::Vec2;
use raystep::shown::{Beside, RayChoice, Rivals};
use raystep_figure::{Ask, Figure, Ink, Look, Pane, Pixel};
use raystep_lesson::{Column, Plays, StageKind, Tape};

use crate::window::{self, Window, press, until};

fn window(slide: &str) -> Window {
    let mut harness = window::window(slide, [1180.0, 760.0]);
    settle(&mut harness);
    harness
}

/// Runs frames until everything that is asked for is there, and nothing is measured with more rays.
fn settle(harness: &mut Window) {
    until(harness, |window| window.state().state.is_current() && window.state().is_idle());
}

fn click(harness: &mut Window, at: Pos2) {
    harness.hover_at(at);
    harness.run_steps(2);
    for pressed in [true, false] {
        let button = egui::PointerButton::Primary;
        harness.event(egui::Event::PointerButton { pos: at, button, pressed, modifiers: egui::Modifiers::NONE });
        harness.run_steps(1);
    }
    harness.run_steps(2);
}

fn solid(slide: &str) -> Window {
    let mut harness = window(slide);
    harness.state_mut().state.show_stage(StageKind::Solid);
    settle(&mut harness);
    harness
}

#[test]
fn a_key_shows_what_each_ray_costs_and_a_click_steps_it() {
    for slide in ["5/33", "7/56b", "3/20"] {
        let mut harness = solid(slide);
        press(&mut harness, Key::H);
        assert_eq!(harness.state().state.heat(), Some(Column::Tests), "{slide}");
        settle(&mut harness);
        assert_eq!(harness.state().heat_pixel(), Some(1), "{slide}: as fine as the window");
        let map = harness.get_by_label("Each ray and its cost").rect();
        click(&mut harness, map.lerp_inside(egui::vec2(0.4, 0.5)));
        let probed = harness.state().stepped().expect("a pixel was clicked");
        settle(&mut harness);
        let state = &harness.state().state;
        assert_eq!(state.heat(), None, "{slide}: the walk is seen");
        let (RayChoice::Own(ray), Some(playback)) = (&state.view.ray, state.playback()) else { panic!("{slide}") };
        assert_eq!(*ray, probed.0, "{slide}");
        let last = playback.steps().last();
        assert_eq!(playback.tests(last), u64::from(probed.1), "{slide}: the pixel said what the walk costs");
        press(&mut harness, Key::H);
        assert!(harness.state().state.heat().is_some());
        press(&mut harness, Key::H);
        assert!(harness.state().state.heat().is_none(), "the same key leads back");
    }
}

#[test]
fn a_structure_at_full_speed_stands_beside_the_map() {
    let mut harness = solid("5/33");
    press(&mut harness, Key::H);
    settle(&mut harness);
    for (choice, shown) in [("Fast BVH8", vec!["kd-tree", "Fast BVH8"]), ("none at full speed", vec!["kd-tree"])] {
        harness.get_by_label("At full speed beside it").click();
        harness.run_steps(3);
        harness.get_by_label(choice).click();
        harness.run_steps(3);
        settle(&mut harness);
        assert_eq!(harness.state().heat_names(), shown);
        assert_eq!(harness.state().heat_pixel(), Some(1), "as fine as the window");
    }
}

#[test]
fn a_heat_map_ends_where_something_else_is_looked_at() {
    let mut harness = solid("5/33");
    for key in [Key::ArrowRight, Key::ArrowLeft, Key::PageDown, Key::Backspace] {
        press(&mut harness, Key::H);
        assert!(harness.state().state.heat().is_some(), "before {key:?}");
        press(&mut harness, key);
        settle(&mut harness);
        assert!(harness.state().state.heat().is_none(), "{key:?}");
        for id in ["2/12", "5/33"] {
            let slides = &harness.state().state.library.slides;
            let slide = slides.iter().position(|slide| slide.id() == id).unwrap();
            harness.state_mut().state.show_slide(slide);
            settle(&mut harness);
        }
        harness.state_mut().state.show_stage(StageKind::Solid);
        settle(&mut harness);
    }
    // A slide that stands on its flat stage goes to its solid one, and one without says that it has none.
    let mut harness = window("5/33");
    assert_eq!(harness.state().state.view.stage, StageKind::Flat);
    press(&mut harness, Key::H);
    settle(&mut harness);
    assert_eq!(harness.state().state.view.stage, StageKind::Solid);
    assert!(harness.state().state.heat().is_some());
    let mut harness = window("1/1");
    press(&mut harness, Key::H);
    assert!(harness.state().state.heat().is_none());
}

/// A pixel of a board's heat map, and where it lies in the window.
fn pixel(harness: &Window) -> (Pixel, Pos2) {
    // The border of a pane is for dragging it.
    let rect = harness.get_by_label("Picture").rect().expand(5.0);
    let playback = harness.state().state.playback().unwrap().clone();
    let instant = playback.instant(harness.state().state.view.step);
    let reel = playback.reel();
    let ask = Ask::new(Vec2::new(rect.width(), rect.height()), Look::WINDOW);
    let points = (0..40).flat_map(|y| (0..40).map(move |x| Vec2::new(x as f32 + 0.5, y as f32 + 0.5) / 40.0));
    let pixels = points.filter_map(|part| {
        let at = part * ask.size;
        Some((reel.still(&instant).pixel_at(&ask, at)?, pos2(rect.left() + at.x, rect.top() + at.y)))
    });
    pixels.max_by_key(|(pixel, _)| pixel.count).expect("a heat map")
}

#[test]
fn a_pixel_of_a_board_opens_the_walk_of_its_ray() {
    for (slide, kind, of) in [("7/57", "bvh", Column::Boxes), ("5/41", "kd", Column::Tests)] {
        let mut harness = window(slide);
        press(&mut harness, Key::End);
        let (pixel, at) = pixel(&harness);
        click(&mut harness, at);
        settle(&mut harness);
        let state = &harness.state().state;
        let playback = state.playback().unwrap();
        let RayChoice::Own(_) = state.view.ray else { panic!("{slide}: no ray of a pixel") };
        assert_eq!((playback.play.tape.plays(), playback.rule.kind()), (Plays::Walk, kind), "{slide}");
        let cost = playback.cost(playback.steps().last()).unwrap();
        assert_eq!(of.count(&cost), u64::from(pixel.count), "{slide}: the same structure, the same ray");
    }
}

fn images(figure: &Figure) -> Vec<*const u8> {
    let image = |ink: &Ink| match ink {
        Ink::Image { image, .. } => Some(image.rgba.as_ptr()),
        _ => None,
    };
    figure.marks.iter().filter_map(|mark| image(&mark.ink)).collect()
}

#[test]
fn what_a_board_shows_is_made_once() {
    for slide in ["7/57", "5/41"] {
        let harness = window(slide);
        let playback = harness.state().state.playback().unwrap().clone();
        let last = playback.steps().last();
        let draw = |width: f32| {
            let (reel, instant) = (playback.reel(), playback.instant(last));
            images(&reel.still(&instant).draw(Pane::Picture, &Ask::new(Vec2::new(width, 800.0), Look::WINDOW)))
        };
        let first = draw(1200.0);
        assert!(first.len() >= 2, "{slide} has heat maps");
        assert_eq!(first, draw(900.0), "{slide}: no colour is looked up again, and none uploaded");
    }
}

/// Not a test: how long a frame of a board takes.
#[test]
#[ignore = "measures"]
fn frames_of_boards() {
    for slide in ["7/57", "5/41"] {
        let mut harness = window(slide);
        press(&mut harness, Key::End);
        harness.run_steps(10);
        let begun = Instant::now();
        harness.run_steps(200);
        println!("{slide}: {:.3} ms a frame", begun.elapsed().as_secs_f64() * 1e3 / 200.0);
    }
}

#[test]
fn up_to_three_structures_stand_beside_a_flat_walk() {
    let mut harness = window("5/33");
    let rivals = Rivals::of(["list", "octree", "bvh"]);
    harness.state_mut().state.predict = false;
    harness.state_mut().state.compare_all(rivals);
    settle(&mut harness);
    assert_eq!(harness.state().state.beside, Beside::Abreast(rivals));
    harness.get_by_label("Walks side by side");
    let last = harness.state().state.playback().unwrap().steps().last();
    let mut before = 0;
    for step in 0..=last {
        harness.state_mut().state.go(step);
        harness.run_steps(1);
        let beside = harness.state().beside().unwrap().clone();
        let Tape::Walks(walks) = &beside.play.tape else { panic!("one walk beside") };
        assert_eq!(walks.names(), ["kd", "list", "octree", "bvh"]);
        let shown = harness.state().state.beside_step(&beside);
        assert!(shown >= before && (step > 0 || shown == 0), "step {step}");
        let own = walks.order[..shown].iter().filter(|(walker, _)| *walker == 0).count();
        assert_eq!(own, step, "its own walk has come as far");
        before = shown;
    }
    let beside = harness.state().beside().unwrap().clone();
    assert_eq!(before, beside.steps().last(), "all of them are over");
    // The structure that is shown is one of them, also with other parameters.
    harness.state_mut().state.set("max_depth", "2");
    settle(&mut harness);
    let beside = harness.state().beside().unwrap().clone();
    assert!(Arc::ptr_eq(&beside.play.structure, &harness.state().state.playback().unwrap().play.structure));
    // In space there are two.
    harness.state_mut().state.show_stage(StageKind::Solid);
    settle(&mut harness);
    harness.run_steps(3);
    assert_eq!(harness.state().state.beside, Beside::Structure("list"));
    press(&mut harness, Key::X);
    assert_eq!(harness.state().state.beside, Beside::Nothing);
}

#[test]
fn all_structures_are_measured_over_what_is_open() {
    let mut harness = window("9/66");
    press(&mut harness, Key::End);
    harness.get_by_label("Which structure is best for it?").click();
    harness.run_steps(3);
    settle(&mut harness);
    harness.get_by_label("All structures");
    for name in ["Brute force", "kd-tree", "BVH"] {
        assert!(harness.query_all_by_label(name).next().is_some(), "{name}");
    }
    harness.get_by_label("Close").click();
    harness.run_steps(3);
    assert!(harness.query_by_label("All structures").is_none());
}
