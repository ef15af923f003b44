//! Lessons of somebody's own beside the lecture: slides, scenes and meshes, and what is wrong in them.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("own").join(name);
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(path.join("mine/10-mine")).unwrap();
    std::fs::create_dir_all(path.join("mine/scenes")).unwrap();
    path
}

fn raystep(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_raystep"));
    command.args(arguments).current_dir(folder).env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY").output().unwrap()
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

const ROOM: &str = "title = \"A room\"\nshapes = [\n  { disc = [2, 2], radius = 0.5 },\n  { disc = [5, 2], radius = \
                    0.5 },\n  { box = [[7, 1], [8, 3]] },\n]\n";
const ROOF: &str = "v 0 0 0\nv 2 0 0\nv 2 2 1\nv 0 2 0\nf 1 2 3 4\n";

/// A slide with its number, title and stages.
fn slide(number: u32, title: &str, stages: &str) -> String {
    format!(
        "+++\nformat = 1\nslide = {number}\ntitle = \"{title}\"\nlisting = \"kd-walk\"\nshow = [\"space\", \"tree\"]\n\
         {stages}+++\n## The end {{at=end}}\nThe **ray** ends.\n\n> ask {{field=hit}}: Is anything hit?\n> - no: Look again.\n"
    )
}

fn stage(kind: &str, scene: &str) -> String {
    format!(
        "[{kind}]\nscene = \"{scene}\"\nstructure = {{ kind = \"kd\", max_depth = 3 }}\nrays = [\n  {{ name = \"a\", from = \
         [0.2, 1.9, 0], towards = [9, 2.1, 0] }},\n  {{ name = \"b\", from = [1, 1, 5], direction = [0, 0.1, -1] }},\n]\n"
    )
}

/// A folder with a slide on a room and on a roof of its own.
fn good(name: &str) -> PathBuf {
    let folder = folder(name);
    std::fs::write(folder.join("mine/scenes/flat-room.toml"), ROOM).unwrap();
    std::fs::write(folder.join("mine/scenes/roof.obj"), ROOF).unwrap();
    let stages =
        stage("flat", "flat-room").replace("[1, 1, 5], direction = [0, 0.1, -1]", "[9, 2], direction = [-1, 0]");
    let stages = stages + &stage("solid", "roof");
    std::fs::write(folder.join("mine/10-mine/90-room.md"), slide(90, "My room", &stages)).unwrap();
    folder
}

#[test]
fn own_scenes_and_meshes_play_beside_the_lecture() {
    let folder = good("play");
    let checked = raystep(&folder, &["check", "mine"]);
    assert!(checked.status.success(), "{}", said(&checked));
    for lessons in [&["--lessons", "mine"][..], &["--lessons", "mine", "--only"]] {
        let more = ["export", "--slide", "10/90", "--format", "json", "--out", "walks"];
        let output = raystep(&folder, &[&more[..], lessons].concat());
        // Alone it has no listing of the lecture; nothing is drawn of that in JSON.
        assert!(output.status.success(), "{lessons:?}: {}", said(&output));
        for (walk, hit) in [("flat", true), ("solid", false)] {
            let text = std::fs::read_to_string(folder.join(format!("walks/slide90-room-{walk}.json"))).unwrap();
            let walk: serde_json::Value = serde_json::from_str(&text).unwrap();
            assert_eq!(walk["scene"], if hit { "flat-room" } else { "roof" });
            assert_eq!(walk["hit"].is_object(), hit, "{}", walk["hit"]);
        }
    }
    // The lecture is there as well, unless it is left out.
    let lecture = ["export", "--slide", "5/33", "--format", "json", "--out", "walks", "--lessons", "mine"];
    assert!(raystep(&folder, &lecture).status.success());
    let output = raystep(&folder, &[&lecture[..], &["--only"]].concat());
    assert!(said(&output).contains("there is no slide \"5/33\"; there are 10/90"), "{}", said(&output));
}

#[test]
fn what_is_wrong_in_own_lessons_is_said_with_its_place() {
    let folder = good("wrong");
    let write = |path: &str, text: &str| {
        std::fs::create_dir_all(folder.join("mine").join(path).parent().unwrap()).unwrap();
        std::fs::write(folder.join("mine").join(path), text).unwrap();
    };
    let check = || {
        let output = raystep(&folder, &["check", "mine"]);
        assert_eq!(output.status.code(), Some(2), "{}", said(&output));
        said(&output)
    };
    let flat = |number: u32, scene: &str| {
        let stage = stage("flat", scene).replace("[1, 1, 5], direction = [0, 0.1, -1]", "[9, 2], direction = [-1, 0]");
        slide(number, "Another", &stage)
    };
    write("05-mine/33-again.md", &flat(33, "flat-room"));
    write("10-mine/91-twin.md", &flat(90, "flat-room"));
    write("10-mine/92-none.md", &flat(92, "flat-rom"));
    write("10-mine/93-solid.md", &flat(93, "roof"));
    write("10-mine/94-formula.md", &flat(94, "flat-room").replace("ends.", "ends $\\frac{1}{2$."));
    write("10-mine/95-table.md", &flat(95, "flat-room").replace("ends.", "ends.\n\n| a | b |\n|---|---|\n| 1 | 2 |"));
    write("10-mine/96-picture.md", &flat(96, "flat-room").replace("ends.", "ends: ![a](a.png)."));
    // What is wrong with its scene is said once, at the scene.
    write("10-mine/97-bad-scene.md", &flat(97, "flat-bad"));
    write("scenes/flat-bad.toml", "title = \"Bad\"\nshapes = [\n  { disc = [0, 0], radios = 1 },\n]\n");
    write("scenes/bad.obj", "v 0 0 0\nv 1 0 0\nv 0 x 0\nf 1 2 3\n");
    write("scenes/roof.toml", ROOM);
    write("scenes/teapot-6321.obj", ROOF);
    write("listings/kd-walk.txt", "other | end\n");
    insta::assert_snapshot!(check());
}

#[test]
fn two_slides_of_one_number_are_an_error_with_both_files() {
    let folder = good("twins");
    let room = folder.join("mine/10-mine/90-room.md");
    std::fs::create_dir_all(folder.join("mine/05-kd-tree")).unwrap();
    let text = std::fs::read_to_string(&room).unwrap().replace("slide = 90", "slide = [33]");
    std::fs::write(folder.join("mine/05-kd-tree/33-mine.md"), text).unwrap();
    let says = "05-kd-tree/33-mine.md:3:9: slide 5/33 is the lecture's 05-kd-tree/33-which-child-first.md already: give it \
                another number, or leave the lecture out with --only; it is left out";
    let export = ["export", "--slide", "5/33", "--format", "json", "--out", "walks", "--lessons", "mine"];
    let output = raystep(&folder, &export);
    assert!(said(&output).contains(says), "{}", said(&output));
    let output = raystep(&folder, &[&export[..], &["--only"]].concat());
    assert!(output.status.success() && !said(&output).contains("already"), "{}", said(&output));
}
