//! Pictures of the window: a few small ones that are compared, and on demand all sizes, stages and themes to be
//! looked at. Both step aside where no driver answers, unless `RAYSTEP_REQUIRE_GPU=1`.

use std::path::Path;
use std::time::Duration;

use egui_kittest::{Harness, SnapshotOptions};
use raystep::shown::command::Command;
use raystep::window::{App, Remembered, Wishes};
use raystep_accel::Grain;
use raystep_lesson::StageKind;

use crate::window::{Window, library, settle};

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
        self.theme.clone_into(&mut remembered.presenting);
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

/// The step at which a walk says most, with what comes before a class: the beat, its question, the answer.
fn hardest(playback: &raystep::shown::Playback, slide: &raystep_lesson::Slide) -> usize {
    let long = |beat: usize| {
        let beat = &slide.beats[beat];
        beat.ask.as_ref().map_or(0, |ask| ask.question.len())
    };
    let asked = playback.posed.iter().max_by_key(|posed| (posed.choices.len(), long(posed.beat)));
    let last = playback.play.beats.iter().flatten().copied().max();
    asked.map(|posed| posed.before).or(last).unwrap_or(0)
}

/// Opens every slide, on each of its stages, at its hardest step; `RAYSTEP_SLIDE=5/33` that slide alone.
fn at_the_hardest_step(shot: &Shot<'_>, mut look: impl FnMut(&mut Window, &str)) {
    let only = std::env::var("RAYSTEP_SLIDE").ok();
    let Some(mut harness) = shot.window(1.0) else { return };
    let slides = harness.state().state.library.slides.clone();
    for (index, slide) in
        slides.iter().enumerate().filter(|(_, slide)| only.as_ref().is_none_or(|id| *id == slide.id()))
    {
        for stage in StageKind::ALL.into_iter().filter(|kind| slide.stage(*kind).is_some()) {
            let state = &mut harness.state_mut().state;
            state.show_slide(index);
            state.show_stage(stage);
            settle(&mut harness);
            let playback = harness.state().state.playback().expect("a walk").clone();
            harness.state_mut().state.go(hardest(&playback, slide));
            harness.run_steps(4);
            let [width, height] = shot.size;
            let name = format!("{}-{stage:?}-{width}x{height}", slide.id().replace('/', "-"));
            look(&mut harness, &name.to_lowercase());
        }
    }
}

/// Writes what the window shows.
fn write(harness: &mut Window, folder: &Path, name: &str) {
    let picture = harness.render().expect("a picture");
    picture.save(folder.join(format!("{name}.png"))).expect("the picture is written");
}

/// A folder beside the tests' own.
fn folder(name: &str) -> std::path::PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::create_dir_all(&folder).expect("a folder for the pictures");
    println!("{}", folder.display());
    folder
}

#[test]
#[ignore = "writes pictures of every slide before a class to look at; RAYSTEP_SLIDE=5/33 those of one"]
fn every_slide_before_a_class() {
    let folder = folder("class-pictures");
    for size in [[1920.0, 1080.0], [1280.0, 720.0], [1024.0, 768.0]] {
        let shot = Shot { slide: "1/1", stage: StageKind::Flat, theme: "projector", size, present: true };
        at_the_hardest_step(&shot, |harness, name| {
            for part in ["beat", "question", "answer"] {
                harness.run_steps(4);
                write(harness, &folder, &format!("{name}-{part}"));
                harness.state_mut().state.apply(Command::Answer(0));
                harness.run_steps(2);
                harness.state_mut().state.apply(Command::Onward);
            }
        });
    }
}

#[test]
#[ignore = "writes pictures of every slide at home to look at; RAYSTEP_SLIDE=5/33 those of one"]
fn every_slide_at_five_sizes() {
    let folder = folder("study-pictures");
    for size in [[1024.0, 768.0], [1280.0, 800.0], [1366.0, 768.0], [1600.0, 1000.0], [2560.0, 1440.0]] {
        let shot = study("1/1", StageKind::Flat, "light", size);
        at_the_hardest_step(&shot, |harness, name| write(harness, &folder, name));
    }
}

#[test]
#[ignore = "writes 120 pictures to look at; see the README"]
fn every_size_stage_and_theme() {
    let folder = folder("window-pictures");
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
}
