//! What the window writes, opens and gives up.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Arc;

use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;
use raystep::shown::Playback;
use raystep::window::App;

use crate::window::{self, Window};

fn window(slide: &str) -> Window {
    window::window(slide, [1600.0, 1000.0])
}

/// Runs frames until something holds.
fn until(harness: &mut Window, holds: impl Fn(&App) -> bool) {
    window::until(harness, |window| holds(window.state()));
}

/// A folder of this test's own, empty.
fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).unwrap();
    path
}

/// A bumpy field of `n` by `n` squares.
fn field(n: usize) -> String {
    let mut text = String::new();
    for (x, y) in (0..=n).flat_map(|y| (0..=n).map(move |x| (x, y))) {
        text.push_str(&format!("v {x} {} {y}\n", (x * 7 + y * 13) % 5));
    }
    for corner in (0..n).flat_map(|y| (0..n).map(move |x| y * (n + 1) + x + 1)) {
        text.push_str(&format!("f {corner} {} {} {}\n", corner + 1, corner + n + 2, corner + n + 1));
    }
    text
}

#[derive(Debug)]
struct Dropped(PathBuf);

impl egui::DroppedFile for Dropped {
    fn path(&self) -> &Path {
        &self.0
    }

    fn bytes(&self) -> Result<Vec<u8>, String> {
        std::fs::read(&self.0).map_err(|error| error.to_string())
    }
}

/// A window with a mesh dropped on it.
fn dropped(name: &str, squares: usize) -> Window {
    let path = folder(name).join("field.obj");
    std::fs::write(&path, field(squares)).unwrap();
    let mut harness = window("5/33");
    harness.input_mut().dropped_files.push(Arc::new(Dropped(path)));
    until(&mut harness, |app| app.state.view.mesh.is_some() && app.state.is_current());
    harness
}

#[test]
fn the_dialog_writes_the_same_bytes_as_the_command_line() {
    // A walk; and a board on which nothing is measured yet, and nothing will be, but for the file.
    for (slide, stage) in [("5/33", &["--stage", "flat"][..]), ("5/42", &[])] {
        let (by_window, by_command) = (folder("by-window"), folder("by-command"));
        let mut harness = window(slide);
        if stage.is_empty() {
            harness.key_press(Key::Escape);
            harness.run_steps(3);
            assert!(harness.state().state.playback().is_some_and(|playback| playback.is_draft()), "{slide}");
        }
        let step = harness.state().state.view.step;
        harness.key_press_modifiers(Modifiers::COMMAND, Key::E);
        harness.run_steps(3);
        harness.get_by_label("1280×800").click();
        let field = harness.get_by_role_and_label(egui::accesskit::Role::TextInput, "Folder");
        field.focus();
        harness.run_steps(2);
        harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
        harness.event(egui::Event::Text(by_window.to_string_lossy().into_owned()));
        harness.run_steps(2);
        harness.get_by_label("Write").click();
        let step = format!("{step}..{step}");
        let size = ["--size", "1280x800", "--steps", &step, "--out"];
        let arguments = [&["export", "--slide", slide], stage, &size].concat();
        let output = Command::new(env!("CARGO_BIN_EXE_raystep")).args(arguments).arg(&by_command).output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let mut files = std::fs::read_dir(&by_command).unwrap().map(|entry| entry.unwrap().file_name());
        let name = files.next().expect("a picture");
        until(&mut harness, |_| by_window.join(&name).is_file());
        let read = |folder: &Path| std::fs::read(folder.join(&name)).unwrap();
        assert!(read(&by_window) == read(&by_command), "{name:?} differs");
    }
}

/// Opens the dialog.
fn dialog(slide: &str) -> Window {
    let mut harness = window(slide);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::E);
    harness.run_steps(3);
    harness
}

/// Presses a button of the dialog.
fn choose(harness: &mut Window, name: &str) {
    let roles = [egui::accesskit::Role::Button, egui::accesskit::Role::CheckBox];
    let found = roles.into_iter().find_map(|role| harness.query_by_role_and_label(role, name));
    found.unwrap_or_else(|| panic!("there is no {name}")).click();
    harness.run_steps(2);
}

/// Types into a field of the dialog, instead of what stands in it.
fn fill(harness: &mut Window, name: &str, text: &str) {
    harness.get_by_role_and_label(egui::accesskit::Role::TextInput, name).focus();
    harness.run_steps(2);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    if text.is_empty() {
        harness.key_press(Key::Delete);
    } else {
        harness.event(egui::Event::Text(text.to_owned()));
    }
    harness.run_steps(2);
}

#[test]
fn every_choice_writes_what_the_command_line_writes() {
    let check = |name: &str, slide: &str, chosen: &[&str], filled: &[(&str, &str)], arguments: &str| {
        let (by_window, by_command) = (folder(&format!("chosen-{name}")), folder(&format!("asked-{name}")));
        let mut harness = dialog(slide);
        let step = harness.state().state.view.step;
        for chosen in chosen {
            choose(&mut harness, chosen);
        }
        for (name, text) in filled {
            fill(&mut harness, name, text);
        }
        fill(&mut harness, "Folder", &by_window.to_string_lossy());
        choose(&mut harness, "Write");
        let stage = harness.state().state.view.stage.name();
        let step = format!("{step}..{step}");
        let here = ["--steps", step.as_str()];
        let arguments: Vec<&str> = arguments.split(' ').collect();
        let says = |word: &str| arguments.contains(&word);
        let here = if says("--steps") || says("--beats") || says("json") { &[][..] } else { &here[..] };
        let all = [&["export", "--slide", slide, "--stage", stage][..], &arguments, here, &["--out"]].concat();
        let output = Command::new(env!("CARGO_BIN_EXE_raystep")).args(&all).arg(&by_command).output().unwrap();
        assert!(output.status.success(), "{name}: {}", String::from_utf8_lossy(&output.stderr));
        let mut files: Vec<_> = by_command.read_dir().unwrap().map(|file| file.unwrap().file_name()).collect();
        files.sort();
        assert!(!files.is_empty(), "{name}");
        until(&mut harness, |_| files.iter().all(|file| by_window.join(file).is_file()));
        for file in &files {
            let read = |folder: &Path| std::fs::read(folder.join(file)).unwrap();
            assert!(read(&by_window) == read(&by_command), "{name}: {} differs", file.display());
        }
        assert_eq!(by_window.read_dir().unwrap().count(), files.len(), "{name}");
    };
    check(
        "tree",
        "5/33",
        &["SVG", "View tree", "Letters as text, faces in the file", "no ground", "cut margins off", "Theme dark"],
        &[("Size", "640x400")],
        "--view tree --format svg --text real --transparent --crop --theme dark --size 640x400",
    );
    check(
        "space",
        "5/33",
        &["PDF", "View space", "Legend on", "1280×800"],
        &[],
        "--view space --format pdf --legend on --size 1280x800",
    );
    check(
        "panes",
        "5/33",
        &["View own plate", "Pane text", "Pane stack", "Pane t", "steps"],
        &[("First and last step", "3..5"), ("Size", "640x400")],
        "--panes title,space,stack,t --steps 3..5 --size 640x400",
    );
    check(
        "film",
        "5/33",
        &["GIF", "View space", "steps", "Stops at visits"],
        &[("First and last step", "0..12"), ("Milliseconds of each step", "300"), ("Size", "320x200")],
        "--format gif --view space --steps 0..12 --grain visit --delay 300 --size 320x200",
    );
    check("json", "5/33", &["JSON"], &[], "--format json");
    check("beats", "2/12", &["all beats", "View listing"], &[], "--beats --view listing");
}

#[test]
fn what_makes_no_sense_is_greyed_and_says_why() {
    let says = |slide: &str, chosen: &[&str], greyed: &str| {
        let mut harness = dialog(slide);
        for chosen in chosen {
            choose(&mut harness, chosen);
        }
        assert!(harness.query_by_label_contains(greyed).is_some(), "{slide}: {greyed}");
    };
    says("2/12", &[], "View tree: This structure has no tree.");
    says("5/33", &[], "View chart: There is no chart here.");
    says("5/33", &[], "Pane stack: Choose own plate as the view.");
    says("5/33", &["View tree"], "Legend on: Plates and space have a legend, other views have none.");
    says("5/33", &["PDF"], "Letters as text, faces named: A PDF file has text anyhow.");
    says("5/33", &["GIF"], "): A film holds many steps.");
    says("5/33", &["JSON"], "View tree: A JSON file holds the walk, no picture.");
}

#[test]
fn what_cannot_be_exported_is_said_in_the_dialog() {
    let check = |chosen: &[&str], filled: &[(&str, &str)], says: &str| {
        let mut harness = dialog("5/33");
        for chosen in chosen {
            choose(&mut harness, chosen);
        }
        for (name, text) in filled {
            fill(&mut harness, name, text);
        }
        choose(&mut harness, "Write");
        until_said(&mut harness, says);
    };
    check(&[], &[("Size", "huge")], "Size: write two numbers from 16 to 16384");
    check(&["steps"], &[("First and last step", "9..3")], "Steps: step 9 comes after step 3");
    check(&["steps"], &[("First and last step", "all")], "Steps: write the first and the last step, as in 3..9");
    check(&["GIF"], &[("Milliseconds of each step", "5")], "Each step: write a whole number of milliseconds from 20");
    check(&["View own plate", "Pane title", "Pane text", "Pane space"], &[], "Choose what stands on the plate.");
    check(&[], &[("Folder", "")], "Write the folder that the files shall go to.");
    // What is found out while it is written is said there, too.
    let taken = folder("taken").join("file");
    std::fs::write(&taken, "x").unwrap();
    check(&[], &[("Folder", &taken.to_string_lossy())], "it is no folder: name another one");
}

#[test]
fn what_is_typed_wrong_is_said_at_once_and_taken_back_when_it_is_mended() {
    let mut harness = dialog("5/33");
    choose(&mut harness, "GIF");
    choose(&mut harness, "steps");
    for (name, wrong, says, right) in [
        ("First and last step", "41..99", "Steps: the last one is 40.", "3..99"),
        ("First and last step", "\u{221e}", "Steps: write the first and the last step", "7"),
        ("Size", "99999999999x1", "Size: write two numbers from 16 to 16384", "64x64"),
        ("Milliseconds of each step", "1e9", "Each step: write a whole number of milliseconds", "100"),
        ("Folder", "  ", "Write the folder that the files shall go to.", "pictures/\u{e9}\u{df}"),
    ] {
        fill(&mut harness, name, wrong);
        assert!(harness.query_by_label_contains(says).is_some(), "{name} {wrong}");
        fill(&mut harness, name, right);
        assert!(harness.query_by_label_contains(says).is_none(), "{name} {right}");
    }
}

/// Waits for a sentence.
fn until_said(harness: &mut Window, says: &str) {
    window::until(harness, |window| window.query_by_label_contains(says).is_some());
}

#[test]
fn a_path_that_is_wrong_can_be_mended() {
    let path = folder("mended").join("field.obj");
    std::fs::write(&path, field(4)).unwrap();
    let mut harness = window("5/33");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::O);
    harness.run_steps(3);
    for path in [path.with_extension("stl"), path] {
        harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
        harness.event(egui::Event::Text(path.to_string_lossy().into_owned()));
        harness.run_steps(1);
        harness.key_press(Key::Enter);
        harness.run_steps(3);
        let wrong = path.extension().is_some_and(|ending| ending == "stl");
        assert_eq!(harness.query_by_label_contains("there is no such file").is_some(), wrong);
    }
    until(&mut harness, |app| app.state.view.mesh.is_some());
}

#[test]
fn a_mesh_that_is_dropped_is_opened_and_walked() {
    let harness = dropped("drop", 12);
    let playback = harness.state().state.playback().unwrap();
    assert_eq!(raystep_accel::Primitives::len(&playback.play.scene.prims), 288);
    let raystep_lesson::Tape::Walk(walk) = &playback.play.tape else { panic!("a ray walks") };
    assert!(walk.hit.is_some(), "the first ray goes through the middle");
    assert!(harness.query_by_label_contains("field.obj").is_some());
}

#[test]
fn cancel_keeps_the_old_structure() {
    let mut harness = dropped("cancel", 160);
    let old = harness.state().state.playback().unwrap().clone();
    harness.state_mut().state.keep();
    harness.state_mut().state.set("max_depth", "30");
    harness.run_steps(1);
    assert!(!harness.state().state.is_current(), "a large structure is built beside the window");
    harness.key_press(Key::Escape);
    harness.run_steps(1);
    assert!(harness.state().state.is_current());
    assert!(Arc::ptr_eq(&old, harness.state().state.playback().unwrap()));
    harness.run_steps(20);
    assert!(Arc::ptr_eq(&old, harness.state().state.playback().unwrap()), "what was cancelled does not arrive later");
}

/// What the window says and shows at one moment.
fn moment(harness: &Window, old: &Arc<Playback>) -> (&'static str, &'static str) {
    let app = harness.state();
    let built = match (app.state.wanted().is_some(), app.is_idle()) {
        (true, _) if harness.query_by_label_contains("Building the structure").is_some() => "building",
        (true, _) => "wanted",
        (false, false) => "given up",
        (false, true) => "at rest",
    };
    let same = app.state.playback().is_some_and(|shown| Arc::ptr_eq(shown, old));
    let told = harness.query_by_label_contains("Your own mesh").is_none();
    (built, if same && told { "the old page" } else { "another page" })
}

/// The order of what happens is asserted; how long it took is printed.
#[test]
fn cancelling_a_build_of_a_million_triangles_keeps_the_old_page() {
    let mut harness = window("5/33");
    let old = harness.state().state.playback().unwrap().clone();
    let (before, undoable) = (harness.state().state.view.clone(), harness.state().state.undoable());
    let mesh = Arc::new(raystep_scene::Scene::named("teapot:126x126").unwrap());
    assert!(raystep_accel::Primitives::len(&mesh.prims) >= 1_000_000);
    let ray = raystep_accel::Ray::new(glam::Vec3::new(-6.0, -3.0, 3.6), glam::Vec3::new(6.1, 2.7, -2.0)).unwrap();
    let (mut free, mut gone) = (Vec::new(), Vec::new());
    for wait in [0, 200, 400, 800, 1600] {
        let mut order = vec![moment(&harness, &old)];
        let mut note = |harness: &Window| {
            let now = moment(harness, &old);
            if order.last() != Some(&now) {
                order.push(now);
            }
        };
        harness.state_mut().state.show_mesh(mesh.clone(), ray);
        harness.run_steps(2);
        note(&harness);
        std::thread::sleep(std::time::Duration::from_millis(wait));
        harness.run_steps(1);
        note(&harness);
        let start = std::time::Instant::now();
        harness.key_press(Key::Escape);
        harness.run_steps(1);
        free.push(start.elapsed().as_millis());
        note(&harness);
        until(&mut harness, App::is_idle);
        gone.push(start.elapsed().as_millis());
        harness.run_steps(2);
        note(&harness);
        // The builder may be gone before anybody looks.
        order.retain(|(built, _)| *built != "given up");
        assert_eq!(order, ["at rest", "building", "at rest"].map(|built| (built, "the old page")));
        assert!(harness.state().state.view.same_page(&before), "the same step of the same walk");
        assert_eq!(harness.state().state.undoable(), undoable, "nothing is there to be undone");
    }
    free.sort_unstable();
    gone.sort_unstable();
    println!("cancelled after (median of 5): the page {} ms, the builder {} ms", free[2], gone[2]);
}

#[test]
fn both_walks_stand_at_the_same_t() {
    use raystep::shown::{Beside, Pace};
    let mut harness = window("5/40");
    harness.state_mut().state.pace = Pace::T;
    harness.state_mut().state.compare("grid");
    until(&mut harness, |app| app.beside().is_some());
    let app = harness.state();
    assert_eq!(app.state.beside, Beside::Structure("grid"));
    let (tree, grid) = (app.state.playback().unwrap(), app.beside().unwrap());
    for step in 0..tree.steps().last() {
        let at = grid.step_at(tree.reached(step));
        assert!(grid.reached(at) <= tree.reached(step));
        assert!(at == grid.steps().last() || grid.reached(at + 1) > tree.reached(step));
    }
}
