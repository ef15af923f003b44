//! A window without a screen: opened, waited for, and pressed keys in.

use std::sync::LazyLock;
use std::time::Duration;

use egui::Key;
use egui_kittest::{Harness, HarnessBuilder};
use raystep::window::{App, Remembered, Wishes};
use raystep_lesson::Library;

pub(crate) type Window = Harness<'static, App>;

/// So many times a window is looked at before what it should come to is given up, a hundredth of a second apart.
const PATIENCE: u32 = 2000;

static LIBRARY: LazyLock<Library> = LazyLock::new(Library::embedded);

/// The lessons that come with the program, read once.
pub(crate) fn library() -> Library {
    LIBRARY.clone()
}

/// How a window of this size is made.
pub(crate) fn sized(size: [f32; 2]) -> HarnessBuilder<App> {
    Harness::builder().with_size(size).with_max_steps(60)
}

/// A window at a slide, with its walk.
pub(crate) fn window(slide: &str, size: [f32; 2]) -> Window {
    remembering(slide, size, Remembered::default())
}

/// The same, with what it remembers.
pub(crate) fn remembering(slide: &str, size: [f32; 2], remembered: Remembered) -> Window {
    let wishes = Wishes { slide: Some(slide.to_owned()), ..Wishes::default() };
    let mut harness = sized(size).build_eframe(|context| App::wished(&context.egui_ctx, library(), wishes, remembered));
    settle(&mut harness);
    harness
}

/// Runs frames until something holds.
pub(crate) fn until(harness: &mut Window, mut holds: impl FnMut(&Window) -> bool) {
    for _ in 0..PATIENCE {
        harness.run_steps(3);
        if holds(harness) {
            return;
        }
        std::thread::sleep(Duration::from_millis(10));
    }
    panic!("it does not come to hold");
}

/// Runs frames until everything that is asked for is there.
pub(crate) fn settle(harness: &mut Window) {
    until(harness, |window| window.state().state.is_current());
}

/// Presses a key, and shows what comes of it.
pub(crate) fn press(harness: &mut Window, key: Key) {
    harness.key_press(key);
    harness.run_steps(2);
}
