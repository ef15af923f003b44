//! Many pictures at once, and the page of all of them.

use std::collections::BTreeMap;

use super::inputs::{TWINS, lessons, with_inputs};
use super::{folder, names, raystep, said};

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
