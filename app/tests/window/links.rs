//! Links: another window that follows one shows exactly what this one does.

use egui::Key;
use raystep::shown::{Beside, Link, Pace, Rivals};
use raystep::window::{App, Remembered, Wishes};
use raystep_accel::Primitives;

use crate::window::{self, Window, library, press, sized, until};

const SIZE: [f32; 2] = [1280.0, 800.0];

/// Everything that is shown is there.
fn settle(harness: &mut Window) {
    until(harness, |window| {
        let app = window.state();
        let beside = app.state.beside == Beside::Nothing || app.beside().is_some();
        let heat = app.state.heat().is_none() || app.heat_pixel().is_some();
        app.state.is_current() && beside && heat
    });
}

/// Another window, opened at a link.
fn follow(link: &str) -> Window {
    let wishes = Wishes { at: Some(link.parse().unwrap()), ..Wishes::default() };
    let remembered = Remembered::default();
    let mut harness = sized(SIZE).build_eframe(|context| App::wished(&context.egui_ctx, library(), wishes, remembered));
    settle(&mut harness);
    harness
}

/// What a window shows is found again by its link, which says these things.
fn check(name: &str, slide: &str, change: impl Fn(&mut Window), says: &[&str]) {
    let mut here = window::window(slide, SIZE);
    change(&mut here);
    settle(&mut here);
    let link = here.state().link().to_string();
    for part in says {
        assert!(link.contains(part), "{name}: {link} does not say {part}");
    }
    let there = follow(&link);
    // From another slide one comes to the same.
    let mut elsewhere = window::window("5/31", SIZE);
    let wrong = link.parse::<Link>().unwrap().open(&mut elsewhere.state_mut().state, None);
    assert_eq!(wrong, Vec::<String>::new(), "{name}: {link}");
    settle(&mut elsewhere);
    for other in [&there, &elsewhere] {
        let (app, own) = (other.state(), here.state());
        assert_eq!(app.link().to_string(), link, "{name}");
        assert_eq!(
            (app.state.beside, app.state.pace, app.state.heat()),
            (own.state.beside, own.state.pace, own.state.heat())
        );
        let (shown, wanted) = (app.state.playback().unwrap(), own.state.playback().unwrap());
        assert_eq!(shown.rule, wanted.rule, "{name}");
        assert_eq!(shown.event(app.state.view.step), wanted.event(own.state.view.step), "{name}");
        assert_eq!(shown.play.scene.name, wanted.play.scene.name, "{name}");
        for prim in (0..wanted.play.scene.prims.len().min(600) as u32).map(raystep_accel::PrimId) {
            assert_eq!(shown.play.scene.prims.shape(prim), wanted.play.scene.prims.shape(prim), "{name}: {prim}");
        }
    }
}

/// Moves a shape of the scene.
fn move_shape(harness: &mut Window) {
    let state = &mut harness.state_mut().state;
    let scene = state.holdable().unwrap().clone();
    let (prim, part, at) = scene.parts()[4];
    state.keep();
    state.move_part(&scene, prim, part, [at, at + glam::Vec2::new(0.4, 0.3)]);
    window::settle(harness);
}

#[test]
fn a_link_shows_the_very_same_page() {
    check("moved", "5/33", move_shape, &["shape="]);
    check(
        "abreast",
        "5/33",
        |harness| {
            move_shape(harness);
            let state = &mut harness.state_mut().state;
            state.compare_all(Rivals::of(["grid", "bvh"]));
        },
        &["shape=", "beside=grid,bvh"],
    );
    check(
        "in step",
        "5/33",
        |harness| {
            let state = &mut harness.state_mut().state;
            state.compare("grid");
            state.pace = Pace::T;
        },
        &["beside=grid", "pace=t"],
    );
    check("broken", "5/33", |harness| press(harness, Key::M), &["mistake=kd-left-first"]);
    check(
        "pair",
        "3/19",
        |harness| harness.state_mut().state.set("ray_cone_1", "0.5 0 0"),
        &["set=ray_cone_1:0.5%200%200"],
    );
    check(
        "hot",
        "5/39",
        |harness| {
            press(harness, Key::V);
            window::settle(harness);
            press(harness, Key::H);
            harness.state_mut().state.compare("grid");
        },
        &["stage=solid", "heat=tests", "beside=grid"],
    );
}
