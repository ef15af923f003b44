//! Words in bold that the glossary explains, and messages that stay.

use std::path::Path;
use std::sync::Arc;

use egui::Key;
use egui_kittest::kittest::Queryable;
use raystep::window::Remembered;

use crate::window::{self, Window, settle};

fn window(slide: &str, remembered: Remembered) -> Window {
    window::remembering(slide, [1280.0, 800.0], remembered)
}

/// Slide 37 where its text speaks of the mailbox, which slide 20c teaches.
fn at_the_mailbox() -> Window {
    let mut harness = window("5/37", Remembered::default());
    harness.state_mut().state.predict = false;
    let steps: Vec<usize> = {
        let app = harness.state();
        app.state.playback().unwrap().play.beats.iter().flatten().copied().collect()
    };
    for step in steps {
        harness.state_mut().state.go(step);
        harness.run_steps(3);
        if harness.query_by_label_contains(WORD).is_some() {
            return harness;
        }
    }
    panic!("nobody speaks of the mailbox");
}

const WORD: &str = "mailbox: A note that goes with the ray";
const MEANS: &str = "A note that goes with the ray of which primitives it has tested, so that none is tested twice.";

fn says_so(harness: &Window) -> bool {
    harness.query_by_label(MEANS).is_some()
}

fn taught(harness: &Window) -> usize {
    harness.state().state.library.slides.iter().position(|slide| slide.id() == "3/20c").unwrap()
}

#[test]
fn a_word_says_what_it_means_when_it_is_pointed_at() {
    let mut harness = at_the_mailbox();
    assert!(!says_so(&harness));
    let at = harness.get_by_label_contains(WORD).rect().center();
    harness.hover_at(at);
    harness.run_steps(12);
    assert!(says_so(&harness));
    harness.hover_at(egui::pos2(900.0, 300.0));
    harness.run_steps(12);
    assert!(!says_so(&harness));
}

#[test]
fn a_word_says_what_it_means_when_it_is_clicked_and_leads_to_its_slide() {
    let mut harness = at_the_mailbox();
    harness.get_by_label_contains(WORD).click();
    harness.run_steps(4);
    assert!(says_so(&harness));
    harness.get_by_label_contains("slide 20").click();
    harness.run_steps(3);
    settle(&mut harness);
    assert_eq!(harness.state().state.view.slide, taught(&harness));
    assert!(harness.state().state.undoable().0, "the way back is open");
}

#[test]
fn a_word_says_what_it_means_when_it_is_focused() {
    let mut harness = at_the_mailbox();
    harness.get_by_label_contains(WORD).focus();
    harness.run_steps(4);
    assert!(says_so(&harness));
    harness.key_press(Key::Tab);
    harness.run_steps(3);
    harness.key_press(Key::Enter);
    harness.run_steps(3);
    settle(&mut harness);
    assert_eq!(harness.state().state.view.slide, taught(&harness));
}

#[derive(Debug)]
struct Dropped(&'static str, &'static [u8]);

impl egui::DroppedFile for Dropped {
    fn path(&self) -> &Path {
        Path::new(self.0)
    }

    fn bytes(&self) -> Result<Vec<u8>, String> {
        Ok(self.1.to_vec())
    }
}

#[test]
fn what_cannot_be_opened_is_said_until_it_is_closed() {
    let check = |path: &'static str, says: &str| {
        let mut harness = window("5/33", Remembered::default());
        harness.input_mut().dropped_files.push(Arc::new(Dropped(path, b"")));
        for _ in 0..200 {
            harness.run_steps(1);
            std::thread::sleep(std::time::Duration::from_millis(2));
        }
        assert!(harness.query_by_label_contains(says).is_some(), "{path}: nobody says {says}");
        let seconds = harness.ctx.time();
        while harness.ctx.time() < seconds + 20.0 {
            harness.run_steps(5);
        }
        assert!(harness.query_by_label_contains(says).is_some(), "{path}: it is gone after a while");
        harness.get_by_label("Close the message").click();
        harness.run_steps(3);
        assert!(harness.query_by_label_contains(says).is_none(), "{path}: it does not go");
    };
    check("/nowhere/gone.obj", "/nowhere/gone.obj cannot be read");
    check("notes.txt", "notes.txt is not opened: a mesh is a file in OBJ");
}

#[test]
fn what_makes_no_sense_in_the_settings_is_said_in_the_window() {
    let harness = window("5/33", Remembered::read("zoom = \"large\"\ntheme = 3\n"));
    assert!(harness.query_by_label_contains("zoom = \"large\": a number from 0.5 to 3 is needed").is_some());
    assert!(harness.query_by_label_contains("theme = 3: there are").is_some());
}
