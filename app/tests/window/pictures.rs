//! Pictures of the window: a few small ones that are compared, and on demand all sizes, stages and themes to be
//! looked at. Both step aside where no driver answers, unless `RAYSTEP_REQUIRE_GPU=1`.

use std::path::Path;
use std::time::Duration;

use egui_kittest::{Harness, SnapshotOptions};
use raystep::window::{App, Remembered, Wishes};
use raystep_accel::Grain;
use raystep_lesson::StageKind;

use crate::window::{Window, library};

/// Small differences of drivers in the edges of lines.
const DIFFERENT_PIXELS: usize = 1500;

/// What a picture of the window shows.
struct Shot<'a> {
    slide: &'a str,
    stage: StageKind,
    theme: &'a str,
    size: [f32; 2],
    present: bool,
}

impl Shot<'_> {
    /// The window at the walk's first step, drawn at so many pixels per point; none where no driver answers.
    fn window(&self, pixels_per_point: f32) -> Option<Window> {
        if let Err(none) = raystep_paint::Headless::new() {
            assert!(std::env::var("RAYSTEP_REQUIRE_GPU").as_deref() != Ok("1"), "{none}");
            println!("stepping aside: {none}");
            return None;
        }
        let wishes = Wishes { slide: Some(self.slide.to_owned()), ..Wishes::default() };
        let mut remembered = Remembered::default();
        self.theme.clone_into(&mut remembered.theme);
        let options = SnapshotOptions::new().max_failed_pixels(DIFFERENT_PIXELS);
        let builder = Harness::builder().with_size(self.size).with_pixels_per_point(pixels_per_point);
        let mut harness = builder.with_options(options).wgpu().build_eframe(|context| {
            let mut app = App::wished(&context.egui_ctx, library(), wishes, remembered);
            if let Some(state) = &context.wgpu_render_state {
                app.draw_with(&context.egui_ctx, state);
            }
            app.state.show_stage(self.stage);
            app.state.present = self.present;
            app
        });
        for _ in 0..2000 {
            harness.run_steps(2);
            if harness.state().state.is_current() {
                break;
            }
            std::thread::sleep(Duration::from_millis(10));
        }
        harness.run_steps(3);
        Some(harness)
    }

    /// Compares a picture of half the size with the kept one.
    fn check(&self, name: &str) {
        if let Some(mut harness) = self.window(0.5) {
            harness.snapshot(name);
        }
    }

    /// Writes the window in its own size, some way along the walk.
    fn write(&self, folder: &Path) {
        let Some(mut harness) = self.window(1.0) else { return };
        let state = &mut harness.state_mut().state;
        let playback = state.playback().expect("a walk").clone();
        let steps = playback.steps();
        let (mut at, half) = (0, steps.last() * 3 / 5);
        while at < half {
            at = steps.next(at, Grain::Visit);
        }
        state.go(at);
        harness.run_steps(4);
        let picture = harness.render().expect("a picture");
        let slide = self.slide.replace('/', "-");
        let page = if self.present { "present" } else { "study" };
        let [width, height] = self.size;
        let name = format!("{slide}-{:?}-{page}-{width}x{height}-{}.png", self.stage, self.theme).to_lowercase();
        picture.save(folder.join(name)).expect("the picture is written");
    }
}

fn study<'a>(slide: &'a str, stage: StageKind, theme: &'a str, size: [f32; 2]) -> Shot<'a> {
    Shot { slide, stage, theme, size, present: false }
}

#[test]
fn a_slab_slide_in_a_middling_window() {
    study("2/13b", StageKind::Flat, "light", [1280.0, 800.0]).check("slab-light-1280");
}

#[test]
fn a_grid_slide_in_a_small_window() {
    study("3/20", StageKind::Flat, "light", [1024.0, 768.0]).check("grid-light-1024");
}

#[test]
fn a_kd_slide_in_a_large_window() {
    study("5/33", StageKind::Flat, "light", [1600.0, 1000.0]).check("kd-light-1600");
}

#[test]
fn a_solid_bvh_slide_in_the_dark() {
    study("7/56", StageKind::Solid, "dark", [1600.0, 1000.0]).check("bvh-solid-dark-1600");
}

#[test]
#[ignore = "writes 120 pictures to look at; see the README"]
fn every_size_stage_and_theme() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("window-pictures");
    std::fs::create_dir_all(&folder).expect("a folder for the pictures");
    for slide in ["2/13b", "3/20", "5/33", "7/56b", "5/30"] {
        for stage in [StageKind::Flat, StageKind::Solid] {
            for theme in ["light", "dark", "projector"] {
                for size in [[1600.0, 1000.0], [1280.0, 800.0], [1024.0, 768.0]] {
                    study(slide, stage, theme, size).write(&folder);
                }
                Shot { present: true, ..study(slide, stage, theme, [1600.0, 900.0]) }.write(&folder);
            }
        }
    }
    println!("{}", folder.display());
}
