//! The presenter's page: everything that is said and asked there is seen at once.

use egui_kittest::kittest::{NodeT, Queryable};
use raystep::shown::command::Command;
use raystep::window::{App, Remembered, Wishes};
use raystep_lesson::StageKind;

use crate::window::{Window, library, settle, sized};

/// How far texts and buttons reach below the room that they have.
fn too_low(harness: &Window, size: [f32; 2]) -> f32 {
    let body = (size[1] / 27.0).clamp(16.0, 64.0).min(size[0] / 44.0);
    let ruler = harness.query_by_label("t along the ray").or(harness.query_by_label("Bytes"));
    let ruler = ruler.map(|node| node.rect());
    let foot = size[1] - body * 1.4 * 0.7 - body * 1.5;
    let roles = [egui::accesskit::Role::Label, egui::accesskit::Role::Button];
    let shown = roles.into_iter().flat_map(|role| harness.query_all_by_role(role));
    let words = shown.filter(|node| node.accesskit_node().label().as_deref() != Some("Back to the study page"));
    let low = words.map(|node| node.rect()).map(|words| {
        let above = ruler.filter(|ruler| ruler.right() > words.left());
        words.bottom() - above.map_or(foot, |ruler| ruler.top().min(foot))
    });
    low.fold(0.0, f32::max)
}

#[test]
fn nothing_that_is_said_or_asked_needs_scrolling() {
    for size in [[1600.0, 900.0], [1920.0, 1080.0]] {
        let wishes = Wishes::default();
        let mut harness: Window = sized(size).build_eframe(|context| {
            let mut app = App::wished(&context.egui_ctx, library(), wishes, Remembered::default());
            app.state.present = true;
            app
        });
        settle(&mut harness);
        let slides = harness.state().state.library.slides.clone();
        let mut looked = 0;
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
        println!("{looked} pages at {size:?}");
        assert!(looked > 400);
    }
}

/// Looks at every beat, every question and every wrong answer; says how many there were.
fn look(harness: &mut Window, size: [f32; 2], what: &str) -> usize {
    let playback = harness.state().state.playback().expect("a walk").clone();
    let mut looked = 0;
    let mut check = |harness: &mut Window, what: String| {
        harness.run_steps(2);
        let low = too_low(harness, size);
        assert!(low <= 1.0, "{what} at {size:?}: {low} too low");
        looked += 1;
    };
    for step in playback.play.beats.iter().flatten() {
        harness.state_mut().state.go(*step);
        check(harness, format!("{what}, step {step}"));
    }
    for posed in &playback.posed {
        harness.state_mut().state.go(posed.before);
        if harness.state().state.question().is_none() {
            harness.state_mut().state.apply(Command::Next);
        }
        check(harness, format!("{what}, question before step {}", posed.step));
        for wrong in (0..posed.choices.len()).filter(|choice| !posed.choices[*choice].right) {
            harness.state_mut().state.apply(Command::Answer(wrong as u8));
            check(harness, format!("{what}, wrong answer {wrong} before step {}", posed.step));
        }
    }
    looked
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
            for name in ["Stack here", "Space", "Picture"] {
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
