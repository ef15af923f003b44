//! Nothing is lost: not what is written, not what stood there before, not what was asked for.
#![cfg(unix)]

use std::collections::BTreeMap;
use std::io::{BufRead, BufReader};
use std::os::unix::fs::{FileTypeExt, PermissionsExt, symlink};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

/// A folder of this test's own, empty.
fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("nothing-lost").join(name);
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).unwrap();
    path
}

/// Raystep in a folder, without a display.
fn raystep(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_raystep"));
    command.args(arguments).current_dir(folder).env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY");
    command
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// The names in a folder, hidden ones too.
fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut names: Vec<String> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

const SQUARE: &str = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n";
const RAYS: &str = "ox,oy,oz,dx,dy,dz\n1.5,0.5,5,0,0,-1\n0.5,1.5,5,0,0,-1\n9,9,5,0,0,-1\n";

/// A folder with a mesh and rays.
fn with_inputs(name: &str) -> PathBuf {
    let folder = folder(name);
    std::fs::write(folder.join("square.obj"), SQUARE).unwrap();
    std::fs::write(folder.join("rays.csv"), RAYS).unwrap();
    folder
}

fn trace(out: &str) -> [&str; 9] {
    ["trace", "--mesh", "square.obj", "--structure", "kd", "--rays", "rays.csv", "--out", out]
}

#[test]
fn what_must_not_be_replaced_is_refused() {
    /// Makes something, tries to write there, and expects the sentence and nothing changed.
    fn check(name: &str, out: &str, says: &str, make: impl FnOnce(&Path)) {
        let folder = with_inputs(name);
        make(&folder);
        let look = |at: &Path| {
            let known = std::fs::symlink_metadata(at).ok()?;
            let bytes = known.is_file().then(|| std::fs::read(at).unwrap());
            Some((known.file_type(), known.permissions().mode(), bytes, std::fs::read_link(at).ok()))
        };
        let at = folder.join(out);
        let (before, beside) = (look(&at), names(&folder));
        let inputs = [SQUARE, RAYS].map(str::to_owned);
        let output = raystep(&folder, &trace(out)).output().unwrap();
        assert_eq!(output.status.code(), Some(2), "{name}: {}", said(&output));
        assert!(said(&output).contains(says), "{name}: {}", said(&output));
        assert_eq!((look(&at), names(&folder)), (before, beside), "{name}");
        assert_eq!(["square.obj", "rays.csv"].map(|name| std::fs::read_to_string(folder.join(name)).unwrap()), inputs);
    }
    let nothing = |_: &Path| {};
    check("link", "out.csv", "it is a link to real.csv", |folder| {
        std::fs::write(folder.join("real.csv"), "mine").unwrap();
        symlink("real.csv", folder.join("out.csv")).unwrap();
    });
    check("dangling", "out.csv", "it is a link to nowhere", |folder| {
        symlink("nowhere", folder.join("out.csv")).unwrap();
    });
    check("pipe", "out.csv", "it is no plain file", |folder| {
        assert!(Command::new("mkfifo").arg(folder.join("out.csv")).status().unwrap().success());
    });
    check("protected", "out.csv", "it is write-protected", |folder| {
        std::fs::write(folder.join("out.csv"), "mine").unwrap();
        std::fs::set_permissions(folder.join("out.csv"), PermissionsExt::from_mode(0o444)).unwrap();
    });
    check("folder", "out.csv", "it is a folder", |folder| std::fs::create_dir(folder.join("out.csv")).unwrap());
    check("null", "/dev/null", "it is no plain file", nothing);
    check("full", "/dev/full", "it is no plain file", nothing);
    check("nowhere", "there/out.csv", "there is no folder there", nothing);
    check("mesh", "square.obj", "this file is read", nothing);
    check("rays", "./rays.csv", "this file is read", nothing);
    check("hard-link", "out.csv", "this file is read", |folder| {
        std::fs::hard_link(folder.join("rays.csv"), folder.join("out.csv")).unwrap();
    });
    assert!(std::fs::metadata("/dev/null").unwrap().file_type().is_char_device());
}

#[test]
fn a_file_keeps_its_mode_and_its_neighbours() {
    for mode in [0o600, 0o640, 0o666, 0o755] {
        let folder = with_inputs("mode");
        std::fs::write(folder.join("out.csv.part"), "mine").unwrap();
        std::fs::write(folder.join("out.csv"), "old").unwrap();
        std::fs::set_permissions(folder.join("out.csv"), PermissionsExt::from_mode(mode)).unwrap();
        let output = raystep(&folder, &trace("out.csv")).output().unwrap();
        assert!(output.status.success(), "{}", said(&output));
        assert!(std::fs::read_to_string(folder.join("out.csv")).unwrap().starts_with("ray,hit"));
        assert_eq!(std::fs::metadata(folder.join("out.csv")).unwrap().permissions().mode() & 0o7777, mode);
        assert_eq!(std::fs::read_to_string(folder.join("out.csv.part")).unwrap(), "mine");
        assert_eq!(names(&folder), ["out.csv", "out.csv.part", "rays.csv", "square.obj"]);
        // A new file is as open as any other program would make it.
        std::fs::remove_file(folder.join("out.csv")).unwrap();
        assert!(raystep(&folder, &trace("out.csv")).status().unwrap().success());
        let mode = |name: &str| std::fs::metadata(folder.join(name)).unwrap().permissions().mode();
        assert_eq!(mode("out.csv"), mode("out.csv.part"));
    }
}

#[test]
fn two_programs_write_one_file_one_after_the_other() {
    let folder = with_inputs("two");
    let rays = |n: usize| "ox,oy,oz,dx,dy,dz\n".to_owned() + &"1.5,0.5,5,0,0,-1\n".repeat(n);
    let sizes = [3000, 5000, 7000, 9000];
    for n in sizes {
        std::fs::write(folder.join(format!("{n}.csv")), rays(n)).unwrap();
    }
    for _ in 0..3 {
        let begin = |n: usize| {
            let rays = format!("{n}.csv");
            let call = ["trace", "--mesh", "square.obj", "--structure", "bvh", "--rays", &rays, "--out", "out.csv"];
            raystep(&folder, &call).stderr(Stdio::piped()).spawn().unwrap()
        };
        let programs: Vec<Child> = sizes.into_iter().map(begin).collect();
        for program in programs {
            let output = program.wait_with_output().unwrap();
            assert!(output.status.success(), "{}", said(&output));
        }
        let lines = std::fs::read_to_string(folder.join("out.csv")).unwrap().lines().count();
        assert!(sizes.contains(&(lines - 1)), "{lines} lines are of no program");
        assert!(!names(&folder).iter().any(|name| name.ends_with(".part")), "{:?}", names(&folder));
    }
}

#[test]
fn a_full_disk_is_a_sentence() {
    // The standard output.
    let folder = with_inputs("full-output");
    for call in [&trace("-")[..7], &["doctor"]] {
        let full = std::fs::File::options().write(true).open("/dev/full").unwrap();
        let output = raystep(&folder, call).stdout(full).stderr(Stdio::piped()).output().unwrap();
        assert_eq!(output.status.code(), Some(2), "{call:?}: {}", said(&output));
        assert!(said(&output).contains("standard output: the disk is full"), "{call:?}: {}", said(&output));
    }
    // A disk of its own, where one may be made.
    let disk = folder.join("disk");
    std::fs::create_dir(&disk).unwrap();
    let mount = Command::new("mount").args(["-t", "tmpfs", "-o", "size=16k", "none"]).arg(&disk).output();
    if !mount.is_ok_and(|mount| mount.status.success()) {
        println!("stepping aside: no small disk can be made here");
        return;
    }
    let _disk = Mounted(disk.clone());
    std::fs::write(disk.join("out.csv"), "old").unwrap();
    std::fs::write(folder.join("many.csv"), "ox,oy,oz,dx,dy,dz\n".to_owned() + &"1,1,5,0,0,-1\n".repeat(3000)).unwrap();
    let out = disk.join("out.csv").to_string_lossy().into_owned();
    let calls: [(&[&str], &str); 2] = [
        (&["trace", "--mesh", "square.obj", "--structure", "kd", "--rays", "many.csv", "--out", &out], "out.csv"),
        (&["export", "--slide", "5/33", "--stage", "flat", "--out", disk.to_str().unwrap()], ".png"),
    ];
    for (call, name) in calls {
        let output = raystep(&folder, call).output().unwrap();
        assert_eq!(output.status.code(), Some(2), "{call:?}: {}", said(&output));
        assert!(said(&output).contains(name) && said(&output).contains("the disk is full"), "{}", said(&output));
        assert_eq!(names(&disk), ["out.csv"], "nothing half is left");
        assert_eq!(std::fs::read_to_string(disk.join("out.csv")).unwrap(), "old", "what was there stays");
    }
}

/// A disk that is taken away again.
struct Mounted(PathBuf);

impl Drop for Mounted {
    fn drop(&mut self) {
        let _ = Command::new("umount").arg(&self.0).status();
    }
}

#[test]
fn a_file_that_may_not_be_so_large_is_a_sentence() {
    let folder = with_inputs("limited");
    std::fs::write(folder.join("rays.csv"), RAYS.to_owned() + &"1.5,0.5,5,0,0,-1\n".repeat(20_000)).unwrap();
    std::fs::write(folder.join("out.csv"), "before").unwrap();
    let before = names(&folder);
    let call = "ulimit -f 40; exec \"$0\" \"$@\"";
    let output = Command::new("bash")
        .args(["-c", call, env!("CARGO_BIN_EXE_raystep")])
        .args(trace("out.csv"))
        .current_dir(&folder)
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    assert!(said(&output).contains("out.csv: no file may be that large here"), "{}", said(&output));
    assert_eq!(std::fs::read_to_string(folder.join("out.csv")).unwrap(), "before");
    assert_eq!(names(&folder), before);
}

#[test]
fn nobody_listening_is_no_reason_to_break_off() {
    let folder = with_inputs("deaf");
    let section = folder.join("05-kd-tree");
    std::fs::create_dir_all(&section).unwrap();
    std::fs::write(section.join("33-wrong.md"), "+++\nformat = 1\nslide = [33]\ntitel = \"Wrong\"\n+++\n").unwrap();
    let calls: [(&[&str], i32); 5] = [
        (&["check", "05-kd-tree/33-wrong.md"], 2),
        (&["trace", "--mesh", "none.obj", "--structure", "kd", "--rays", "rays.csv"], 2),
        (&["square.obj"], 2),
        (&["export", "--slide", "5/33", "--stage", "flat", "--steps", "1", "--size", "64x40", "--out", "pictures"], 0),
        (&["nonsense.obj"], 2),
    ];
    for (call, code) in calls {
        // Closed, full, and with nobody at the other end.
        let shell = |to: &str| {
            let line = format!("exec \"$0\" \"$@\" {to}");
            let mut command = Command::new("bash");
            command.arg("-c").arg(line).arg(env!("CARGO_BIN_EXE_raystep")).args(call).current_dir(&folder);
            command.env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY").status().unwrap().code()
        };
        for to in ["2>&-", ">&- 2>&-", "2>/dev/full", "2> >(exec true; sleep 0)"] {
            assert_eq!(shell(to), Some(code), "{call:?} {to}");
        }
    }
}

/// A folder of lessons with these slides, all of them like one that is shipped.
fn lessons(folder: &Path, slides: &[(&str, u32)], rays: [&str; 3]) -> PathBuf {
    let lessons = folder.join("lessons");
    std::fs::create_dir_all(lessons.join("listings")).unwrap();
    let listing = Path::new(env!("CARGO_MANIFEST_DIR")).join("../lessons/listings/kd-walk.txt");
    std::fs::copy(listing, lessons.join("listings/kd-walk.txt")).unwrap();
    for (path, number) in slides {
        let path = lessons.join(path);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        let [a, b, c] = rays;
        let text = format!(
            "+++\nformat = 1\nslide = [{number}]\ntitle = \"Same\"\nlisting = \"kd-walk\"\nscene = \"flat-twelve\"\n\
             structure = {{ kind = \"kd\" }}\nrays = [\n  \
             {{ name = \"{a}\", from = [0.1, 1.2], towards = [8, 4] }},\n  \
             {{ name = \"{b}\", from = [9.5, 3.2], direction = [-1, -0.2] }},\n  \
             {{ name = \"{c}\", from = [9.8, 0.8], towards = [6.4, 4] }},\n]\n+++\n\
             ## The end {{at=end}}\nSlide {number}.\n\n> ask {{field=hit}}: Is anything hit?\n> - yes: No.\n\
             > - no: Yes.\n\n## Again {{at=end ray=\"{b}\"}}\nSlide {number}.\n\n\
             ## And again {{at=end ray=\"{c}\"}}\nSlide {number}.\n"
        );
        std::fs::write(path, text).unwrap();
    }
    lessons
}

const TWINS: [(&str, u32); 3] = [("01-a/10-same.md", 10), ("02-b/10-same.md", 11), ("02-b/12-other.md", 12)];

#[test]
fn two_pictures_never_share_a_file() {
    let folder = folder("twins");
    lessons(&folder, &TWINS, ["own", "x > 0", "x < 0"]);
    for (format, count) in [("svg", 9), ("json", 3)] {
        let output = raystep(
            &folder,
            &[
                "export",
                "--all",
                "--lessons",
                "lessons",
                "--only",
                "--format",
                format,
                "--size",
                "320x200",
                "--out",
                format,
            ],
        );
        let output = { output }.output().unwrap();
        assert!(output.status.success(), "{}", said(&output));
        assert_eq!(names(&folder.join(format)).len(), count, "{:?}", names(&folder.join(format)));
        assert!(said(&output).contains(&format!("{count} files")), "{}", said(&output));
    }
    let pictures: BTreeMap<String, String> = names(&folder.join("svg"))
        .into_iter()
        .map(|name| (name.clone(), std::fs::read_to_string(folder.join("svg").join(name)).unwrap()))
        .collect();
    let mut different: Vec<&String> = pictures.values().collect();
    different.sort();
    different.dedup();
    assert_eq!(different.len(), 9, "every picture is another one");
    assert!(pictures.keys().any(|name| name.contains("01-a-10-same-flat-x-gt-0")), "{:?}", pictures.keys());

    // The page shows each of them under its own slide.
    let output = raystep(&folder, &["--lessons", "lessons", "--only"]).output().unwrap();
    assert!(output.status.success(), "{}", said(&output));
    let page = std::fs::read_to_string(folder.join("raystep-lecture/index.html")).unwrap();
    let parts: Vec<&str> = page.split("<a href=\"slide").skip(1).collect();
    let shown: Vec<String> = parts.iter().map(|part| format!("slide{}", part.split('"').next().unwrap())).collect();
    assert_eq!((shown.len(), page.matches("<option value=").count()), (9, 3), "{shown:?}");
    let mut files: Vec<&str> = shown.iter().map(|shown| shown.split('#').next().unwrap()).collect();
    files.sort_unstable();
    files.dedup();
    assert_eq!(files.len(), 3);
    files.push("index.html");
    files.sort_unstable();
    assert_eq!(names(&folder.join("raystep-lecture")), files);
    // What a page refers to is there, and each picture says what it shows.
    for shown in &shown {
        let (file, layer) = shown.split_once('#').unwrap();
        let text = std::fs::read_to_string(folder.join("raystep-lecture").join(file)).unwrap();
        assert!(text.contains(&format!("id=\"{layer}\"><title>")), "{shown}");
    }
    assert!(!page.contains("alt=\"\"") && page.matches("<summary>Answer").count() == 3);
}

#[test]
fn the_page_replaces_a_page_and_nothing_else() {
    let folder = with_inputs("page");
    lessons(&folder, &TWINS, ["own", "b", "c"]);
    let page = folder.join("raystep-lecture");
    let call = |arguments: &[&str]| raystep(&folder, arguments).output().unwrap();

    // A mesh is not dropped for it.
    for arguments in [&["square.obj"][..], &["square.obj", "--slide", "5/33"]] {
        let output = call(arguments);
        assert_eq!(output.status.code(), Some(2), "{}", said(&output));
        assert!(said(&output).contains("square.obj is not shown"), "{}", said(&output));
        assert!(!page.exists());
    }
    // Lessons that are broken, or none, make no empty page.
    for (path, text, says) in [
        ("broken/01-a/1-a.md", "+++\nformat = 1\ntitel = 3\n", "01-a/1-a.md"),
        ("empty/readme.md", "", "no slides can be read here"),
    ] {
        std::fs::create_dir_all(folder.join(path).parent().unwrap()).unwrap();
        std::fs::write(folder.join(path), text).unwrap();
        let output = call(&["--only", "--lessons", path.split('/').next().unwrap()]);
        assert_eq!(output.status.code(), Some(2), "{}", said(&output));
        assert!(said(&output).contains(says) && !page.exists(), "{}", said(&output));
    }

    // Somebody's own folder stays, whatever is in it.
    for (name, text) in [("notes.txt", "mine"), ("slide.png", "mine")] {
        std::fs::create_dir(&page).unwrap();
        std::fs::write(page.join(name), text).unwrap();
        std::fs::write(page.join("index.html"), "mine").unwrap();
        let output = call(&["--lessons", "lessons", "--only"]);
        assert_eq!(output.status.code(), Some(2), "{}", said(&output));
        assert!(said(&output).contains(name), "{}", said(&output));
        assert_eq!(std::fs::read_to_string(page.join(name)).unwrap(), "mine");
        std::fs::remove_dir_all(&page).unwrap();
    }
    std::fs::write(&page, "a file").unwrap();
    assert_eq!(call(&["--lessons", "lessons", "--only"]).status.code(), Some(2));
    std::fs::remove_file(&page).unwrap();

    // A page of ours is renewed whole.
    assert!(call(&["--lessons", "lessons", "--only"]).status.success());
    let whole = names(&page);
    std::fs::write(page.join("slide09-gone-flat-beat01.svg"), "old").unwrap();
    assert!(call(&["--lessons", "lessons", "--only"]).status.success());
    assert_eq!(names(&page), whole);
    assert!(!names(&folder).iter().any(|name| name.starts_with('.')), "{:?}", names(&folder));
}

/// Asks a program to end as soon as something holds.
fn stopped_when(mut program: Child, signal: &str, holds: impl Fn() -> bool) -> (Option<i32>, String) {
    let begun = Instant::now();
    while !holds() && program.try_wait().unwrap().is_none() && begun.elapsed() < Duration::from_secs(300) {
        std::thread::sleep(Duration::from_millis(2));
    }
    assert!(Command::new("kill").args([signal, &program.id().to_string()]).status().unwrap().success());
    let output = program.wait_with_output().unwrap();
    (output.status.code(), said(&output))
}

#[test]
fn what_is_stopped_leaves_nothing_half() {
    for signal in ["-INT", "-TERM"] {
        let folder = folder("stopped");
        let pictures = folder.join("pictures");
        let call = ["export", "--slide", "5/33", "--stage", "flat", "--steps", "0..30", "--out", "pictures"];
        let program = raystep(&folder, &call).stderr(Stdio::piped()).spawn().unwrap();
        let some = || pictures.is_dir() && names(&pictures).iter().filter(|name| name.ends_with(".png")).count() > 1;
        let (code, says) = stopped_when(program, signal, some);
        assert_eq!(code, Some(130), "{says}");
        assert!(says.contains("stopped"), "{says}");
        for name in names(&pictures) {
            let bytes = std::fs::read(pictures.join(&name)).unwrap();
            assert!(name.ends_with(".png") && bytes.ends_with(b"IEND\xAE\x42\x60\x82"), "{name} is not whole");
        }

        // Of a page that was begun nothing is there.
        let program = raystep(&folder, &[]).stderr(Stdio::piped()).spawn().unwrap();
        let begun = || names(&folder).iter().any(|name| name.starts_with('.'));
        let (code, says) = stopped_when(program, signal, begun);
        assert_eq!(code, Some(130), "{says}");
        assert_eq!(names(&folder), ["pictures"], "{says}");
    }
}

/// A screen of its own, without any window manager.
struct Screen {
    server: Child,
    display: String,
}

impl Screen {
    /// None where there is no such server.
    fn new() -> Option<Screen> {
        let arguments = ["-displayfd", "1", "-screen", "0", "1280x800x24", "-nolisten", "tcp"];
        let mut server =
            Command::new("Xvfb").args(arguments).stdout(Stdio::piped()).stderr(Stdio::null()).spawn().ok()?;
        let mut number = String::new();
        BufReader::new(server.stdout.take()?).read_line(&mut number).ok()?;
        Some(Screen { server, display: format!(":{}", number.trim()) })
    }
}

impl Drop for Screen {
    fn drop(&mut self) {
        let _ = self.server.kill();
        let _ = self.server.wait();
    }
}

#[test]
fn without_a_window_the_reason_is_a_sentence() {
    let folder = with_inputs("no-window");
    lessons(&folder, &TWINS, ["own", "b", "c"]);
    let screen = Screen::new();
    let no_driver = [
        ("VK_DRIVER_FILES", "/nowhere"),
        ("VK_ICD_FILENAMES", "/nowhere"),
        ("__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere"),
        ("LIBGL_DRIVERS_PATH", "/nowhere"),
    ];
    let mut cases = vec![(":4711".to_owned(), "no window can be opened: ")];
    match &screen {
        Some(screen) => {
            cases.push((screen.display.clone(), "no graphics driver answers that could draw on this display"));
        }
        None => println!("stepping aside: there is no Xvfb"),
    }
    for (display, says) in cases {
        let call = |arguments: &[&str]| {
            let mut command = raystep(&folder, arguments);
            command.env("DISPLAY", &display).envs(no_driver).env("XDG_CONFIG_HOME", &folder).output().unwrap()
        };
        let output = call(&["--lessons", "lessons", "--only"]);
        let said_of_page = said(&output);
        assert!(output.status.success() && said_of_page.contains(says), "{display}: {said_of_page}");
        assert!(
            !said_of_page.contains('{') && said_of_page.lines().all(|line| line.starts_with("raystep: ")),
            "{said_of_page}"
        );
        let output = call(&["square.obj"]);
        assert_eq!(output.status.code(), Some(2), "{}", said(&output));
        assert!(said(&output).contains("square.obj is not shown") && said(&output).contains(says), "{}", said(&output));
    }
}
