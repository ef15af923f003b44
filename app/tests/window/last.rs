//! A window opens where one was: the slide, the stage, the ray, the step, the view, whatever ended it.

use std::path::{Path, PathBuf};

use egui_kittest::kittest::Queryable;
use raystep::shown::state::State;
use raystep::shown::{RayChoice, View, command::Command};
use raystep::window::{App, Remembered, Wishes};
use raystep_accel::{Grain, Ray};
use raystep_figure::Camera;
use raystep_lesson::StageKind;

use crate::window::{Window, library, sized, until};

/// A folder of this test's own, empty.
fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("last").join(name);
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).unwrap();
    path
}

/// A window with that file: it goes on where the file says, if nothing else is wished for.
fn window(file: &Path, wishes: Wishes) -> Window {
    let goes_on = wishes.slide.is_none();
    let mut harness = asking(file, wishes);
    if goes_on && harness.query_by_label("Begin here").is_some() {
        harness.key_press(egui::Key::Enter);
        harness.run_steps(2);
        settle(&mut harness);
    }
    harness
}

/// A window that asks whether to go on.
fn asking(file: &Path, wishes: Wishes) -> Window {
    let reopens = wishes.slide.is_none();
    let file = file.to_path_buf();
    let mut harness = sized([1280.0, 800.0]).build_eframe(move |context| {
        let mut app = App::wished(&context.egui_ctx, library(), wishes, Remembered::default());
        app.keep_in(file, reopens);
        app
    });
    settle(&mut harness);
    harness
}

/// Runs frames until everything that is asked for is there.
fn settle(harness: &mut Window) {
    let reads = |window: &Window| window.query_by_label_contains("Reading").is_some();
    until(harness, |window| window.state().state.is_current() && !reads(window));
}

/// What a window opens at again.
fn stands(state: &State) -> String {
    let View { slide, stage, ray, settings, camera, step, mesh, .. } = &state.view;
    let mesh = mesh.as_ref().map(|mesh| &mesh.name);
    let (grain, speed, present, by_hand, beside) =
        (state.grain, state.speed, state.present, state.by_hand, state.beside);
    format!(
        "{slide} {stage:?} {ray:?} {settings:?} {camera:?} step {step} {mesh:?} {grain:?} {speed} {present} {by_hand} {beside:?}"
    )
}

fn solid() -> Camera {
    let (eye, target, up) = (glam::Vec3::new(-6.1, -7.3, 4.4), glam::Vec3::new(0.1, 0.2, 1.0), glam::Vec3::Z);
    Camera::Solid { eye, target, up, fov_degrees: 31.7 }
}

#[test]
fn a_window_opens_where_one_was() {
    let file = folder("where").join("last.toml");
    let check = |slide: &str, change: &dyn Fn(&mut State)| {
        let mut first = window(&file, Wishes { slide: Some(slide.to_owned()), ..Wishes::default() });
        change(&mut first.state_mut().state);
        settle(&mut first);
        let stood = stands(&first.state().state);
        first.state_mut().close();
        drop(first);
        let second = window(&file, Wishes::default());
        assert_eq!(stands(&second.state().state), stood);
        assert_eq!(second.state().state.undoable(), (false, false), "{stood}: nobody has done anything yet");
    };
    check("5/33", &|_| {});
    check("5/33", &|state| state.open_at(9));
    check("5/33", &|state| state.show_ray(RayChoice::Named(2), false));
    check("5/33", &|state| state.show_stage(StageKind::Solid));
    check("3/20", &|state| {
        state.set("prune", "false");
        state.grain = Grain::Arithmetic;
        state.open_at(4);
    });
    check("7/56b", &|state| {
        state.show_stage(StageKind::Solid);
        state.look(Some(solid()));
        state.present = true;
    });
    check("5/40", &|state| {
        state.compare("grid");
        state.by_hand = true;
        state.apply(Command::Speed(7));
    });
    check("2/15", &|state| {
        let ray = Ray::new(glam::Vec3::new(0.1, -0.7, 0.0), glam::Vec3::new(1.0, 0.3, 0.0)).unwrap();
        state.show_ray(RayChoice::Own(ray), false);
        state.look(Some(Camera::Flat { center: glam::Vec2::new(1.0, 2.0), half_height: 3.5 }));
    });
    check("5/30", &|state| state.apply(Command::Last));
}

#[test]
fn a_window_that_was_not_closed_opens_again_as_well() {
    let file = folder("killed").join("last.toml");
    let mut first = window(&file, Wishes { slide: Some("5/33".to_owned()), ..Wishes::default() });
    first.state_mut().state.open_at(7);
    settle(&mut first);
    std::thread::sleep(std::time::Duration::from_millis(1100));
    first.run_steps(2);
    drop(first);
    let second = window(&file, Wishes::default());
    assert_eq!(second.state().state.view.step, 7);
    assert_eq!(second.state().state.slide().unwrap().id(), "5/33");
}

#[test]
fn it_is_asked_whether_to_go_on() {
    let file = folder("asked first").join("last.toml");
    let text = "link = \"5/34?stage=flat&step=13\"\n";
    std::fs::write(&file, text).unwrap();
    let asks =
        |harness: &Window| harness.query_by_label("Go on at 5/34 Inner node, inner node, leaf, step 13?").is_some();
    // Whoever only looks at the bar loses nothing.
    let mut harness = asking(&file, Wishes::default());
    assert!(asks(&harness));
    harness.state_mut().close();
    assert_eq!(std::fs::read_to_string(&file).unwrap(), text);
    // Whoever begins elsewhere is asked no more.
    harness.key_press(egui::Key::PageDown);
    harness.run_steps(2);
    settle(&mut harness);
    harness.run_steps(2);
    assert!(!asks(&harness));
    let here = harness.state().state.slide().unwrap().id();
    harness.state_mut().close();
    assert!(std::fs::read_to_string(&file).unwrap().contains(&here));
}

/// The file of a window that is to be killed, in the program that is.
const KILLED: &str = "RAYSTEP_KILLED";

#[test]
#[ignore = "a window that walks on until it is killed: `a_window_killed_at_any_moment` starts it"]
fn walks_until_it_is_killed() {
    let Some(file) = std::env::var_os(KILLED).map(PathBuf::from) else { return };
    let mut harness = window(&file, Wishes { slide: Some("5/33".to_owned()), ..Wishes::default() });
    let keys = [egui::Key::ArrowRight, egui::Key::ArrowRight, egui::Key::Y, egui::Key::ArrowLeft, egui::Key::PageDown];
    for turn in 0_usize.. {
        if turn > 0 {
            harness.key_press(keys[turn * turn % 7 % keys.len()]);
            harness.run_steps(1);
        }
        let state = &harness.state().state;
        if state.is_current() {
            println!("at {} {}", state.slide().unwrap().id(), state.view.step);
        }
        std::thread::sleep(std::time::Duration::from_millis(25));
    }
}

/// Kills a window so many times, each time at another moment: it must be found where it stood within the last second.
fn killed(times: u64) {
    use std::io::{BufRead, BufReader};
    use std::time::{Duration, Instant};
    let file = folder("killed at any moment").join("last.toml");
    let mut random = raystep_accel::Random::new(11);
    for turn in 0..times {
        let _ = std::fs::remove_file(&file);
        let mut program = std::process::Command::new(std::env::current_exe().unwrap());
        program.args(["--exact", "last::walks_until_it_is_killed", "--ignored", "--nocapture", "--test-threads=1"]);
        let mut child = program.env(KILLED, &file).stdout(std::process::Stdio::piped()).spawn().unwrap();
        let lines = BufReader::new(child.stdout.take().unwrap()).lines();
        let said = std::thread::spawn(move || {
            let at = |line: std::io::Result<String>| Some((Instant::now(), line.ok()?.strip_prefix("at ")?.to_owned()));
            lines.filter_map(at).collect::<Vec<_>>()
        });
        while !file.exists() {
            std::thread::sleep(Duration::from_millis(5));
        }
        std::thread::sleep(Duration::from_secs_f32(2.0 * random.unit()));
        child.kill().unwrap();
        let now = Instant::now();
        child.wait().unwrap();
        let said = said.join().unwrap();
        let text = std::fs::read_to_string(&file).unwrap();
        let (last, wrong) = raystep::window::Last::read(&text);
        assert!(wrong.is_empty(), "{turn}: {wrong:?}");
        let place = last.place(&library()).unwrap_or_else(|| panic!("{turn}: no place in {text}"));
        let names = |said: &str| {
            let (slide, step) = said.split_once(' ').unwrap();
            place.starts_with(&format!("{slide} ")) && place.ends_with(&format!(", step {step}"))
        };
        // A little more than a second: both programs share a machine with others.
        let late = said.iter().rposition(|(at, _)| now.duration_since(*at) > Duration::from_millis(1500)).unwrap_or(0);
        let recent: Vec<&String> = said[late..].iter().map(|(_, said)| said).collect();
        // Killed before it said anything, it stood where its slide opens.
        let opened = recent.is_empty() && place.starts_with("5/33 ");
        assert!(opened || recent.iter().any(|said| names(said)), "{turn}: {place} is none of {recent:?}");
    }
}

#[test]
fn a_window_killed_at_any_moment_is_found_where_it_stood() {
    killed(3);
}

#[test]
#[ignore = "takes minutes: a window is killed 200 times"]
fn a_window_killed_two_hundred_times_is_found_where_it_stood() {
    killed(200);
}

#[test]
fn a_slide_that_is_asked_for_wins() {
    let file = folder("asked").join("last.toml");
    let mut first = window(&file, Wishes { slide: Some("5/33".to_owned()), ..Wishes::default() });
    first.state_mut().state.present = true;
    first.state_mut().close();
    drop(first);
    let second = window(&file, Wishes { slide: Some("3/20".to_owned()), ..Wishes::default() });
    let state = &second.state().state;
    assert_eq!((state.slide().unwrap().id().as_str(), state.present), ("3/20", false));
}

#[test]
fn what_is_gone_or_makes_no_sense_is_left_out_and_said() {
    let file = folder("gone").join("last.toml");
    let good = "link = \"5/33?stage=flat&step=7\"\n";
    let check = |text: String, says: &str, slide: &str, step: usize| {
        std::fs::write(&file, &text).unwrap();
        let harness = window(&file, Wishes::default());
        let state = &harness.state().state;
        assert_eq!((state.slide().unwrap().id().as_str(), state.view.step), (slide, step), "{text}");
        assert_eq!(
            harness.query_all_by_label_contains("last.toml").count(),
            usize::from(says == "last.toml"),
            "{text}"
        );
        if !says.is_empty() {
            assert!(harness.query_by_label_contains(says).is_some(), "{text}: nobody says {says}");
        }
    };
    let opening = |slide: &str| {
        let harness =
            window(&folder("opening").join("last.toml"), Wishes { slide: Some(slide.to_owned()), ..Wishes::default() });
        harness.state().state.view.step
    };
    let first = library().slides[0].id();
    check(good.to_owned(), "", "5/33", 7);
    check(format!("zoom = 3\n{good}"), "last.toml", "5/33", 7);
    check(good.replace("step=7", "step=7&ray=of another lecture"), "", "5/33", 7);
    check(good.replace("step=7", "step=100000"), "", "5/33", opening_last("5/33"));
    check(good.replace("5/33", "5/99"), "", &first, opening(&first));
    check(format!("lessons = \"/nowhere\"\n{good}"), "", &first, opening(&first));
    check(good.replace("step=7", "step=7&mesh=/nowhere/gone.obj"), "/nowhere/gone.obj", "5/33", 0);
    check(good.replace("step=7", "step=7&set=max_depth:9999999&set=nx:3"), "last.toml", "5/33", 7);
}

/// The last step of a slide.
fn opening_last(slide: &str) -> usize {
    let file = folder("last step").join("last.toml");
    let harness = window(&file, Wishes { slide: Some(slide.to_owned()), ..Wishes::default() });
    harness.state().state.playback().unwrap().steps().last()
}

#[test]
fn a_mesh_is_opened_again() {
    let folder = folder("mesh");
    let (file, mesh) = (folder.join("last.toml"), folder.join("two.obj"));
    std::fs::write(&mesh, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 3 4\n").unwrap();
    let wishes = Wishes { slide: Some("5/33".to_owned()), mesh: Some(mesh), ..Wishes::default() };
    let mut first = window(&file, wishes);
    first.state_mut().state.open_at(3);
    first.state_mut().state.look(Some(solid()));
    settle(&mut first);
    let stood = stands(&first.state().state);
    assert!(stood.contains("two.obj"), "{stood}");
    first.state_mut().close();
    drop(first);
    let second = window(&file, Wishes::default());
    assert_eq!(stands(&second.state().state), stood);
}

/// A window at the place of a link.
fn linked(link: &str) -> Window {
    let wishes = Wishes { at: Some(link.parse().unwrap()), ..Wishes::default() };
    let mut harness = sized([1280.0, 800.0])
        .build_eframe(move |context| App::wished(&context.egui_ctx, library(), wishes, Remembered::default()));
    settle(&mut harness);
    harness
}

/// The link that Ctrl+L copies.
fn copied(harness: &mut Window) -> String {
    harness.key_press_modifiers(egui::Modifiers::COMMAND, egui::Key::L);
    harness.run_steps(2);
    let link = harness.state().link().to_string();
    let said = harness.query_by_label(&format!("The link is on the clipboard: {link}")).is_some();
    // A class sees no sentences.
    assert_ne!(said, harness.state().state.present, "{link}");
    link
}

#[test]
fn a_link_opens_the_same_place_in_another_window() {
    for link in [
        "5/33",
        "5/33?stage=solid&step=9",
        "2/15?own=0.1,-0.7,0,1,0.3,0&camera=1,2,3.5",
        "5/33?ray=from%20the%20right&step=6&set=max_depth:3&beside=grid&grain=visit&speed=2",
        "7/56b?stage=solid&step=5&camera=-6.1,-7.3,4.4,0.1,0.2,1,0,0,1,31.7&aspect=1.25&levels=2&hand=yes",
        "3/20?set=prune:false&step=4&present=yes",
    ] {
        let mut first = linked(link);
        let (stood, copy) = (stands(&first.state().state), copied(&mut first));
        let mut second = linked(&copy);
        assert_eq!(stands(&second.state().state), stood, "{link}: {copy}");
        assert_eq!(copied(&mut second), copy, "{link}");
    }
}

#[test]
fn a_link_that_is_pasted_into_the_palette_is_followed() {
    let mut harness = linked("5/33");
    let mut paste = |text: &str| {
        harness.key_press_modifiers(egui::Modifiers::COMMAND, egui::Key::K);
        harness.run_steps(2);
        harness.event(egui::Event::Paste(text.to_owned()));
        harness.run_steps(2);
        let said = harness.query_by_label_contains("This link leads nowhere").is_some();
        harness.key_press(egui::Key::Enter);
        harness.run_steps(2);
        if said {
            harness.key_press(egui::Key::Escape);
            harness.run_steps(2);
        }
        settle(&mut harness);
        let state = &harness.state().state;
        (state.slide().unwrap().id(), state.view.step, said)
    };
    assert_eq!(paste("5/40?stage=flat&step=3"), ("5/40".to_owned(), 3, false));
    assert_eq!(paste("5/99?step=3"), ("5/40".to_owned(), 3, true));
    assert_eq!(paste("5/33?stepp=3"), ("5/40".to_owned(), 3, true));
    assert_eq!(paste("https://a.b/c.html#5/33?step=7&stage=flat"), ("5/33".to_owned(), 7, false));
}

#[test]
fn a_question_is_found_again_as_it_was() {
    let check = |commands: &[Command], says: &str| {
        let mut first = linked("5/33?ray=both%20children&present=yes");
        while first.state().state.question().is_none() {
            first.state_mut().state.apply(Command::Onward);
            settle(&mut first);
        }
        for command in commands {
            first.state_mut().state.apply(*command);
        }
        first.run_steps(2);
        let (stood, copy) = (stands(&first.state().state), copied(&mut first));
        assert!(copy.contains(says), "{copy}");
        let second = linked(&copy);
        let (there, here) = (&second.state().state, &first.state().state);
        assert_eq!((stands(there), there.asked(), there.answered), (stood, here.asked(), here.answered), "{copy}");
        assert_eq!(there.question().is_some(), here.question().is_some(), "{copy}");
    };
    check(&[], "question=open");
    check(&[Command::Onward], "answers=");
    let first = linked("5/33?ray=both%20children&present=yes");
    let posed = &first.state().state.playback().unwrap().posed[0];
    let wrong = posed.choices.iter().position(|choice| !choice.right).unwrap();
    check(&[Command::Answer(wrong as u8)], "question=open&answers=");
    check(&[Command::Answer(wrong as u8), Command::Onward], "answers=");
}
