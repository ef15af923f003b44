//! Slides of one's own: checked, and drawn.

use std::path::Path;
use std::process::Output;

use super::{folder, raystep, refused, text};

#[test]
fn lessons_are_checked() {
    let folder = folder("check");
    let fine = raystep(&folder, &["check"]);
    assert_eq!((fine.status.code(), text(&fine.stdout), text(&fine.stderr)), (Some(0), String::new(), String::new()));
    refused(&folder, &["check", "."], "no slides can be read here");
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
    // A formula that cannot be set is wrong, too: it would stand there as it was typed.
    let slide = std::fs::read_to_string(shipped.join("05-kd-tree/40-grid-or-tree.md")).unwrap();
    let typed = slide.replace("slide = 40", "slide = 43").replacen("one by one.", "one by $\\foo$.", 1);
    assert_ne!(typed.matches("43").count(), 0);
    std::fs::write(section.join("43-typed.md"), typed).unwrap();
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
        ("5/43", "lessons", "the formula cannot be set"),
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
