//! Lessons in a folder on a disk: what cannot be read there is named, and the rest is read.
#![cfg(unix)]

use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use raystep_lesson::{Library, check, check_file};

const SLIDE: &str = include_str!("good_slide.md");
const LISTING: &str = "walk\n  t ← (plane − o) / d | plane : {{t}}\n  order | split push\n  leaf | enter test better pop drop\n  done | end\n";

/// A folder of lessons with one good slide in it.
fn lessons(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(folder.join("05-kd-tree")).unwrap();
    std::fs::create_dir_all(folder.join("listings")).unwrap();
    std::fs::write(folder.join("05-kd-tree/33-good.md"), SLIDE).unwrap();
    std::fs::write(folder.join("listings/walk.txt"), LISTING).unwrap();
    folder
}

/// All that is wrong in a folder, in which the good slide is read all the same.
fn said(folder: &Path) -> String {
    let library = Library::from_dir(folder).unwrap();
    assert!(library.slide("5/33").is_some(), "the good slide is lost");
    check(&library, &|_, _| Vec::new()).iter().map(|problem| format!("{problem}\n")).collect()
}

#[test]
fn an_unreadable_file_is_named_and_the_rest_is_read() {
    let folder = lessons("unreadable");
    let section = folder.join("05-kd-tree");
    // An editor's lock, and its backup.
    symlink("user@host.1234:5678", section.join(".#33-good.md")).unwrap();
    std::fs::write(section.join(".33-good.md.swp.md"), [0xFF, 0xFE]).unwrap();
    assert_eq!(said(&folder), "");

    std::fs::write(section.join("34-byte.md"), [b"+++\nformat \xE2\x86\x92 ", &b"\x93 1\n"[..]].concat()).unwrap();
    std::fs::write(section.join("35-large.md"), "x".repeat(1 << 20)).unwrap();
    std::fs::create_dir(section.join("36-folder.md")).unwrap();
    std::fs::create_dir(section.join("deeper")).unwrap();
    std::fs::write(section.join("deeper/36-deep.md"), SLIDE).unwrap();
    let pipe = std::process::Command::new("mkfifo").arg(section.join("37-pipe.md")).status().unwrap();
    assert!(pipe.success());
    symlink("/dev/zero", section.join("38-zero.md")).unwrap();
    symlink("nothing", section.join("39-nothing.md")).unwrap();
    symlink("40-circle.md", section.join("40-circle.md")).unwrap();
    symlink("..", section.join("41-up")).unwrap();
    symlink("/etc", folder.join("06-out")).unwrap();
    symlink("05-kd-tree", folder.join("07-again")).unwrap();
    symlink("33-good.md", section.join("42-same.md")).unwrap();
    std::fs::write(folder.join("sections.txt"), "05-kd-tree : Trees\n05-kd-tre : Trees\nno title\n").unwrap();
    insta::assert_snapshot!(said(&folder));
}

#[cfg(target_os = "linux")]
#[test]
fn a_name_that_is_no_text_is_named() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;

    let folder = lessons("no-text");
    std::fs::write(folder.join("05-kd-tree").join(OsStr::from_bytes(b"34-\xFF.md")), SLIDE).unwrap();
    std::fs::write(folder.join("05-kd-tree").join(OsStr::from_bytes(b"notes-\xFF.txt")), "notes").unwrap();
    let section = folder.join(OsStr::from_bytes(b"06-\xFF"));
    std::fs::create_dir(&section).unwrap();
    std::fs::write(section.join("40-good.md"), SLIDE).unwrap();
    insta::assert_snapshot!(said(&folder));
}

#[test]
fn a_folder_that_is_not_there_is_an_error() {
    assert!(Library::from_dir(&lessons("gone").join("nowhere")).is_err());
}

#[test]
fn a_folder_of_very_many_files_is_read_up_to_a_limit() {
    let folder = lessons("many");
    let section = folder.join("06-many");
    std::fs::create_dir(&section).unwrap();
    for number in 0..2100 {
        std::fs::write(section.join(format!("{number}.md")), "").unwrap();
    }
    let said = said(&folder);
    assert!(said.contains("06-many:1:1: the lessons have more than 2000 files"), "{}", said.lines().last().unwrap());
}

#[test]
fn one_file_is_checked_among_the_others() {
    let folder = lessons("among");
    std::fs::write(folder.join("05-kd-tree/34-again.md"), SLIDE).unwrap();
    std::fs::write(folder.join("05-kd-tree/35-wrong.md"), "wrong").unwrap();
    let library = Library::from_dir(&folder).unwrap();
    let of = |file| check_file(&library, file, &|_, _| Vec::new());
    let again: Vec<String> = of("05-kd-tree/34-again.md").iter().map(ToString::to_string).collect();
    assert_eq!(
        again,
        ["05-kd-tree/34-again.md:3:9: slide 5/33 is 05-kd-tree/33-good.md already: another number is needed"]
    );
    assert_eq!(of("05-kd-tree/33-good.md"), []);
    assert_eq!(of("listings/walk.txt"), []);
    assert_eq!(of("05-kd-tree/35-wrong.md").len(), 1);
}

/// How long it takes to read and check a slide with this text in the place of its last paragraph.
fn time_of(text: &str) -> Duration {
    let slide = SLIDE.replace("The best is {{best_t}}.", text);
    let start = Instant::now();
    let files = [("05-kd-tree/33.md".to_owned(), slide), ("listings/walk.txt".to_owned(), LISTING.to_owned())];
    let problems = check(&Library::from_files(files), &|_, _| Vec::new());
    let shown: usize = problems.iter().map(|problem| problem.message.len()).sum();
    assert!(problems.len() < 60 && shown < 100_000, "{} problems of {shown} letters", problems.len());
    start.elapsed()
}

#[test]
fn no_slide_takes_long_to_check() {
    let almost = 120 * 1024;
    let texts = [
        ("a megabyte", "word ".repeat(200_000)),
        ("paragraphs", "a\n\n".repeat(almost / 3)),
        ("conditions", "> if side=both: a\n\n".repeat(almost / 19)),
        ("wrong conditions", "> if sied=both: a\n\n".repeat(almost / 19)),
        ("fields", "{{best_t}} ".repeat(almost / 11)),
        ("wrong fields", "{{bst_t}}".repeat(almost / 9)),
        ("open fields", "{{".repeat(almost / 2)),
        ("a long wrong field", format!("{{{{{}}}}}", "x".repeat(almost))),
        ("quotes", "> ask\n\n".repeat(almost / 7)),
        ("headings", "## a {at=end}\n".repeat(almost / 14)),
        ("answers", format!("> ask {{field=node}}: Which?\n{}", "> - node: no\n".repeat(almost / 13))),
        ("a long event", format!("## a {{at={}}}", "pop|".repeat(almost / 4))),
        ("a long wrong event", format!("## a {{at={}}}", "x".repeat(almost))),
        ("many attributes", format!("## a {{at=end {}}}", "a=b ".repeat(almost / 4))),
        ("braces", "{".repeat(almost)),
    ];
    for (what, text) in texts {
        let time = time_of(&text);
        assert!(time < Duration::from_secs(3), "{what}: {time:?}");
        println!("{what}: {time:?}");
    }
}

#[test]
fn no_head_takes_long_to_check() {
    let almost = 120 * 1024;
    let heads = [
        ("keys", (0..almost / 12).map(|i| format!("a{i} = 1\n")).collect()),
        ("the same key", "title = \"a\"\n".repeat(almost / 12)),
        ("numbers", format!("slide = [{}]\n", "33, ".repeat(almost / 4))),
        ("deep", format!("deep = {}{}\n", "[".repeat(almost / 2), "]".repeat(almost / 2))),
        ("open", format!("deep = {}\n", "[".repeat(almost))),
        ("tables", format!("deep = {}{}\n", "{a=".repeat(almost / 8), "}".repeat(almost / 8))),
        ("dots", format!("a{} = 1\n", ".a".repeat(almost / 2))),
        ("quotes", "\"".repeat(almost)),
        ("promises", format!("promise = [{}]\n", "\"drop\", ".repeat(almost / 8))),
    ];
    for (what, head) in heads {
        let head: String = head;
        let start = Instant::now();
        let slide = SLIDE.replace("title = \"First\"\n", &head);
        let library = Library::from_files([("05-kd-tree/33.md".to_owned(), slide)]);
        let problems = check(&library, &|_, _| Vec::new());
        assert!(!problems.is_empty() && problems.len() < 60, "{what}: {} problems", problems.len());
        let time = start.elapsed();
        assert!(time < Duration::from_secs(3), "{what}: {time:?}");
        println!("{what}: {time:?}");
    }
}
