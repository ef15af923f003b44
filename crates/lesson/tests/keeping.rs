//! Lessons that are saved while they are read: the reader keeps the place, and what was good stays until there is better.

use raystep_lesson::Library;

const SLIDE: &str = include_str!("good_slide.md");
const LISTING: &str = "walk\n  t ← (plane − o) / d | plane : {{t}}\n  order | split push\n  leaf | enter test better pop drop\n  done | end\n";

/// Three slides, the second of which is open.
const PATHS: [&str; 3] = ["02-a/1-first.md", "05-b/33-second.md", "07-c/56-third.md"];
const OPEN: usize = 1;

/// Lessons with these files beside the listing.
fn lessons(files: &[(&str, &str)]) -> Library {
    let listing = ("listings/walk.txt", LISTING);
    let listing = (!files.iter().any(|(path, _)| *path == listing.0)).then_some(listing);
    let files = files.iter().copied().chain(listing);
    Library::from_files(files.map(|(path, text)| (path.to_owned(), text.to_owned())))
}

/// The files of the lessons that are read after a save, and the place of what is open.
fn saved(files: &[(&str, &str)]) -> (Library, usize) {
    let before = lessons(&PATHS.map(|path| (path, SLIDE)));
    let open = &before.slides[OPEN];
    assert_eq!(open.file, PATHS[OPEN], "{:?}", before.problems);
    let after = lessons(files).keeping(&before, Some(open));
    let place = after.place_of(open, OPEN);
    (after, place)
}

#[test]
fn the_open_slide_stays_open() {
    let check = |what: &str, files: &[(&str, &str)], names: &[&str], open: &str, title: &str| {
        let (after, place) = saved(files);
        let files: Vec<&str> = after.slides.iter().map(|slide| &*slide.file).collect();
        assert_eq!(files, names, "{what}");
        assert_eq!((&*after.slides[place].file, &*after.slides[place].title), (open, title), "{what}");
        let listing = after.listing("walk").unwrap_or_else(|| panic!("{what}: the listing is gone"));
        assert!(!listing.lines.is_empty(), "{what}");
    };
    let [first, second, third] = PATHS;
    let renamed = SLIDE.replace("title = \"First\"", "title = \"Anew\"");
    let all = |text| [(first, SLIDE), (second, text), (third, SLIDE)];
    let wrong = SLIDE.replace("format = 1", "format = ");
    check("saved", &all(&renamed), &PATHS, second, "Anew");
    check("nothing written yet", &all(""), &PATHS, second, "First");
    check("no slide at all", &all("Dear diary,"), &PATHS, second, "First");
    check("a wrong head", &all(&wrong), &PATHS, second, "First");
    check("gone for a moment", &[(first, SLIDE), (third, SLIDE)], &PATHS, second, "First");
    check("everything gone", &[], &[second], second, "First");
    check("another slide gone", &[(first, SLIDE), (second, SLIDE)], &[first, second], second, "First");
    check("another slide half-written", &[(first, ""), (second, SLIDE), (third, SLIDE)], &PATHS, second, "First");
    check(
        "one before it",
        &[("01-x/0-new.md", SLIDE), all(SLIDE)[0], all(SLIDE)[1]],
        &["01-x/0-new.md", first, second],
        second,
        "First",
    );
    check(
        "called otherwise",
        &[(first, SLIDE), ("05-b/33-other.md", &renamed), (third, SLIDE)],
        &[first, "05-b/33-other.md", third],
        "05-b/33-other.md",
        "Anew",
    );
    let [a, b, c] = all(SLIDE);
    check("a listing without lines", &[a, b, c, ("listings/walk.txt", "")], &PATHS, second, "First");
}

#[test]
fn wherever_a_file_is_cut_something_is_shown_in_its_place() {
    for cut in (0..SLIDE.len()).filter(|cut| SLIDE.is_char_boundary(*cut)) {
        let (after, place) = saved(&[(PATHS[0], SLIDE), (PATHS[1], &SLIDE[..cut]), (PATHS[2], SLIDE)]);
        assert_eq!((after.slides.len(), place), (3, OPEN), "cut at {cut}");
        let slide = &after.slides[place];
        assert!(!slide.stages.is_empty() && !slide.beats.is_empty(), "cut at {cut}");
    }
}
