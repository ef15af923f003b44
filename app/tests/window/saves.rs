//! Lessons that are saved while they are shown: the reader keeps the place, and sees what was good last.

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use egui_kittest::kittest::Queryable;
use raystep::window::{App, Remembered, Wishes};
use raystep_lesson::Library;

use crate::window::{Window, sized};

const SLIDE: &str = "05-kd-tree/33-which-child-first.md";

/// The shipped lessons, copied.
fn copied(name: &str) -> PathBuf {
    let lessons = Path::new(env!("CARGO_TARGET_TMPDIR")).join("window-saves").join(name);
    let _ = std::fs::remove_dir_all(&lessons);
    let mut folders = vec![(Path::new(env!("CARGO_MANIFEST_DIR")).join("../lessons"), lessons.clone())];
    while let Some((from, to)) = folders.pop() {
        std::fs::create_dir_all(&to).unwrap();
        for path in std::fs::read_dir(from).unwrap().map(|entry| entry.unwrap().path()) {
            let copy = to.join(path.file_name().unwrap());
            if path.is_dir() {
                folders.push((path, copy));
            } else {
                std::fs::copy(path, copy).unwrap();
            }
        }
    }
    lessons
}

fn window(lessons: &Path) -> Window {
    let library = Library::from_dir(lessons).unwrap();
    let wishes = Wishes {
        slide: Some("5/33".to_owned()),
        ray: Some("from the right".to_owned()),
        step: Some(6),
        lessons: Some(lessons.to_path_buf()),
        only: true,
        ..Wishes::default()
    };
    let mut harness = sized([1600.0, 1000.0])
        .build_eframe(|context| App::wished(&context.egui_ctx, library, wishes, Remembered::default()));
    until(&mut harness, "the slide", |app| app.state.is_current() && app.state.view.step == 6);
    harness
}

/// Runs frames until something holds; whatever is shown meanwhile, it is this slide at this step.
fn until(harness: &mut Window, what: &str, holds: impl Fn(&App) -> bool) {
    let begun = Instant::now();
    while begun.elapsed() < Duration::from_secs(60) {
        harness.run_steps(2);
        let state = &harness.state().state;
        let open = state.slide().map(|slide| slide.file.as_str());
        assert_eq!(open, Some(SLIDE), "{what}: the reader is thrown to another slide");
        if holds(harness.state()) {
            return;
        }
        std::thread::sleep(Duration::from_millis(10));
    }
    panic!("{what}: it does not come to hold");
}

/// The title that is shown with a walk.
fn title(app: &App) -> Option<&str> {
    app.state.slide().filter(|_| app.state.is_current()).map(|slide| slide.title.as_str())
}

#[test]
fn saving_the_open_slide_keeps_the_reader_in_his_place() {
    let lessons = copied("place");
    let path = lessons.join(SLIDE);
    let text = std::fs::read_to_string(&path).unwrap();
    let mut harness = window(&lessons);
    let old = "Which child first?";
    let place = |app: &App| {
        let view = &app.state.view;
        let ray = app.state.playback().and_then(|playback| playback.play.tape.ray()).map(|ray| ray.o);
        (view.slide, view.stage, view.step, ray)
    };
    let before = place(harness.state());

    let mut saves = 0;
    let mut check = |what: &str, save: &mut dyn FnMut(&mut Window, &str)| {
        saves += 1;
        let title = format!("Saved {saves} times");
        save(&mut harness, &text.replace(old, &title));
        until(&mut harness, what, |app| self::title(app) == Some(&title));
        assert_eq!(place(harness.state()), before, "{what}");
    };
    check("written", &mut |_, text| std::fs::write(&path, text).unwrap());
    for frames in [1, 5, 20] {
        check("emptied, then written", &mut |harness, text| {
            std::fs::write(&path, "").unwrap();
            for _ in 0..frames {
                harness.run_steps(2);
                std::thread::sleep(Duration::from_millis(30));
            }
            std::fs::write(&path, text).unwrap();
        });
    }
    check("cut in the middle for a long time", &mut |harness, text| {
        std::fs::write(&path, &text[..400]).unwrap();
        let begun = Instant::now();
        until(harness, "a half slide", |_| begun.elapsed() > Duration::from_secs(3));
        std::fs::write(&path, text).unwrap();
    });
    check("a structure that there is not, for a long time", &mut |harness, text| {
        std::fs::write(&path, text.replace("kind = \"kd\"", "kind = \"kt\"")).unwrap();
        let begun = Instant::now();
        until(harness, "a wrong slide", |_| begun.elapsed() > Duration::from_secs(3));
        assert!(harness.state().state.is_current(), "what was good last is shown");
        assert_eq!(place(harness.state()), before);
        std::fs::write(&path, text).unwrap();
    });
    check("a slide before it", &mut |_, text| {
        std::fs::copy(&path, lessons.join("05-kd-tree/33-a-twin.md")).unwrap();
        std::fs::remove_file(lessons.join("05-kd-tree/33-a-twin.md")).unwrap();
        std::fs::write(&path, text).unwrap();
    });
    check("the folder made anew", &mut |harness, text| {
        let aside = lessons.with_extension("aside");
        let _ = std::fs::remove_dir_all(&aside);
        std::fs::rename(&lessons, &aside).unwrap();
        let begun = Instant::now();
        until(harness, "no folder", |_| begun.elapsed() > Duration::from_secs(3));
        std::fs::rename(&aside, &lessons).unwrap();
        std::fs::write(&path, text).unwrap();
    });
}

#[test]
fn what_cannot_be_made_is_said_with_its_place_until_it_is_mended() {
    let lessons = copied("unmade");
    let path = lessons.join(SLIDE);
    let text = std::fs::read_to_string(&path).unwrap();
    let broken = text.replacen("kind = \"kd\"", "kind = \"kdd\"", 1);
    assert_ne!(broken, text);
    let line = 1 + text[..text.find("kind = \"kd\"").unwrap()].matches('\n').count();
    let place = format!("33-which-child-first.md:{line}:");
    let mut harness = window(&lessons);
    let mut wait = |what: &str, holds: &dyn Fn(&Window) -> bool| {
        let begun = Instant::now();
        while !holds(&harness) {
            assert!(begun.elapsed() < Duration::from_secs(60), "{what}: it does not come to hold");
            harness.run_steps(2);
            std::thread::sleep(Duration::from_millis(10));
        }
    };
    let said = |harness: &Window| harness.query_all_by_label_contains("there is no structure").count();
    for _ in 0..2 {
        std::fs::write(&path, &broken).unwrap();
        wait("the place", &|harness| harness.query_by_label_contains(&place).is_some());
        wait("one message", &|harness| said(harness) == 1);
        std::fs::write(&path, &text).unwrap();
        wait("the message goes", &|harness| said(harness) == 0 && harness.state().state.is_current());
    }
}

/// A folder with one slide on a scene of its own.
fn own(name: &str) -> PathBuf {
    let lessons = Path::new(env!("CARGO_TARGET_TMPDIR")).join("window-own").join(name);
    let _ = std::fs::remove_dir_all(&lessons);
    std::fs::create_dir_all(lessons.join("10-mine")).unwrap();
    std::fs::create_dir_all(lessons.join("scenes")).unwrap();
    let slide = "+++\nformat = 1\nslide = 90\ntitle = \"My room\"\nlisting = \"kd-walk\"\nscene = \"flat-room\"\n\
                 structure = { kind = \"kd\", max_depth = 3 }\nrays = [\n  { name = \"a\", from = [0, 2], towards = [9, 2] },\n  \
                 { name = \"b\", from = [9, 2], direction = [-1, 0] },\n]\n+++\n## The end {at=end}\nIt ends.\n\n\
                 > ask {field=hit}: Is anything hit?\n> - no: Look again.\n";
    std::fs::write(lessons.join("10-mine/90-room.md"), slide).unwrap();
    std::fs::write(lessons.join("scenes/flat-room.toml"), room(1.0)).unwrap();
    lessons
}

/// A scene whose disc has this radius.
fn room(radius: f32) -> String {
    format!("title = \"A room\"\nshapes = [\n  {{ disc = [5, 2], radius = {radius} }},\n]\n")
}

#[test]
fn a_scene_that_is_saved_is_shown() {
    let lessons = own("shown");
    let library = Library::embedded().and(Library::from_dir(&lessons).unwrap());
    assert!(library.problems.is_empty() && library.slides.len() > 60, "{:?}", library.problems);
    let wishes = Wishes { slide: Some("10/90".to_owned()), lessons: Some(lessons.clone()), ..Wishes::default() };
    let mut harness = sized([1600.0, 1000.0])
        .build_eframe(|context| App::wished(&context.egui_ctx, library, wishes, Remembered::default()));
    let high = |app: &App| {
        let shown = app.state.playback().filter(|_| app.state.is_current());
        shown.map(|playback| playback.play.scene.bounds().max.y)
    };
    let until = |harness: &mut Window, what: &str, y: f32| {
        let begun = Instant::now();
        while high(harness.state()) != Some(y) {
            harness.run_steps(1);
            assert!(begun.elapsed() < Duration::from_secs(60), "{what}: it is not shown");
            std::thread::sleep(Duration::from_millis(5));
        }
        begun.elapsed()
    };
    until(&mut harness, "the first", 3.0);
    let file = lessons.join("scenes/flat-room.toml");
    let mut longest = Duration::ZERO;
    for radius in [0.5, 0.75, 1.25, 1.5] {
        std::fs::write(&file, room(radius)).unwrap();
        longest = longest.max(until(&mut harness, "saved", 2.0 + radius));
    }
    println!("from save to picture: at most {longest:?}");
    // What is wrong is said, and the scene stays until it is right.
    std::fs::write(&file, "title = \"A room\"\nshapes = [\n  { disk = [5, 2] },\n]\n").unwrap();
    let begun = Instant::now();
    while harness.state().state.library.problems.is_empty() {
        harness.run_steps(1);
        assert!(begun.elapsed() < Duration::from_secs(60), "nothing is said");
    }
    let said = harness.state().state.library.problems[0].to_string();
    assert!(said.starts_with("scenes/flat-room.toml:3:") && said.contains("did you mean `disc`"), "{said}");
    until(&mut harness, "what was good last", 3.5);
    std::fs::write(&file, room(1.0)).unwrap();
    until(&mut harness, "right again", 3.0);
}
