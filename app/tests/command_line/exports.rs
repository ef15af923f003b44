//! Pictures to take away, as `raystep export` writes them.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use super::{folder, raystep, refused, text};

/// What an export wrote: names and bytes of its files.
fn written(folder: &Path, arguments: &[&str]) -> BTreeMap<String, Vec<u8>> {
    let out = folder.join("out");
    let _ = std::fs::remove_dir_all(&out);
    let output = raystep(folder, &[&["export", "--out", "out"], arguments].concat());
    assert!(output.status.success(), "{arguments:?}: {}", text(&output.stderr));
    let entries = std::fs::read_dir(&out).unwrap().map(|entry| entry.unwrap());
    entries.map(|entry| (text(entry.file_name().as_encoded_bytes()), std::fs::read(entry.path()).unwrap())).collect()
}

/// The one file that an export wrote.
fn only(folder: &Path, arguments: &[&str]) -> (String, Vec<u8>) {
    let mut files = written(folder, arguments);
    assert_eq!(files.len(), 1, "{arguments:?}: {:?}", files.keys());
    files.pop_first().unwrap()
}

/// Width and height of a PNG file.
fn size(bytes: &[u8]) -> (u32, u32) {
    let reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
    (reader.info().width, reader.info().height)
}

#[test]
fn a_view_is_drawn_where_there_is_one_and_else_those_that_are_there_are_named() {
    let folder = folder("views");
    for (slide, step, there) in [
        ("5/33", "9", "plate, space, tree, t, slabs, bytes, stack, listing, work, changed, timeline"),
        ("3/20", "5", "plate, space, t, cells, slabs, listing, work, changed, timeline"),
        ("1/5", "1", "plate, space, timeline"),
    ] {
        let views: Vec<&str> = there.split(", ").collect();
        let all = "plate, space, tree, t, cells, matrix, slabs, bytes, stack, listing, work, changed, timeline, chart, \
                   table, numbers, heat, pictures";
        let call =
            ["export", "--slide", slide, "--stage", "flat", "--steps", step, "--size", "320x200", "--format", "svg"];
        for view in all.split(", ") {
            if views.contains(&view) {
                let output = raystep(&folder, &[&call[..], &["--view", view, "--out", view]].concat());
                assert!(output.status.success(), "{slide} {view}: {}", text(&output.stderr));
                let file = std::fs::read_dir(folder.join(view)).unwrap().last().unwrap().unwrap().path();
                let drawing = std::fs::read_to_string(&file).unwrap();
                assert!(drawing.matches("<g class=").count() > 1, "{slide} {view} is blank");
                assert!(drawing.contains("width=\"320\" height=\"200\""), "{slide} {view} has another size");
            } else {
                let says = format!("has no view \"{view}\"; there are {there}");
                refused(&folder, &[&call[..], &["--view", view, "--out", "none"]].concat(), &says);
            }
        }
    }
    assert!(!folder.join("none").exists(), "nothing is written where nothing is drawn");
}

#[test]
fn names_of_files_say_what_is_not_as_usual() {
    let folder = folder("file-names");
    let one = ["--slide", "5/33", "--stage", "flat", "--steps", "2"];
    let step = "step0002of0040";
    for (more, name) in [
        (&[][..], format!("slide33-which-child-first-flat-{step}.png")),
        (&["--view", "t", "--theme", "dark"], format!("slide33-which-child-first-flat-t-dark-{step}.png")),
        (
            &["--view", "stack", "--size", "300x200", "--format", "svg", "--text", "real"],
            format!("slide33-which-child-first-flat-stack-300x200-text-{step}.svg"),
        ),
        (
            &["--view", "t", "--size", "300x200", "--crop", "--transparent", "--format", "pdf"],
            format!("slide33-which-child-first-flat-t-300x200-cropped-transparent-{step}.pdf"),
        ),
        (
            &["--panes", "title,space,t", "--legend", "off", "--format", "svg"],
            format!("slide33-which-child-first-flat-title-space-t-no-legend-{step}.svg"),
        ),
        (
            &["--rule", "max_depth=2", "--view", "work", "--size", "64x64"],
            "slide33-which-child-first-flat-max-depth-2-work-64x64-step0002of0030.png".to_owned(),
        ),
    ] {
        assert_eq!(only(&folder, &[&one[..], more].concat()).0, name);
    }
}

#[test]
fn a_picture_is_as_large_as_asked_and_cropped_no_larger() {
    let folder = folder("sizes");
    let call = |view, side| ["--slide", "5/33", "--stage", "flat", "--steps", "9", "--view", view, "--size", side];
    for view in ["space", "stack", "t", "plate"] {
        for (side, exact) in [("333x221", (333, 221)), ("120x400", (120, 400))] {
            assert_eq!(size(&only(&folder, &call(view, side)).1), exact, "{view}");
            let (width, height) = size(&only(&folder, &[&call(view, side)[..], &["--crop"]].concat()).1);
            assert!(width <= exact.0 && height <= exact.1, "{view}: {width}x{height}");
        }
    }
    let (_, clear) = only(&folder, &[&call("stack", "200x200")[..], &["--transparent"]].concat());
    let mut reader = png::Decoder::new(std::io::Cursor::new(&clear)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut pixels).unwrap();
    assert!(pixels[3] == 0 && pixels.chunks_exact(4).any(|pixel| pixel[3] == 255));
}

#[test]
fn films_hold_all_steps_of_the_grain() {
    let folder = folder("films");
    let call = ["--slide", "5/33", "--stage", "flat", "--ray", "both children, far hit", "--size", "160x100"];
    let frames = |more: &[&str]| {
        let (_, bytes) = only(&folder, &[&call[..], &["--format", "apng"], more].concat());
        let reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
        reader.info().animation_control().unwrap().num_frames
    };
    let (all, decisions, visits) = (frames(&["--grain", "arithmetic"]), frames(&[]), frames(&["--grain", "visit"]));
    assert!(all > decisions && decisions > visits && visits > 4, "{all} {decisions} {visits}");
    assert_eq!(frames(&["--grain", "arithmetic", "--steps", "3..6"]), 4);
    let (name, gif) = only(&folder, &[&call[..], &["--format", "gif", "--steps", "0..9", "--delay", "200"]].concat());
    assert_eq!(name, "slide33-which-child-first-flat-160x100-step0000to0009.gif");
    assert!(gif.starts_with(b"GIF89a"));
    let again = only(&folder, &[&call[..], &["--format", "gif", "--steps", "0..9", "--delay", "200"]].concat());
    assert!(gif == again.1, "the same to the byte");

    let video = [&call[..], &["--format", "mp4", "--steps", "0..3"]].concat();
    let ffmpeg = Command::new("ffmpeg").arg("-version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    if ffmpeg.is_ok_and(|status| status.success()) {
        let (_, first) = only(&folder, &video);
        assert_eq!(&first[4..8], b"ftyp");
        assert!(first == only(&folder, &video).1, "the same to the byte");
    }
    // Every picture stays as long as it says, also the last one: four pictures, the last three times as long.
    for format in ["mp4", "webm"] {
        let (name, _) = match Command::new("ffprobe").arg("-version").stdout(Stdio::null()).status() {
            Ok(_) => only(&folder, &[&call[..], &["--format", format, "--steps", "0..3", "--delay", "400"]].concat()),
            Err(_) => continue,
        };
        let shown =
            ["-v", "error", "-count_frames", "-of", "csv=p=0", "-show_entries", "stream=nb_read_frames,color_space"];
        let told = Command::new("ffprobe").args(shown).arg(&name).current_dir(folder.join("out")).output().unwrap();
        assert_eq!(text(&told.stdout).trim(), "bt709,60", "{name}: {}", text(&told.stderr));
    }
    // Where there is no ffmpeg nothing is begun.
    let lonely = Command::new(env!("CARGO_BIN_EXE_raystep"))
        .args([&["export", "--out", "lonely"], &video[..]].concat())
        .current_dir(&folder)
        .env("PATH", &folder)
        .output()
        .unwrap();
    let said = text(&lonely.stderr);
    assert!(lonely.status.code() == Some(2) && said.contains("install it, or write --format gif or apng"), "{said}");
    assert!(!folder.join("lonely").exists());
}

#[test]
fn any_walk_becomes_a_picture() {
    let folder = folder("own-walks");
    std::fs::write(folder.join("square.obj"), super::SQUARE).unwrap();
    let small = ["--size", "160x100", "--format", "svg"];
    for (own, name) in [
        (
            &["--scene", "flat-twelve", "--structure", "kd", "--rule", "max_depth=3", "--ray", "0.1,1.2,0,7.9,2.8,0"][..],
            "-kd-max-depth-3-own-ray-",
        ),
        (&["--mesh", "square.obj", "--structure", "bvh", "--ray", "1.5,0.5,5,0,0,-1"], "square-bvh-own-ray-"),
        (
            &["--mesh", "square.obj", "--structure", "grid", "--pixel", "80,50", "--camera", "close"],
            "square-grid-camera-close-own-ray-",
        ),
        (&["--scene", "flat-twelve", "--structure", "grid", "--build"], "-grid-build-160x100-step"),
        (&["--slide", "5/33", "--ray", "0.1,1.2,0,7.9,2.8,0"], "slide33-which-child-first-flat-own-ray-"),
    ] {
        let files = written(&folder, &[own, &small].concat());
        assert!(!files.is_empty() && files.keys().all(|file| file.contains(name)), "{own:?}: {:?}", files.keys());
        let plate = text(files.values().next().unwrap());
        assert!(plate.contains(if own[0] == "--slide" { "Which child" } else { " over " }), "{own:?}");
    }
    let flat = ["export", "--out", "none", "--scene", "flat-twelve"];
    let kd = [&flat[..], &["--structure", "kd"]].concat();
    for (call, says) in [
        ([&flat[..], &["--ray", "0,1,0,1,0,0"]].concat(), "--structure"),
        (kd.clone(), "say which ray walks: --ray OX,OY,OZ,DX,DY,DZ"),
        ([&kd[..], &["--pixel", "8,5"]].concat(), "is flat, and a ray through a pixel would fall onto it"),
        ([&kd[..], &["--ray", "0,1,2,1,0,0"]].concat(), "a ray in its plane has z 0"),
        ([&kd[..], &["--ray", "0,1,0,1,0,0", "--camera", "close"]].concat(), "a camera is for solid scenes"),
        ([&kd[..], &["--ray", "0,1,0,1,0,0", "--rule", "depth=3"]].concat(), "max_depth"),
        ([&kd[..], &["--ray", "0,1,0,1,0,0", "--slide", "5/33"]].concat(), "cannot be used with"),
        ([&kd[..], &["--ray", "0,1,0,1,0,0", "--text", "real"]].concat(), "only an SVG file has letters as text"),
        ([&kd[..], &["--ray", "0,1,0,1,0,0", "--panes", "space,stac"]].concat(), "there is no pane \"stac\""),
        (
            [&kd[..], &["--ray", "0,1,0,1,0,0", "--format", "mp4", "--size", "99x99"]].concat(),
            "an even number of pixels",
        ),
    ] {
        refused(&folder, &call, says);
    }
    assert!(!folder.join("none").exists());
}

#[test]
fn the_place_of_a_link_becomes_a_picture() {
    let folder = folder("linked");
    let small = ["--size", "160x100", "--format", "svg"];
    for (link, name, says) in [
        ("5/33?ray=from%20the%20right&step=6", "slide33-which-child-first-flat-from-the-right-160x100-step0006", ""),
        ("5/33?stage=flat&step=6&set=max_depth:3", "slide33-which-child-first-flat-max-depth-3-160x100-step0006", ""),
        ("5/33?own=0.1,1.2,0,7.9,2.8,0&step=4&camera=4,2,1.5&aspect=1.4", "-camera-linked-", ""),
        ("5/33?step=3&shape=2:3,1,0.25", "slide33-which-child-first-flat-", ""),
        ("5/33?step=3&beside=grid", "-step0003", "--at: what stands beside is left out"),
    ] {
        let output = raystep(&folder, &[&["export", "--out", "said", "--at", link][..], &small].concat());
        assert!(text(&output.stderr).contains(says), "{link}: {}", text(&output.stderr));
        let (file, _) = only(&folder, &[&["--at", link][..], &small].concat());
        assert!(file.contains(name), "{link}: {file}");
    }
    // Two views of one place are two pictures.
    let from =
        |camera: &str| only(&folder, &[&["--at", &format!("5/33?step=4&camera={camera}")][..], &small].concat()).0;
    assert_ne!(from("4,2,1.5"), from("4,2,3"));
    // Without a step, all that the beats say on this ray.
    assert!(written(&folder, &[&["--at", "5/33?ray=from%20the%20right"][..], &small].concat()).len() > 3);
    for (link, says) in [
        ("5/99?step=3", "--at: there is no slide \"5/99\""),
        ("5/33?step=x", "step=x: a whole number"),
        ("5/33?ray=nobody", "--at: slide 5/33 has no ray \"nobody\""),
        ("5/33?mesh=teapot.obj", "--at: a mesh is drawn by --mesh teapot.obj"),
        ("5/33?example=unclipped", "example=unclipped: there are"),
    ] {
        refused(&folder, &["export", "--out", "none", "--at", link], says);
    }
    refused(&folder, &["export", "--out", "none", "--at", "5/33", "--slide", "5/33"], "cannot be used with");
    assert!(!folder.join("none").exists());
}

#[test]
fn two_programs_that_write_one_file_do_not_mix() {
    let folder = folder("at-once");
    let call = ["export", "--slide", "5/33", "--stage", "flat", "--steps", "0..5", "--view", "t", "--format", "svg"];
    let run = || {
        let mut command = Command::new(env!("CARGO_BIN_EXE_raystep"));
        command.args(call).args(["--out", "out"]).current_dir(&folder).stderr(Stdio::null());
        command.spawn().unwrap()
    };
    let alone = written(&folder, &call[1..]);
    let programs: Vec<_> = (0..3).map(|_| run()).collect();
    for mut program in programs {
        assert!(program.wait().unwrap().success());
    }
    let found: Vec<_> = std::fs::read_dir(folder.join("out")).unwrap().map(|entry| entry.unwrap().path()).collect();
    assert_eq!(found.len(), alone.len(), "{found:?}");
    for path in found {
        let name = text(path.file_name().unwrap().as_encoded_bytes());
        assert!(alone[&name] == std::fs::read(&path).unwrap(), "{name}");
    }
}

#[test]
fn a_slide_is_drawn_twice_with_the_same_bytes() {
    let folder = folder("export");
    let call = |format: &str, out: &str| {
        let arguments = [
            "export", "--slide", "5/33", "--stage", "flat", "--size", "640x400", "--steps", "1..2", "--format", format,
            "--out", out,
        ];
        let output = raystep(&folder, &arguments);
        assert!(output.status.success(), "{}", text(&output.stderr));
        let mut files: Vec<PathBuf> =
            std::fs::read_dir(folder.join(out)).unwrap().map(|entry| entry.unwrap().path()).collect();
        files.sort();
        files
            .into_iter()
            .map(|file| (file.file_name().unwrap().to_owned(), std::fs::read(&file).unwrap()))
            .collect::<Vec<_>>()
    };
    for (format, count) in [("png", 2), ("svg", 2), ("pdf", 2), ("apng", 1), ("gif", 1), ("json", 1)] {
        let first = call(format, &format!("{format}-first"));
        assert_eq!(first.len(), count);
        assert!(first == call(format, &format!("{format}-again")), "{format} differs");
    }
}
