#![cfg(target_os = "linux")]
//! How long every slide takes to open, and every step to draw, in the real window on a display of its own: a table, not a
//! judgement.

use std::cell::RefCell;
use std::process::Command;
use std::rc::Rc;
use std::time::Instant;

use egui::{Event, Key, Modifiers, Ui, ViewportCommand};
use raystep::window::{App, Opening, Wishes};
use raystep_lesson::Library;
use winit::platform::x11::EventLoopBuilderExtX11;

mod display;
use display::{Display, resident};

/// What is pressed on a slide, each once everything that the one before calls for is there: so many steps forward, the
/// last one, so many steps back, and the first one.
const KEYS: [(Key, usize); 4] = [(Key::ArrowRight, 40), (Key::End, 1), (Key::ArrowLeft, 20), (Key::Home, 1)];

/// A frame that takes longer is told of by itself, in milliseconds.
const FRAME: f32 = 16.0;

/// Frames in which nothing is pressed before a slide is left.
const REST: usize = 3;

/// What was measured on one slide, in milliseconds.
#[derive(Default)]
struct Measured {
    /// From the key that leaves the slide before to the first frame of its own, be it with a progress.
    first: f64,
    /// And to the frame in which its picture stands.
    opening: f64,
    /// The computing of each frame after that, and the key that called for it.
    frames: Vec<(f32, Option<Key>)>,
    /// The most that a frame took of the processor in the window's own thread: what is painted in software beside it can
    /// make it wait, and does on a machine of two cores.
    own: f32,
}

/// How long the processor has worked for this thread, in milliseconds.
fn worked() -> f32 {
    let told = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    told.split(' ').next().and_then(|nanoseconds| nanoseconds.parse::<u64>().ok()).unwrap_or(0) as f32 / 1e6
}

/// Who turns the pages.
struct Pages {
    names: Vec<String>,
    /// Of the slide that is shown.
    measured: Measured,
    /// How many slides were left.
    shown: usize,
    /// The slide that is being opened, and since when.
    opens: Option<(usize, Instant)>,
    /// How many keys were pressed on this slide, and the last one.
    pressed: usize,
    key: Option<Key>,
    /// What the processor had worked for the window's thread at the frame before.
    worked: f32,
    /// The slide after which the window is closed.
    last: usize,
}

impl Pages {
    fn turn(&mut self, app: &App, ui: &Ui, frame: &eframe::Frame) {
        ui.ctx().request_repaint();
        let worked = worked();
        let own = worked - std::mem::replace(&mut self.worked, worked);
        let slide = app.state.view.slide;
        let milliseconds = frame.info().cpu_usage.map(|seconds| seconds * 1000.0);
        let since = |since: Instant| since.elapsed().as_secs_f64() * 1000.0;
        if let Some((_, began)) = self.opens.filter(|(opened, _)| *opened == slide && self.measured.first == 0.0) {
            self.measured.first = since(began);
        }
        if !app.state.is_current() {
            return;
        }
        if let Some((_, began)) = self.opens.filter(|(opened, _)| *opened == slide) {
            self.measured.opening = since(began);
            self.opens = None;
            return;
        }
        if self.opens.is_some() || slide > self.last {
            return;
        }
        let key = self.key.take();
        if let Some(slow) = milliseconds.filter(|milliseconds| *milliseconds > FRAME) {
            println!("{:>8}: {slow:.1} ms at step {}, {own:.1} ms of its own", self.names[slide], app.state.view.step);
        }
        self.measured.own = self.measured.own.max(own);
        self.measured.frames.extend(milliseconds.map(|milliseconds| (milliseconds, key)));
        let mut before = 0;
        let key = KEYS.iter().find(|(_, times)| {
            before += times;
            self.pressed < before
        });
        self.pressed += 1;
        if let Some((key, _)) = key {
            press(ui, *key);
            self.key = Some(*key);
        } else if self.pressed > before + REST {
            self.tell(slide);
            if slide == self.last {
                self.last = 0;
                ui.ctx().send_viewport_cmd(ViewportCommand::Close);
            } else {
                press(ui, Key::PageDown);
                (self.opens, self.pressed) = (Some((slide + 1, Instant::now())), 0);
            }
        }
    }
}

impl Pages {
    /// Prints what was measured on a slide that is left.
    fn tell(&mut self, slide: usize) {
        let Measured { first, opening, mut frames, own } = std::mem::take(&mut self.measured);
        frames.sort_by(|(a, _), (b, _)| a.total_cmp(b));
        let ((median, _), (most, key)) = (frames[frames.len() / 2], frames[frames.len() - 1]);
        let (name, count) = (&self.names[slide], frames.len());
        let key = key.map_or("-", Key::name);
        println!("{name:>8} {first:>9.0} {opening:>11.0} {median:>10.1} {most:>11.1} {key:>7} {own:>7.1} {count:>7}");
        self.shown += 1;
    }
}

fn press(ui: &Ui, key: Key) {
    let event =
        |pressed| Event::Key { key, physical_key: None, pressed, repeat: false, modifiers: Modifiers::default() };
    ui.ctx().input_mut(|input| input.events.extend([event(true), event(false)]));
}

/// Not a test: what the test below lets happen in a program of its own, on a display of its own.
#[test]
#[ignore = "needs the display that the test below gives it"]
fn inside_all_slides() {
    let library = Library::embedded();
    let names: Vec<String> = library.slides.iter().map(raystep_lesson::Slide::id).collect();
    // That slide alone, behind the one before it.
    let only = std::env::var("RAYSTEP_SLIDE").ok();
    let place = |id: &String| names.iter().position(|name| name == id).expect("such a slide");
    let only = only.as_ref().map(place);
    let (from, last) = only.map_or((0, names.len() - 1), |only| (only.saturating_sub(1), only));
    let slides = last - from + 1;
    let slide = Some(names[from].clone());
    println!(
        "{:>8} {:>9} {:>11} {:>10} {:>11} {:>7} {:>7} {:>7}",
        "slide", "first, ms", "picture, ms", "frame, ms", "slowest, ms", "after", "own, ms", "frames"
    );
    let measured = Measured::default();
    let pages = Pages { names, measured, shown: 0, opens: None, pressed: 0, key: None, worked: 0.0, last };
    let pages = Rc::new(RefCell::new(pages));
    let turns = pages.clone();
    let opening = Opening {
        library,
        wishes: Wishes { slide, ..Wishes::default() },
        each_frame: Some(Box::new(move |app, ui, frame| turns.borrow_mut().turn(app, ui, frame))),
        event_loop: Some(Box::new(|builder| _ = builder.with_any_thread(true))),
        ..Opening::default()
    };
    opening.open().expect("a window");
    assert_eq!(pages.borrow().shown, slides, "all slides were shown");
    println!("all of them in one window, which holds {} MiB in the end", resident() >> 10);
}

#[test]
#[ignore = "takes minutes, and says most in a release build of an idle machine; RAYSTEP_SLIDE=5/33 that slide alone"]
fn every_slide_opens_and_steps() {
    let Some(display) = Display::or_step_aside() else { return };
    let folder = tempfile::tempdir().expect("a folder");
    let status = Command::new(std::env::current_exe().expect("this program"))
        .args(["--exact", "inside_all_slides", "--ignored", "--nocapture"])
        .env("DISPLAY", display.name())
        .env_remove("WAYLAND_DISPLAY")
        .env("XDG_STATE_HOME", folder.path())
        .env("XDG_CONFIG_HOME", folder.path())
        .status()
        .expect("this program runs");
    assert!(status.success(), "{status}");
}
