//! Pages to be printed: what they ask stands on them, what answers it at their end.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("handout").join(name);
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).unwrap();
    path
}

fn handout(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_raystep"));
    command.arg("handout").args(arguments).current_dir(folder).output().unwrap()
}

/// What each page says in words, in order.
fn pages(folder: &Path) -> Vec<String> {
    let index = std::fs::read_to_string(folder.join("handout.html")).unwrap();
    let alts = index.split("alt=\"").skip(1);
    alts.map(|alt| alt.split('"').next().unwrap().to_owned()).collect()
}

#[test]
fn answers_stand_at_the_end() {
    let folder = folder("answers");
    let output = handout(&folder, &["--slide", "5/33", "--slide", "2/15", "--pdf", "--out", "pages"]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let pages = pages(&folder.join("pages"));
    // All pages stand in one file as well.
    let pdf = std::fs::read(folder.join("pages/handout.pdf")).unwrap();
    let text = String::from_utf8_lossy(&pdf);
    assert_eq!(text.matches("/MediaBox").count(), pages.len());
    assert_eq!(text.matches("[0 0 595.").count(), pages.len(), "A4 is 210 mm wide");
    assert!(!text.contains("CreationDate") && !text.contains("ModDate"));
    // Whoever cannot see it hears headings, pictures and words in their order.
    assert_eq!(text.matches("/S/H1").count(), pages.len());
    let of_kind = |kind: &str| text.lines().filter(|line| line.contains(kind) && line.contains("/Alt")).count();
    assert!(of_kind("/S/Figure") >= 5 && of_kind("/S/P") >= 8, "{} {}", of_kind("/S/Figure"), of_kind("/S/P"));
    let answers = pages.iter().position(|page| page.contains("Answers")).unwrap();
    let asked: Vec<usize> =
        (1..99).take_while(|n| pages.iter().any(|page| page.contains(&format!("Question {n}:")))).collect();
    assert!(asked.len() >= 3, "{pages:#?}");
    for n in asked {
        let [question, answer] = [format!("Question {n}:"), format!("Question {n}, ")];
        let at = |text: &str| pages.iter().position(|page| page.contains(text)).unwrap();
        assert!(at(&question) < answers && at(&answer) >= answers, "question {n}");
    }
    for (number, page) in pages.iter().enumerate() {
        assert!(page.starts_with(&format!("Page {} of {}. ", number + 1, pages.len())), "{page}");
        let file = folder.join(format!("pages/page{:03}.svg", number + 1));
        let drawn = std::fs::read_to_string(file).unwrap();
        assert!(drawn.contains(&format!("aria-label=\"{} of {}\"", number + 1, pages.len())), "{number}");
        // Nothing tells which answer is right before the end.
        assert!(number >= answers || !page.contains("Not A,") && !page.contains("Not B,"), "{page}");
    }
    // A page of ours is renewed whole, and nothing else is replaced.
    assert!(handout(&folder, &["--slide", "2/15", "--out", "pages"]).status.success());
    std::fs::write(folder.join("pages/notes.txt"), "mine").unwrap();
    let output = handout(&folder, &["--slide", "2/15", "--out", "pages"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("notes.txt lies in it"));
}

#[test]
fn what_there_is_not_is_said() {
    let folder = folder("wrong");
    for (arguments, says) in [
        (["--slide", "5/99"], "there is no slide \"5/99\""),
        (["--section", "77"], "there is no section \"77\"; there are 1 ("),
        (["--stage", "round"], "[possible values: flat, solid]"),
    ] {
        let output = handout(&folder, &[&arguments[..], &["--out", "pages"]].concat());
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.code() == Some(2) && said.contains(says), "{said}");
        assert!(!folder.join("pages").exists());
    }
}
