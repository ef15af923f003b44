#![cfg(target_os = "linux")]
//! Forty-five minutes before a class, played from a file against the real window, on a display of its own: nothing grows,
//! and no frame is slow at the end that was not at the beginning.

use std::cell::RefCell;
use std::process::Command;
use std::rc::Rc;
use std::time::Instant;

use egui::{Event, Key, Modifiers, Ui, ViewportCommand};
use raystep::window::{App, Opening};
use raystep_lesson::Library;
use winit::platform::x11::EventLoopBuilderExtX11;

mod display;
use display::{Display, resident};

/// Which keys come when, in seconds.
type Score = Vec<(f64, Vec<(Modifiers, Key)>)>;

/// The file's keys.
fn score() -> Score {
    let text = include_str!("rehearsal.txt");
    let lines = text.lines().filter(|line| !line.starts_with('#') && !line.trim().is_empty());
    lines.map(|line| read(line).unwrap_or_else(|| panic!("{line:?} is no minute:second with keys"))).collect()
}

fn read(line: &str) -> Option<(f64, Vec<(Modifiers, Key)>)> {
    let (time, keys) = line.split_once("  ")?;
    let (minute, second) = time.split_once(':')?;
    let key = |word: &str| match word.strip_prefix("Shift+") {
        Some(word) => Some((Modifiers::SHIFT, Key::from_name(word)?)),
        None => Some((Modifiers::NONE, Key::from_name(word)?)),
    };
    let keys = keys.split_whitespace().map(key).collect::<Option<Vec<_>>>()?;
    Some((minute.parse::<f64>().ok()? * 60.0 + second.parse::<f64>().ok()?, keys))
}

/// Who plays the keys, and measures.
struct Player {
    score: Score,
    /// How many times as fast as in a lecture hall.
    speed: f64,
    began: Option<Instant>,
    played: usize,
    /// Minute of the rehearsal, seconds of computing for a frame, and memory in KiB.
    frames: Vec<(f64, f32, u64)>,
    slides: std::collections::BTreeSet<usize>,
}

impl Player {
    fn play(&mut self, app: &App, ui: &Ui, frame: &eframe::Frame) {
        ui.ctx().request_repaint_after_secs(0.05);
        let now = self.began.get_or_insert_with(Instant::now).elapsed().as_secs_f64() * self.speed;
        if let Some(seconds) = frame.info().cpu_usage {
            self.frames.push((now / 60.0, seconds, resident()));
        }
        self.slides.insert(app.state.view.slide);
        match self.score.get(self.played) {
            None => ui.ctx().send_viewport_cmd(ViewportCommand::Close),
            // One key a frame, and none before what it calls for is there, as a lecturer would.
            Some((at, keys)) if *at <= now && (app.state.is_current() || self.speed <= 1.0) => {
                for (modifiers, key) in keys {
                    let event = |pressed| Event::Key {
                        key: *key,
                        physical_key: None,
                        pressed,
                        repeat: false,
                        modifiers: *modifiers,
                    };
                    ui.ctx().input_mut(|input| input.events.extend([event(true), event(false)]));
                }
                self.played += 1;
            }
            Some(_) => {}
        }
    }

    /// The median and the largest time of a frame in milliseconds, and the memory in MiB, between two minutes.
    fn between(&self, from: f64, to: f64) -> (f32, f32, u64) {
        let inside: Vec<_> = self.frames.iter().filter(|(minute, ..)| (from..to).contains(minute)).collect();
        let mut times: Vec<f32> = inside.iter().map(|(_, seconds, _)| seconds * 1000.0).collect();
        times.sort_by(f32::total_cmp);
        let memory = inside.iter().map(|(.., memory)| *memory).max().unwrap_or(0);
        (times.get(times.len() / 2).copied().unwrap_or(0.0), times.last().copied().unwrap_or(0.0), memory >> 10)
    }
}

/// Not a test: what the test below lets happen in a program of its own, on a display of its own.
#[test]
#[ignore = "needs the display that the test below gives it"]
fn inside_a_rehearsal() {
    let speed = std::env::var("RAYSTEP_SPEED").ok().and_then(|speed| speed.parse().ok()).unwrap_or(20.0);
    let score = score();
    let minutes = score.last().expect("keys").0 / 60.0;
    let (began, frames, slides) = (None, Vec::new(), std::collections::BTreeSet::new());
    let player = Rc::new(RefCell::new(Player { score, speed, began, played: 0, frames, slides }));
    let plays = player.clone();
    let opening = Opening {
        library: Library::embedded(),
        each_frame: Some(Box::new(move |app, ui, frame| plays.borrow_mut().play(app, ui, frame))),
        event_loop: Some(Box::new(|builder| _ = builder.with_any_thread(true))),
        ..Opening::default()
    };
    opening.open().expect("a window");
    let player = player.borrow();
    assert_eq!(player.played, player.score.len(), "all keys were played");
    assert!(player.slides.len() > 15, "{:?}", player.slides);
    for [from, to] in [[0.0, 5.0], [5.0, 15.0], [15.0, 25.0], [25.0, 35.0], [35.0, f64::INFINITY]] {
        let (median, most, memory) = player.between(from, to);
        println!("rehearsed minutes {from} to {to}: {median:.1} ms a frame (median, {most:.0} at most), {memory} MiB");
    }
    println!("rehearsed {minutes:.0} minutes, {} frames, {} slides", player.frames.len(), player.slides.len());
    let (half, end) = (player.between(0.0, minutes * 0.6).2, player.between(minutes * 0.6, f64::INFINITY).2);
    assert!(end < half * 3 / 2, "memory grows: {half} MiB by the middle, {end} MiB in the end");
}

#[test]
#[ignore = "takes minutes: RAYSTEP_SPEED=1 plays as fast as in a lecture hall, without it twenty times as fast"]
fn nothing_is_left_behind_after_forty_five_minutes() {
    let Some(display) = Display::or_step_aside() else { return };
    let folder = tempfile::tempdir().expect("a folder");
    let output = Command::new(std::env::current_exe().expect("this program"))
        .args(["--exact", "inside_a_rehearsal", "--ignored", "--nocapture"])
        .env("DISPLAY", display.name())
        .env_remove("WAYLAND_DISPLAY")
        .env("XDG_STATE_HOME", folder.path())
        .env("XDG_CONFIG_HOME", folder.path())
        .output()
        .expect("this program runs");
    let [said, beside] = [&output.stdout, &output.stderr].map(|text| String::from_utf8_lossy(text).into_owned());
    assert!(output.status.success(), "{said}\n{beside}");
    for line in said.lines().filter(|line| line.contains("rehearsed")) {
        println!("{line}");
    }
}

#[test]
fn the_score_is_forty_five_minutes_of_keys_that_mean_something() {
    let score = score();
    let last = score.last().expect("keys").0;
    assert!((44.0 * 60.0..46.0 * 60.0).contains(&last), "{last} s");
    assert!(score.windows(2).all(|pair| pair[0].0 <= pair[1].0), "one after the other");
    let known = |key: &(Modifiers, Key)| {
        let name = format!("{}{}", if key.0.shift { "Shift+" } else { "" }, key.1.name());
        let spelt = name
            .replace("PageDown", "Page down")
            .replace("PageUp", "Page up")
            .replace("Period", ".")
            .replace("Slash", "/");
        raystep::shown::command::ENTRIES.iter().any(|entry| entry.presenting.contains(&spelt.as_str()))
    };
    for (_, keys) in &score {
        for key in keys {
            assert!(known(key), "{key:?} gives nothing before a class");
        }
    }
}
