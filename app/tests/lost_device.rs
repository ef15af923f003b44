#![cfg(target_os = "linux")]
//! A graphics device that is lost loses nothing: the real window, on a display of its own, whose device is destroyed
//! again and again. It steps aside where there is no Xvfb or no driver, unless `RAYSTEP_REQUIRE_GPU=1`.

use std::cell::RefCell;
use std::process::Command;
use std::rc::Rc;
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use egui::{ColorImage, Ui, ViewportCommand};
use raystep::shown::{RayChoice, View, command::Command as Does};
use raystep::window::{App, NoWindow, Opening, Patience, Wishes};
use raystep_lesson::Library;
use winit::platform::x11::EventLoopBuilderExtX11;

mod display;
use display::{Display, resident};

/// So long a window may take to stand still.
const LONGEST: Duration = Duration::from_secs(60);

/// So many frames a window stands still before it is looked at.
const STILL: u32 = 8;

/// The part of the width that the lesson takes, with the notice that the window is back.
const LESSON: f32 = 0.3;

/// What must be as it was.
#[derive(Clone, Debug, PartialEq)]
struct Kept {
    view: String,
    undoable: (bool, bool),
    undone: Vec<String>,
    grain: String,
    speed: u8,
    answered: String,
    focused: Option<egui::Id>,
    size: [i32; 2],
}

fn told(view: &View) -> String {
    let View { slide, stage, ray, settings, camera, step, .. } = view;
    format!("{slide} {stage:?} {ray:?} {settings:?} {camera:?} {step}")
}

impl Kept {
    fn of(app: &App, ui: &Ui) -> Kept {
        let state = &app.state;
        // All that can be undone, one by one, in a copy.
        let (mut past, mut undone) = (state.clone(), Vec::new());
        while past.undoable().0 {
            past.apply(Does::Undo);
            undone.push(told(past.target()));
        }
        let size = ui.ctx().content_rect().size().round();
        Kept {
            view: told(&state.view),
            undoable: state.undoable(),
            undone,
            grain: format!("{:?}", state.grain),
            speed: state.speed,
            answered: format!("{:?}", state.answered),
            focused: ui.memory(egui::Memory::focused),
            size: [size.x as i32, size.y as i32],
        }
    }
}

/// Who looks on, and destroys the device whenever the window stands still.
#[derive(Default)]
struct Looker {
    losses: u32,
    lost: u32,
    frames: u32,
    prepared: bool,
    kept: Option<Kept>,
    picture: Arc<Mutex<Option<Arc<ColorImage>>>>,
    first: Option<Arc<ColorImage>>,
    asked: bool,
    since: Option<Instant>,
    memory: Vec<u64>,
    seconds: Vec<f32>,
    /// What the lost device was drawn with: devices of two windows may be called the same.
    gone: Option<Drawn>,
}

/// What a window is drawn with.
type Drawn = Arc<egui::mutex::RwLock<egui_wgpu::Renderer>>;

/// Whether a window is drawn with what is gone.
fn is_gone(gone: Option<&Drawn>, now: &egui_wgpu::RenderState) -> bool {
    gone.is_some_and(|gone| Arc::ptr_eq(gone, &now.renderer))
}

impl Looker {
    fn look(&mut self, app: &mut App, ui: &Ui, frame: &eframe::Frame) {
        ui.ctx().request_repaint();
        let since = *self.since.get_or_insert_with(Instant::now);
        assert!(since.elapsed() < LONGEST, "the window does not come to rest");
        let drawn = frame.wgpu_render_state().expect("a device");
        if is_gone(self.gone.as_ref(), drawn) {
            // Its last frames: the window is about to close.
            return;
        }
        if !app.state.is_current() || !app.is_idle() {
            self.frames = 0;
            return;
        }
        self.frames += 1;
        if self.frames == 1 {
            // The pointer waits over the lesson: elsewhere it lights something up.
            ui.ctx().send_viewport_cmd(ViewportCommand::CursorPosition(egui::pos2(100.0, 400.0)));
        }
        if !self.prepared && self.frames >= STILL {
            self.prepared = true;
            self.frames = 0;
            prepare(app);
            return;
        }
        if self.frames < STILL {
            return;
        }
        if !self.asked {
            self.asked = true;
            let picture = self.picture.clone();
            let take = move |taken: Arc<ColorImage>| *picture.lock().expect("a picture") = Some(taken);
            ui.ctx().send_viewport_cmd(screenshot(take));
            return;
        }
        let Some(picture) = self.picture.lock().expect("a picture").take() else { return };
        self.compare(app, ui, &picture);
        if self.lost == self.losses {
            ui.ctx().send_viewport_cmd(ViewportCommand::Close);
            return;
        }
        self.lost += 1;
        (self.asked, self.frames, self.since) = (false, 0, Some(Instant::now()));
        self.gone = Some(drawn.renderer.clone());
        drawn.device.destroy();
    }

    fn compare(&mut self, app: &App, ui: &Ui, picture: &Arc<ColorImage>) {
        let kept = Kept::of(app, ui);
        let lost = self.lost;
        if let Some(before) = &self.kept {
            assert_eq!(&kept, before, "after {lost} losses");
            self.seconds.push(self.since.expect("a beginning").elapsed().as_secs_f32());
        }
        self.kept = Some(kept);
        let first = self.first.get_or_insert_with(|| picture.clone());
        let different = different(first, picture);
        if different > 0 {
            save(first, "lost-before.png");
            save(picture, "lost-after.png");
        }
        assert_eq!(different, 0, "pixels that look otherwise after {lost} losses, see the folder of temporary files");
        self.memory.push(resident());
    }
}

fn screenshot(take: impl Fn(Arc<ColorImage>) + Send + Sync + 'static) -> ViewportCommand {
    ViewportCommand::Screenshot(egui::ScreenshotCallback::new(take))
}

/// Something to lose: a solid stage of a slide with another ray, other parameters, a turned camera, a history.
fn prepare(app: &mut App) {
    let state = &mut app.state;
    state.predict = false;
    state.keep();
    state.set("max_depth", "5");
    state.show_ray(RayChoice::Named(1), false);
    let camera = raystep_figure::Camera::Solid {
        eye: glam::Vec3::new(-7.0, -6.0, 5.0),
        target: glam::Vec3::new(0.0, 0.0, 1.0),
        up: glam::Vec3::Z,
        fov_degrees: 40.0,
    };
    state.look(Some(camera));
    state.apply(Does::Speed(11));
    state.open_at(9);
}

/// The pixels beside the lesson that differ by more than a shade.
fn different(a: &ColorImage, b: &ColorImage) -> usize {
    assert_eq!(a.size, b.size);
    let [width, _] = a.size;
    let from = (width as f32 * LESSON) as usize;
    let pairs = a.pixels.iter().zip(&b.pixels).enumerate().filter(|(at, _)| at % width >= from);
    let far =
        |a: egui::Color32, b: egui::Color32| a.to_array().into_iter().zip(b.to_array()).any(|(a, b)| a.abs_diff(b) > 1);
    pairs.filter(|(_, (a, b))| far(**a, **b)).count()
}

fn save(image: &ColorImage, name: &str) {
    let path = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let file = std::fs::File::create(path).expect("a file");
    let [width, height] = image.size.map(|side| side as u32);
    let mut encoder = png::Encoder::new(file, width, height);
    encoder.set_color(png::ColorType::Rgba);
    let bytes: Vec<u8> = image.pixels.iter().flat_map(egui::Color32::to_array).collect();
    encoder.write_header().and_then(|mut writer| writer.write_image_data(&bytes)).expect("a picture");
}

fn opening(looks: impl FnMut(&mut App, &Ui, &eframe::Frame) + 'static, patience: Patience) -> Opening {
    let wishes =
        Wishes { slide: Some("5/33".to_owned()), ray: Some("past the handle".to_owned()), ..Wishes::default() };
    Opening {
        library: Library::embedded(),
        wishes,
        patience,
        each_frame: Some(Box::new(looks)),
        event_loop: Some(Box::new(|builder| _ = builder.with_any_thread(true))),
        ..Opening::default()
    }
}

/// Not a test: what the tests below let happen in a program of its own, on a display of its own.
#[test]
#[ignore = "needs the display that the tests below give it"]
fn inside_loses_devices() {
    let losses = std::env::var("RAYSTEP_LOSSES").ok().and_then(|losses| losses.parse().ok()).unwrap_or(3);
    let looker = Rc::new(RefCell::new(Looker { losses, ..Looker::default() }));
    let looks = looker.clone();
    let patience = Patience::new(usize::MAX, Duration::ZERO);
    opening(move |app, ui, frame| looks.borrow_mut().look(app, ui, frame), patience).open().expect("a window");
    let looker = looker.borrow();
    assert_eq!((looker.lost, looker.memory.len() as u32), (losses, losses + 1));
    let (memory, mut seconds) = (&looker.memory, looker.seconds.clone());
    seconds.sort_by(f32::total_cmp);
    let early = memory[memory.len().min(10) - 1];
    let last = memory[memory.len() - 1];
    println!(
        "{losses} devices lost, back after {:.2} s (median, {:.2} at most); memory {} MiB at first, {} after {}, {} at last",
        seconds[seconds.len() / 2],
        seconds[seconds.len() - 1],
        memory[0] >> 10,
        early >> 10,
        memory.len().min(10) - 1,
        last >> 10,
    );
    // What is left over of each device would add up.
    let each = last.saturating_sub(early) / u64::from(losses.saturating_sub(9).max(1));
    assert!(losses < 50 || each < 256, "{each} KiB are left over of each device: {memory:?}");
}

/// Not a test: see above.
#[test]
#[ignore = "needs the display that the tests below give it"]
fn inside_loses_patience() {
    let mut gone: Option<Drawn> = None;
    let looks = move |_: &mut App, ui: &Ui, frame: &eframe::Frame| {
        ui.ctx().request_repaint();
        let drawn = frame.wgpu_render_state().expect("a device");
        if !is_gone(gone.as_ref(), drawn) {
            gone = Some(drawn.renderer.clone());
            drawn.device.destroy();
        }
    };
    let ended = opening(looks, Patience::new(3, Duration::from_secs(100))).open();
    let Err(NoWindow::Lost(why)) = ended else { panic!("{ended:?}") };
    println!("patience ended: {}", NoWindow::Lost(why));
}

/// What a program of its own says that runs one of the above; nothing where that cannot be.
fn outside(test: &str, losses: u32) -> Option<String> {
    let display = Display::or_step_aside()?;
    let folder = tempfile::tempdir().expect("a folder");
    let output = Command::new(std::env::current_exe().expect("this program"))
        .args(["--exact", test, "--ignored", "--nocapture"])
        .env("DISPLAY", display.name())
        .env_remove("WAYLAND_DISPLAY")
        .env("RAYSTEP_LOSSES", losses.to_string())
        // One heap that gives back what is free: else gaps in the heaps of many threads look like something left over.
        .env("MALLOC_ARENA_MAX", "1")
        .env("MALLOC_MMAP_THRESHOLD_", "65536")
        .env("MALLOC_TRIM_THRESHOLD_", "65536")
        .env("XDG_STATE_HOME", folder.path())
        .env("XDG_CONFIG_HOME", folder.path())
        .output()
        .expect("this program runs");
    let [said, beside] = [&output.stdout, &output.stderr].map(|text| String::from_utf8_lossy(text).into_owned());
    assert!(output.status.success(), "{said}\n{beside}");
    for wrong in ["this should never happen", "refuses something"] {
        assert!(!beside.contains(wrong), "{beside}");
    }
    assert_eq!(beside.matches("the window opens again").count() as u32, losses, "{beside}");
    let line = said.lines().find(|line| line.contains("devices lost") || line.contains("patience ended"));
    Some(line.unwrap_or_else(|| panic!("{said}")).to_owned())
}

#[test]
fn a_lost_device_loses_nothing() {
    if let Some(said) = outside("inside_loses_devices", 3) {
        println!("{said}");
    }
}

#[test]
#[ignore = "takes minutes: see the README"]
fn a_hundred_lost_devices_lose_nothing() {
    if let Some(said) = outside("inside_loses_devices", 100) {
        println!("{said}");
    }
}

#[test]
fn a_window_that_is_lost_again_and_again_is_given_up() {
    if let Some(said) = outside("inside_loses_patience", 2) {
        assert!(said.contains("no window stays open: the graphics device is lost again and again"), "{said}");
    }
}
