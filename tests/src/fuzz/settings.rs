//! The settings of the window, and what names a place in the lecture: slides, structures, sizes, scenes.

use raystep::cli::{Size, read_rule};
use raystep::shown::Link;
use raystep::window::{Last, Remembered};
use raystep_lesson::Library;
use raystep_scene::Scene;

use super::Target;

pub(super) const TARGET: Target = Target {
    name: "settings",
    body: settings,
    words: &[
        "theme = \"dark\"\n",
        "zoom = 1.5\n",
        "predict = false\n",
        "lesson = 300.0\n",
        "walk = 300.0\n",
        "[heights]\n",
        "link = \"5/33?step=7\"\n",
        "ended = 1\n",
        "5/33?stage=solid&ray=both%20children&step=13",
        "&own=0.1,1.2,0,7.9,2.8,0",
        "&set=max_depth:3",
        "&camera=1,2,3.5",
        "&camera=1,2,3,0,0,0,0,0,1,40",
        "&levels=3",
        "&beside=kd,grid",
        "&grain=visit",
        "&speed=0.5",
        "%C3%A4",
        "%",
        "?",
        "&",
        "+",
        "work = 100.0\n",
        "stack = 90.0\n",
        "tree = 200.0\n",
        "ruler = 70.0\n",
        "nan",
        "inf",
        "=",
        "[",
        "]",
        "\"",
        "'",
        "\n",
        "5/33",
        "05-kd-tree/33-which-child-first",
        "/",
        "33",
        "kd max_depth=3",
        "grid nx=512",
        "bvh volume=hull",
        "=",
        " ",
        "1600x1000",
        "x",
        "×",
        "teapot:",
        "forest:",
        "trial:",
        "flat-twelve",
        "trial:slivers:1",
        "#",
        ",",
        "{",
        "}",
        "\0",
    ],
    seeds: &[],
};

thread_local!(static LIBRARY: Library = Library::embedded());

/// Reads a link: what it says is written as it is read, and leads somewhere or to sentences.
fn link(text: &str) {
    let (link, wrong) = Link::read(text);
    for sentence in &wrong {
        assert!(!sentence.is_empty() && sentence.len() < 1500, "{text}: {sentence}");
    }
    if link.slide.trim().is_empty() {
        assert!(!wrong.is_empty(), "{text} leads nowhere");
        return;
    }
    let written = link.to_string();
    assert_eq!(written.parse::<Link>(), Ok(link.clone()), "{text}: {written}");
    LIBRARY.with(|library| {
        let (view, wrong) = link.view(library);
        assert!(view.is_some() || !wrong.is_empty(), "{text}");
        if let Some(view) = view {
            assert!(library.slides[view.slide].id() == link.slide || library.slide(&link.slide).is_some(), "{text}");
        }
    });
}

/// Reads settings, and the names of places.
///
/// # Panics
/// If settings make no sense, or a name stands for something else.
pub fn settings(bytes: &[u8]) {
    let text = String::from_utf8_lossy(bytes);
    let read = Remembered::read(&text);
    assert!((0.5..=3.0).contains(&read.zoom), "zoom {}", read.zoom);
    let high = read.heights;
    let panes = [high.work, high.stack, high.tree, high.ruler, high.bytes, high.changed, high.tabs];
    for size in panes.into_iter().chain([read.lesson, read.walk]).flatten() {
        assert!((1.0..=1e5).contains(&size), "a pane of {size} points");
    }
    let (last, _) = Last::read(&text);
    assert_eq!(Last::read(&last.text()), (last.clone(), Vec::new()), "what is kept is read again");
    let word = text.lines().next().unwrap_or_default();
    link(word);
    LIBRARY.with(|library| {
        if let Some(slide) = library.slide(word) {
            let names = [slide.id(), slide.name.clone(), format!("{}/{}", slide.section, slide.name)];
            // Or its number alone, or one between those that it stands for.
            let value = |text: &str| text.trim_end_matches(char::is_alphabetic).parse::<u32>().ok();
            let ends = [slide.numbers.first(), slide.numbers.last()].map(|end| end.and_then(|end| value(end)));
            let between = (ends[0]..=ends[1]).contains(&word.rsplit('/').next().and_then(value));
            assert!(names.contains(&word.to_owned()) || between, "{word} is {}", slide.id());
        }
    });
    if let Ok(size) = word.parse::<Size>() {
        assert_eq!(size.to_string().parse::<Size>(), Ok(size), "{word}");
    }
    if let Ok(rule) = read_rule(word) {
        assert!(word.trim_start().starts_with(rule.kind()), "{word}");
    }
    // Scenes that take long to make are not made.
    let is_large = ["teapot", "forest", "stadium", "grass", "trial"].iter().any(|large| word.starts_with(large));
    if !is_large && let Ok(scene) = Scene::named(word) {
        assert_eq!(scene.name, word);
    }
}
