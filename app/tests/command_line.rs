//! The command line, as its users call it.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

#[path = "command_line/exports.rs"]
mod exports;

/// A folder of this test's own, empty.
fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).unwrap();
    path
}

/// Calls Raystep in a folder, without a display.
fn raystep(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_raystep"))
        .args(arguments)
        .current_dir(folder)
        .env_remove("DISPLAY")
        .env_remove("WAYLAND_DISPLAY")
        .output()
        .unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// A refused call: exit code 2 and a sentence that holds `says`.
fn refused(folder: &Path, arguments: &[&str], says: &str) {
    let output = raystep(folder, arguments);
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {said}");
    assert!(said.contains(says), "{arguments:?}: {said}");
}

const SQUARE: &str = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n";

const RAYS: &str = "ox,oy,oz,dx,dy,dz,t_min,t_max\n\
                    1.5,0.5,5,0,0,-1,0,inf\n\
                    0.5,1.5,5,0,0,-1,,\n\
                    9,9,5,0,0,-1,0,inf\n\
                    0,0,5,0,0,0,0,inf\n\
                    0,zero,5,0,0,-1,0,inf\n\
                    1.5,0.5,5,0,0,-1,0,2\n";

#[test]
fn every_structure_answers_a_table_of_rays() {
    let folder = folder("trace");
    std::fs::write(folder.join("square.obj"), SQUARE).unwrap();
    std::fs::write(folder.join("rays.csv"), RAYS).unwrap();
    for kind in ["list", "grid", "kd", "bvh"] {
        let arguments =
            ["trace", "--mesh", "square.obj", "--structure", kind, "--rays", "rays.csv", "--out", "hits.csv"];
        let output = raystep(&folder, &arguments);
        assert!(output.status.success(), "{}", text(&output.stderr));
        let hits = std::fs::read_to_string(folder.join("hits.csv")).unwrap();
        let rows: Vec<&str> = hits.lines().collect();
        assert_eq!(rows[0], "ray,hit,t,prim,prim_tests,node_visits,cell_steps,box_tests");
        let begins = [
            "0,true,5,",
            "1,true,5,",
            "2,false,,,",
            "3,unusable: the direction is zero",
            "4,\"unusable: oy is \"\"zero\"\", not a number\"",
            "5,false,,,",
        ];
        assert_eq!(rows.len(), begins.len() + 1, "{hits}");
        for (row, begin) in rows[1..].iter().zip(begins) {
            assert!(row.starts_with(begin), "{kind}: {row}");
        }
    }
}

#[test]
fn one_walk_is_written_as_json() {
    let folder = folder("json");
    let walk = |arguments: &[&str]| {
        let output = raystep(&folder, &[&["trace", "--format", "json", "--structure", "kd"], arguments].concat());
        assert!(output.status.success(), "{}", text(&output.stderr));
        serde_json::from_slice::<serde_json::Value>(&output.stdout).unwrap()
    };
    let walked = walk(&["--scene", "flat-twelve", "--ray", "0.1,1.2,0,7.9,2.8,0"]);
    assert_eq!(walked["format"], "raystep-walk");
    assert!(walked["structure"]["parameters"]["max_depth"].is_string() && walked["origin"].is_null(), "{walked}");
    assert_eq!(walked["ray"]["o"], serde_json::json!([0.1, 1.2, 0.0]));
    assert!(walked["hit"]["t"].as_f64().unwrap() < 1.0, "{walked}");
    // As in the README.
    let walked = walk(&["--scene", "teapot-6321", "--rule", "split=sah", "--pixel", "800,500"]);
    assert!(walked["hit"]["t"].is_number(), "{}", walked["hit"]);
    // Coordinates of a file that are moved: the ray stands there as it was given.
    std::fs::write(folder.join("survey.obj"), SURVEY).unwrap();
    let walked = walk(&["--mesh", "survey.obj", "--ray", "465812.4,5247903.5,412.6,0,0,-1"]);
    assert_eq!(walked["origin"], serde_json::json!([465812.5, 5247903.5, 412.5]));
    let o = [465_812.4, 5_247_903.5, 412.6];
    assert!(
        o.iter().zip(walked["ray"]["o"].as_array().unwrap()).all(|(o, read)| (o - read.as_f64().unwrap()).abs() < 1e-6)
    );
    assert!((walked["hit"]["t"].as_f64().unwrap() - 0.1).abs() < 1e-6, "{}", walked["hit"]);
}

/// A square of half a metre in the coordinates of a survey.
const SURVEY: &str = "v 465812.13 5247903.21 412.5\nv 465812.63 5247903.21 412.5\nv 465812.63 5247903.71 412.5\n\
                      v 465812.13 5247903.71 412.5\nf 1 2 3\nf 1 3 4\n";

#[test]
fn odd_files_are_read_and_what_was_left_out_is_said() {
    let folder = folder("odd");
    let down = "ox,oy,oz,dx,dy,dz\n1,1,10,0,0,-1\n2.5,0.5,10,0,0,-1\n0.5,3.9,10,0,0,-1\n";
    let triangle = "v 0 0 1\nv 4 0 1\nv 0 4 1\n";
    let hits = "true,9 true,9 false,";
    let twisted = "v 0 0 0\nv 2 0 0\nv 0 0 2\nv 2 0 2\nf 1 2 3 4\n";
    let upright = "ox,oy,oz,dx,dy,dz\n1,-5,0.2,0,1,0\n1,-5,1.8,0,1,0\n0.3,-5,1.85,0,1,0\n";
    let survey = "ox,oy,oz,dx,dy,dz\n465812.4,5247903.74,500,0,0,-1\n465812.4,5247903.70,412.75,0,0,-1\n";
    let quote = "ox,oy,oz,dx,dy,dz\n1,1,10,0,0,-1\n1,1,10,0,0,\"-1\n1,1,10,0,0,\"-1\"\n";
    let around = format!("{triangle}f{}\n", " 1 2 3".repeat(2000));
    let open = "unusable: a quotation mark is opened and not closed,";
    for (name, mesh, rays, met, says) in [
        (
            "missing texture",
            &*format!("{triangle}f 1/1 2/2 3/3"),
            down,
            hits,
            "1 face names texture coordinates that are not there",
        ),
        (
            "normal 0",
            &format!("{triangle}vn 0 0 1\nf 1//1 2//0 3//1"),
            down,
            hits,
            "1 face names normals that are not there",
        ),
        (
            "weights",
            &format!("{triangle}vw 0 0 1\nf 1 2 3"),
            down,
            hits,
            "1 line passed over: `vw` is no keyword of OBJ",
        ),
        (
            "no face uses it",
            &format!("{triangle}v 0 0 -1.#IND00\nf 1 2 3"),
            down,
            hits,
            "1 vertex that no face uses left out",
        ),
        ("around and around", &around, down, hits, "1 polygon cut into triangles"),
        ("twisted wall", twisted, upright, "true,5 true,5 true,5", "1 polygon with edges that cross"),
        ("survey", SURVEY, survey, "false, true,0.25", "coordinates were moved by (-465812.5, -5247903.5, -412.5)"),
        ("open quotation mark", SQUARE, quote, &format!("true,10 {open} true,10"), "1 of 3 rows are no rays"),
    ] {
        std::fs::write(folder.join("odd.obj"), mesh).unwrap();
        std::fs::write(folder.join("odd.csv"), rays).unwrap();
        for kind in ["list", "grid", "kd", "bvh"] {
            let call = ["trace", "--mesh", "odd.obj", "--rays", "odd.csv", "--format", "csv", "--structure", kind];
            let output = raystep(&folder, &call);
            let (table, said) = (text(&output.stdout), text(&output.stderr));
            assert!(output.status.success() && said.contains(says), "{name}: {said}");
            let rows =
                table.lines().skip(1).map(|row| row.splitn(4, ',').skip(1).take(2).collect::<Vec<_>>().join(","));
            assert_eq!(rows.collect::<Vec<_>>().join(" "), met, "{name} {kind}: {said}");
        }
    }
    std::fs::write(folder.join("odd.obj"), format!("{triangle}v 4 4 -1.#IND00\nf 1 2 3\nf 2 4 3\n")).unwrap();
    let trace = ["trace", "--mesh", "odd.obj", "--structure", "kd"];
    refused(&folder, &[&trace[..], &["--rays", "odd.csv"]].concat(), "odd.obj:4:7: `-1.#IND00` is not a number");
}

#[test]
fn what_has_no_end_is_refused() {
    let folder = folder("endless");
    std::fs::write(folder.join("square.obj"), SQUARE).unwrap();
    refused(&folder, &["measure", "--size", "16384x16384"], "16384x16384 are too many pixels");
    if cfg!(unix) {
        let trace = |mesh, rays| ["trace", "--structure", "kd", "--mesh", mesh, "--rays", rays];
        refused(&folder, &trace("/dev/zero", "rays.csv"), "/dev/zero: it is a device; a file is needed");
        refused(&folder, &trace("square.obj", "/dev/zero"), "/dev/zero: it is a device; a file is needed");
    }
}

#[test]
fn what_cannot_be_done_is_said_in_a_sentence() {
    let folder = folder("refused");
    std::fs::write(folder.join("square.obj"), SQUARE).unwrap();
    std::fs::write(folder.join("rays.csv"), RAYS).unwrap();
    std::fs::write(folder.join("header.csv"), "x,y,z\n1,2,3\n").unwrap();
    std::fs::write(folder.join("empty.obj"), "").unwrap();
    let trace = |mesh, structure, rays| ["trace", "--mesh", mesh, "--structure", structure, "--rays", rays];
    refused(&folder, &trace("none.obj", "kd", "rays.csv"), "none.obj");
    refused(&folder, &trace("empty.obj", "kd", "rays.csv"), "empty.obj");
    refused(&folder, &trace("square.obj", "kt", "rays.csv"), "did you mean \"kd\"?");
    refused(&folder, &trace("square.obj", "kd", "header.csv"), "header.csv:1:1");
    refused(&folder, &[&trace("square.obj", "kd", "rays.csv")[..], &["--rule", "max_dept=3"]].concat(), "max_depth");
    refused(&folder, &[&trace("square.obj", "kd", "rays.csv")[..], &["--format", "xls"]].concat(), "text, md, latex");
    let flat = ["trace", "--scene", "flat-twelve", "--structure", "kd"];
    refused(&folder, &[&flat[..], &["--pixel", "800,500"]].concat(), "--ray 0,1,0,1,0.5,0");
    refused(&folder, &[&flat[..], &["--ray", "0,1,0,1,0.5"]].concat(), "--ray 0,1,0,1,0.5: 6 numbers are needed");
    refused(&folder, &[&flat[..], &["--ray", "0,1,0,0,0,0"]].concat(), "the direction is zero");
    refused(&folder, &["export", "--slide", "99/1", "--out", "pictures"], "there is no slide");
    refused(&folder, &["export", "--slide", "5/33", "--ray", "nobody", "--out", "pictures"], "no ray");
    refused(&folder, &["export", "--slide", "5/33", "--size", "9", "--out", "pictures"], "1600x1000");
    refused(&folder, &["nonsense.obj"], "no such file");
    let trace = ["trace", "--scene", "flat-twelve", "--pixel", "800,500", "--structure"];
    refused(&folder, &[&trace[..], &["slab"]].concat(), "only tests the box");
    refused(&folder, &["measure", "--also", "slab"], "only tests the box");
}

#[test]
fn structures_are_verified() {
    let folder = folder("verify");
    let output = raystep(&folder, &["verify", "--rays", "10000", "--seed", "5"]);
    let said = text(&output.stdout);
    assert!(output.status.success(), "{said}{}", text(&output.stderr));
    assert!(said.contains("10,000 rays over"), "{said}");
    // Kind, rules, answers, differences.
    for kind in ["grid", "kd", "octree", "bvh"] {
        let row = said.lines().find(|line| line.starts_with(kind)).unwrap_or_else(|| panic!("{said}"));
        assert!(row.ends_with(" 0"), "{row}");
    }
    assert!(std::fs::read_dir(&folder).unwrap().next().is_none(), "nothing differs, so nothing is kept");
    let output = raystep(&folder, &["verify", "--watertight", "--rays", "400", "--structure", "bvh"]);
    assert!(output.status.success() && text(&output.stdout).contains(": 0 lost."), "{}", text(&output.stdout));
    refused(&folder, &["verify", "--structure", "kt"], "did you mean \"kd\"?");
    refused(&folder, &["verify", "--structure", "list"], "brute force is the judge");
    refused(&folder, &["verify", "--structure", "slab"], "only tests the box");
    refused(&folder, &["verify", "--rays", "0"], "--rays");
    refused(&folder, &["verify", "--replay", "none.csv"], "none.csv");
}

/// What is stopped by Ctrl+C was not done: it says how far it came, and the exit code is not 0.
#[test]
#[cfg(unix)]
fn a_verification_that_is_stopped_ends_soon_and_fails() {
    use std::io::{BufRead, BufReader, Read};
    let folder = folder("stopped");
    for more in [&[][..], &["--in-turn"], &["--watertight"]] {
        // More rays than anybody waits for.
        let mut child = Command::new(env!("CARGO_BIN_EXE_raystep"))
            .args([&["verify", "--rays", "1000000000"], more].concat())
            .current_dir(&folder)
            .stdout(std::process::Stdio::piped())
            .stderr(std::process::Stdio::piped())
            .spawn()
            .unwrap();
        let mut first = String::new();
        let mut out = BufReader::new(child.stdout.take().unwrap());
        out.read_line(&mut first).unwrap();
        assert!(first.contains("1,000,000,000 rays"), "{first}");
        let killed = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
        assert!(killed.success());
        let mut rest = String::new();
        out.read_to_string(&mut rest).unwrap();
        let output = child.wait_with_output().unwrap();
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{more:?}: {said}");
        assert!(said.contains("raystep: stopped after"), "{more:?}: {said}");
        assert!(rest.contains("Stopped after"), "{more:?}: {rest}");
    }
}

/// Lines without what differs from run to run or when a structure is added: figures become `#`, kinds of their own go.
fn shape_of(page: &str) -> String {
    let lines = page.lines().filter(|line| !line.is_empty());
    let plain = lines.take_while(|line| !line.starts_with("Structures that")).map(|line| {
        let words = line.split_whitespace().map(|word| {
            let is_figure = word.chars().all(|c| c.is_ascii_digit() || ".,-".contains(c));
            if is_figure && word != "-" { "#" } else { word }
        });
        words.collect::<Vec<_>>().join(" ")
    });
    plain.collect::<Vec<_>>().join("\n")
}

#[test]
fn the_lectures_tables_are_measured() {
    let folder = folder("measure");
    let output = raystep(&folder, &["measure", "--size", "24x18"]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    insta::assert_snapshot!(shape_of(&text(&output.stdout)));

    let output =
        raystep(&folder, &["measure", "--size", "16x16", "--shadows", "--format", "json", "--also", "kd split=median"]);
    let rows: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let row = |name: &str| rows.as_array().unwrap().iter().find(|row| row["row"] == name).unwrap().clone();
    assert_eq!(row("list")["printed"], 6321.0);
    assert_eq!(row("kd-32-2")["printed"], 2.8);
    assert!(row("kd split=median")["printed"].is_null());
    assert!(row("kd-8-10")["tests_per_ray"].as_f64().unwrap() > row("kd-32-2")["tests_per_ray"].as_f64().unwrap());

    let output = raystep(&folder, &["measure", "--growth", "--finest", "3", "--size", "16x16"]);
    let said = text(&output.stdout);
    assert!(said.contains("tests: exponent 1.00") && said.contains("Needles through one point"), "{said}");

    refused(&folder, &["measure", "--scene", "teapot"], "there is no scene");
    refused(&folder, &["measure", "--camera", "far"], "write close, scene, or six numbers");
    refused(&folder, &["measure", "--also", "kd depth=3"], "max_depth");
    refused(&folder, &["measure", "--format", "xls"], "[possible values: text, md, latex, csv, json]");
}

#[test]
fn lessons_are_checked() {
    let folder = folder("check");
    let fine = raystep(&folder, &["check"]);
    assert_eq!((fine.status.code(), text(&fine.stdout), text(&fine.stderr)), (Some(0), String::new(), String::new()));
    let section = folder.join("05-kd-tree");
    std::fs::create_dir_all(&section).unwrap();
    std::fs::write(section.join("33-wrong.md"), "+++\nformat = 1\nslide = [33]\ntitel = \"Wrong\"\n+++\n").unwrap();
    refused(&folder, &["check", "05-kd-tree/33-wrong.md"], "05-kd-tree/33-wrong.md:4:1");
}

#[test]
fn texts_and_formulas_are_checked_as_they_are_set() {
    let folder = folder("check-texts");
    let [section, listings] = ["05-kd-tree", "listings"].map(|name| folder.join(name));
    std::fs::create_dir_all(&section).unwrap();
    std::fs::create_dir_all(&listings).unwrap();
    let lessons = Path::new(env!("CARGO_MANIFEST_DIR")).join("../lessons");
    std::fs::copy(lessons.join("listings/kd-walk.txt"), listings.join("kd-walk.txt")).unwrap();
    let slide = std::fs::read_to_string(lessons.join("05-kd-tree/40-grid-or-tree.md")).unwrap();
    // One after the other in the place of a beat's second sentence.
    let said = |text: &str| {
        let sentence = "A grid walks through all its cells on this way, one by one.";
        assert!(slide.contains(sentence));
        std::fs::write(section.join("40-wrong.md"), slide.replace(sentence, text)).unwrap();
        let output = raystep(&folder, &["check", "--only", "05-kd-tree/40-wrong.md"]);
        let all = raystep(&folder, &["check", "--only", "."]);
        assert_eq!(output.status.code(), all.status.code());
        text_of(&output)
    };
    let mut table = String::new();
    for text in [
        "",
        "A formula $\\frac{1}{2$ without its end.",
        "An unknown $\\foo$ command.",
        "\n\n| a | b |\n|---|---|\n| 1 | 2 |",
        "![A picture](picture.png)",
        "So $\\frac{{{t_near}}}{2}$ is.",
        "So ${{t_near}}^{2$ is.",
        "- one\n- two $\\vec{d}$",
    ] {
        table += &format!("{text:?}\n{}", said(text));
    }
    insta::assert_snapshot!(table);

    // Whatever lies in the folder: what is named is said, and the rest is checked.
    said("");
    std::fs::copy(section.join("40-wrong.md"), section.join("41-again.md")).unwrap();
    std::fs::write(section.join("42-bytes.md"), [0xFF; 9]).unwrap();
    std::fs::write(section.join(".#40-wrong.md"), [0xFF; 9]).unwrap();
    let output = raystep(&folder, &["check", "--only", "."]);
    insta::assert_snapshot!(text_of(&output));
    let output = raystep(&folder, &["check", "--only", "listings/kd-walk.txt", "05-kd-tree/42-bytes.md", "/dev/zero"]);
    insta::assert_snapshot!(text_of(&output));
    let output = raystep(&section, &["check", "--only", "41-again.md"]);
    assert!(text_of(&output).contains("slide 5/40 is"), "{}", text_of(&output));
}

#[test]
fn lessons_are_drawn_past_what_cannot_be_read() {
    let folder = folder("lessons-past");
    let [section, listings] = ["lessons/05-kd-tree", "lessons/listings"].map(|name| folder.join(name));
    std::fs::create_dir_all(&section).unwrap();
    std::fs::create_dir_all(&listings).unwrap();
    std::fs::create_dir_all(folder.join("empty")).unwrap();
    let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join("../lessons");
    for file in ["listings/kd-walk.txt", "05-kd-tree/40-grid-or-tree.md"] {
        std::fs::copy(shipped.join(file), folder.join("lessons").join(file)).unwrap();
    }
    std::fs::write(section.join("41-bytes.md"), [0xFF; 9]).unwrap();
    std::fs::write(section.join("42-wrong.md"), "+++\n+++\n").unwrap();
    let export = |slide: &str, lessons: &str, out: &str| {
        let small = ["--stage", "flat", "--size", "320x200", "--format", "svg", "--out", out];
        raystep(&folder, &[&["export", "--slide", slide, "--only", "--lessons", lessons][..], &small].concat())
    };
    let fine = export("5/40", "lessons", "pictures");
    let said = text(&fine.stderr);
    assert!(fine.status.success() && said.contains("lessons/05-kd-tree/41-bytes.md:1:1"), "{said}");
    assert!(std::fs::read_dir(folder.join("pictures")).unwrap().count() >= 3);
    for (slide, lessons, says) in [
        ("42-wrong", "lessons", "42-wrong.md:1:1"),
        ("5/41", "lessons", "there is no slide"),
        ("5/40", "empty", "no slides can be read here"),
        ("5/40", "nowhere", "nowhere"),
    ] {
        let output = export(slide, lessons, "none");
        assert!(output.status.code() == Some(2) && text(&output.stderr).contains(says), "{}", text(&output.stderr));
    }
}

/// What a call said of what is wrong, and its exit code.
fn text_of(output: &Output) -> String {
    format!("{}exit code {:?}\n", text(&output.stderr), output.status.code())
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

#[test]
fn a_heat_map_holds_what_each_ray_costs() {
    let folder = folder("heatmap");
    std::fs::write(folder.join("square.obj"), SQUARE).unwrap();
    let done = |arguments: &[&str]| {
        let output = raystep(&folder, arguments);
        assert!(output.status.success(), "{arguments:?}: {}", text(&output.stderr));
        text(&output.stdout)
    };
    let scene = ["--scene", "teapot-6321", "--structure", "kd", "--rule", "max_depth=16"];
    let map =
        |more: &[&str]| done(&[&["heatmap"], &scene[..], &["--camera", "scene", "--size", "48x30"], more].concat());
    map(&["--out", "map.csv"]);
    let rows = std::fs::read_to_string(folder.join("map.csv")).unwrap();
    let rows: Vec<Vec<u64>> =
        rows.lines().map(|row| row.split(',').map(|count| count.parse().unwrap()).collect()).collect();
    assert_eq!((rows.len(), rows[0].len()), (30, 48));
    for [x, y] in [[0_usize, 0], [24, 15], [20, 18], [47, 29]] {
        let pixel = format!("{x},{y}");
        let more = ["--size", "48x30", "--format", "csv", "--pixel", &pixel];
        let walk = done(&[&["trace"], &scene[..], &more].concat());
        // Counted by the walk's last step, behind what it says.
        let tests = walk.lines().last().unwrap().rsplit(',').nth(3).unwrap();
        assert_eq!(rows[y][x].to_string(), tests, "at {pixel}");
    }
    map(&["--out", "bare.png", "--bare"]);
    map(&["--out", "map.png", "--of", "visits"]);
    let size = |name: &str| {
        let reader = png::Decoder::new(std::io::BufReader::new(std::fs::File::open(folder.join(name)).unwrap()));
        let reader = reader.read_info().unwrap();
        (reader.info().width, reader.info().height)
    };
    assert_eq!(size("bare.png"), (48, 30));
    assert!(size("map.png").0 > 48 && size("map.png").1 > 30, "there is room for the scale");
    let first = std::fs::read(folder.join("map.png")).unwrap();
    map(&["--out", "map.png", "--of", "visits"]);
    assert_eq!(std::fs::read(folder.join("map.png")).unwrap(), first, "the same to the byte");
    done(&[
        "heatmap",
        "--mesh",
        "square.obj",
        "--structure",
        "bvh",
        "--of",
        "boxes",
        "--size",
        "16x16",
        "--out",
        "s.csv",
    ]);

    let heat = ["heatmap", "--structure", "kd", "--scene"];
    for (more, says) in [
        (&["teapot-6321", "--out", "map.jpg"][..], "--out map.jpg: a heat map is written as FILE.png or FILE.csv"),
        (&["teapot-6321", "--out", "map.csv", "--bare"], "--bare leaves out the scale of a picture"),
        (&["teapot-6321", "--out", "none/map.png"], "there is no folder none"),
        (
            &["flat-twelve", "--out", "flat.png"],
            "flat-twelve is flat: a ray through a pixel would fall onto it from above",
        ),
        (&["teapot-6322", "--out", "map.png"], "teapot-6321"),
        (&["teapot-6321", "--out", "map.png", "--of", "hits"], "tests, visits, boxes"),
        (&["teapot-6321", "--out", "map.png", "--rule", "depth=3"], "max_depth"),
        (&["teapot-6321", "--out", "map.png", "--camera", "0,0,0,0,0,0"], "the eye must not lie at the target"),
    ] {
        refused(&folder, &[&heat[..], more].concat(), says);
    }
    refused(&folder, &["heatmap", "--structure", "kd", "--mesh", "square.obj", "--out", "square.obj"], "FILE.png");
    assert_eq!(std::fs::read(folder.join("map.png")).unwrap(), first, "what is refused leaves what was there");
    let names = std::fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().file_name()).collect::<Vec<_>>();
    assert_eq!(names.len(), 5, "{names:?}");
}

#[test]
fn all_structures_are_measured_on_a_mesh() {
    let folder = folder("best");
    std::fs::write(folder.join("square.obj"), SQUARE).unwrap();
    let best = ["measure", "--best", "--mesh", "square.obj", "--size", "16x16"];
    let said = |more: &[&str]| {
        let output = raystep(&folder, &[&best[..], more].concat());
        assert!(output.status.success(), "{}", text(&output.stderr));
        text(&output.stdout)
    };
    let records: Vec<serde_json::Value> = serde_json::from_str(&said(&["--format", "json"])).unwrap();
    let kinds: Vec<&str> = records.iter().map(|record| record["structure"].as_str().unwrap()).collect();
    let fast = ["fast-grid", "fast-kd", "fast-bvh2", "fast-bvh8"];
    assert_eq!(kinds, [&raystep_accel::Rule::KINDS[..], &fast].concat());
    assert!(records.iter().all(|record| record["rays"] == 256 && record["build_ms"].is_null()), "{records:?}");
    assert_eq!(records[0]["tests_per_ray"], 2.0, "brute force tests both triangles");
    assert!(said(&["--times", "--format", "csv"]).starts_with("structure,rule,rays,tests_per_ray,"));
    let page = said(&[]);
    assert_eq!(page, said(&[]), "counts are the same every time");
    assert!(
        page.contains("square.obj: 2 primitives; 256 rays") && page.contains("Brute force: nothing is built"),
        "{page}"
    );
    assert!(
        !page.contains("ms") && said(&["--times", "--format", "md"]).contains("build ms"),
        "times stand where they are asked for"
    );
    refused(&folder, &["measure", "--mesh", "square.obj"], "--best");
    refused(&folder, &["measure", "--best", "--scene", "flat-twelve"], "flat-twelve is flat");
    refused(&folder, &["measure", "--best", "--mesh", "none.obj"], "none.obj: there is no such file or folder");
}
