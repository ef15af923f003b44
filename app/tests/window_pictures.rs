//! A few small pictures of the window. Steps aside where no driver answers, unless `RAYSTEP_REQUIRE_GPU=1`.

use egui_kittest::{Harness, SnapshotOptions};
use raystep::window::{App, Remembered, Wishes};
use raystep_lesson::{Library, StageKind};

/// Small differences of drivers in the edges of lines.
const DIFFERENT_PIXELS: usize = 1500;

fn picture(name: &str, slide: &str, stage: StageKind, theme: &str, size: [f32; 2]) {
    if let Err(none) = raystep_paint::Headless::new() {
        assert!(std::env::var("RAYSTEP_REQUIRE_GPU").as_deref() != Ok("1"), "{none}");
        println!("stepping aside: {none}");
        return;
    }
    let wishes = Wishes { slide: Some(slide.to_owned()), ..Wishes::default() };
    let mut remembered = Remembered::default();
    theme.clone_into(&mut remembered.theme);
    let options = SnapshotOptions::new().max_failed_pixels(DIFFERENT_PIXELS);
    let builder = Harness::builder().with_size(size).with_pixels_per_point(0.5).with_options(options).wgpu();
    let mut harness = builder.build_eframe(|context| {
        let mut app = App::wished(&context.egui_ctx, Library::embedded(), wishes, remembered);
        if let Some(state) = &context.wgpu_render_state {
            app.draw_with(state);
        }
        app.state.show_stage(stage);
        app
    });
    for _ in 0..2000 {
        harness.run_steps(2);
        if harness.state().state.is_current() {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(10));
    }
    harness.run_steps(3);
    harness.snapshot(name);
}

#[test]
fn a_slab_slide_in_a_middling_window() {
    picture("slab-light-1280", "2/13b", StageKind::Flat, "light", [1280.0, 800.0]);
}

#[test]
fn a_grid_slide_in_a_small_window() {
    picture("grid-light-1024", "3/20", StageKind::Flat, "light", [1024.0, 768.0]);
}

#[test]
fn a_kd_slide_in_a_large_window() {
    picture("kd-light-1600", "5/33", StageKind::Flat, "light", [1600.0, 1000.0]);
}

#[test]
fn a_solid_bvh_slide_in_the_dark() {
    picture("bvh-solid-dark-1600", "7/56", StageKind::Solid, "dark", [1600.0, 1000.0]);
}
