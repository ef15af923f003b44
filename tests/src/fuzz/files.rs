//! Slides, listings, names of sections, and scenes.

use raystep_accel::Primitives;
use raystep_lesson::{Library, Slide, check};
use raystep_scene::{Scene, Scenes};

use super::Target;

pub(super) const TARGET: Target = Target {
    name: "files",
    body: files,
    words: &[
        "+++\n",
        "\n\n",
        "\n",
        "## ",
        "## Title {at=end}\n",
        "{at=split}",
        "{at=",
        "}",
        "{{",
        "}}",
        "{{t}}",
        "> ",
        "> ask {field=near}: Which?\n",
        "> ask {count=test}: How many?\n",
        "> ask {event=pop|drop}: Which?\n",
        "> - far: No.\n",
        "> - else: No.\n",
        "> if hit=yes: So.\n",
        "> if stage=flat: So.\n",
        "> if event=pop: So.\n",
        "#2",
        "|",
        "axis=x",
        " ray=\"a\"",
        "plays = \"build\"\n",
        "opens = \"solid\"\n",
        "[flat]\n",
        "[solid]\n",
        "camera = { center = [0, 0], half_height = 1 }\n",
        "kind = \"grid\"",
        "kind = \"bvh\"",
        "kind = \"list\"",
        "slab",
        "max_depth = 3",
        "resolution = \"3n\"",
        "nx = 512",
        "scene = \"flat-twelve\"",
        "promise = \"drop\"",
        "= [",
        "]",
        "\"",
        "'''",
        "\"\"\"",
        "\u{1}",
        "\u{2}",
        " | ",
        " : ",
        "split push\n",
        "enter.leaf",
        "title = \"\"\n",
        "scene = \"flat-own\"",
        "scene = \"own\"",
        "title = \"Own\"\nshapes = [\n{ disc = [2, 2], radius = 0.5 },\n]\n",
        "v 0 0 0\nv 2 0 0\nv 2 2 0\nf 1 2 3\n",
        "shapes = [",
        "{ disc = [0, 0], radius = 1 },",
        "{ polygon = [[0, 0], [1, 0], [0, 1]] },",
        "{ box = [[0, 0], [1, 1]] },",
        "\r\n",
        "\u{feff}",
        "→",
        "\0",
    ],
    seeds: &[("lessons", "md"), ("lessons/listings", "txt"), ("assets/scenes", "toml")],
};

/// Which byte begins another file: slide, then listing, then names of sections.
const NEXT: char = '\u{1}';
/// Which byte begins a scene instead.
const SCENE: char = '\u{2}';

/// Reads files of lessons and checks them where all is flat and small, or reads a scene; what is wrong is said in
/// sentences with a place.
///
/// # Panics
/// If that does not hold.
pub fn files(bytes: &[u8]) {
    let text = String::from_utf8_lossy(bytes);
    if let Some(scene) = text.strip_prefix(SCENE).or(text.starts_with("title").then_some(&*text)) {
        return self::scene(scene);
    }
    let mut parts = text.split(NEXT);
    let names = ["05-kd-tree/1-first.md", "listings/walk.txt", "sections.txt"];
    let mut part = |name: &str| Some((name.to_owned(), parts.next()?.to_owned()));
    let files: Vec<(String, String)> = names.into_iter().map_while(&mut part).collect();
    let scenes: Vec<(String, String)> = SCENES.into_iter().map_while(&mut part).collect();
    let scenes = scenes.into_iter().map(|(name, text)| (name, text.into_bytes()));
    let library = Library::from_files(files).with_scenes(scenes, &Scenes::default());
    let few = |scene: &str| library.scenes.own(scene).is_some_and(|own| own.prims.len() <= 40);
    let playable =
        |scene: &str| ["flat-twelve", "flat-overlap", "flat-trap", "flat-wall"].contains(&scene) || few(scene);
    let stages = library.slides.iter().flat_map(|slide| &slide.stages);
    // Only what is quick to play.
    let small = stages.clone().count() <= 2 && stages.clone().all(|stage| playable(&stage.scene));
    let problems = if small { check(&library, &|_, _| Vec::new()) } else { library.problems.clone() };
    // The lecture is long, and takes its time: one input in so many stands beside it.
    if bytes.iter().map(|byte| u64::from(*byte)).sum::<u64>().is_multiple_of(BESIDE) {
        beside(&library);
    }
    for problem in &problems {
        let known = names.iter().chain(&SCENES).any(|name| *name == problem.file);
        assert!(known && problem.line >= 1 && problem.column >= 1 && !problem.message.is_empty(), "{problem}");
        assert!(problem.message.chars().count() <= 1501, "a sentence of {} letters", problem.message.len());
    }
    assert!(problems.len() <= 500, "{} problems", problems.len());
}

/// One input in so many stands beside the lecture.
const BESIDE: u64 = 16;

/// The scenes beside a slide.
const SCENES: [&str; 2] = ["scenes/flat-own.toml", "scenes/own.obj"];

/// The lecture stays whole, whatever stands beside it, and no two slides are called the same.
fn beside(own: &Library) {
    thread_local!(static LECTURE: Library = Library::embedded());
    let (slides, listings) = LECTURE.with(|lecture| (lecture.slides.len(), lecture.listings.len()));
    let both = LECTURE.with(Clone::clone).and(own.clone());
    assert!(both.slides.len() <= slides + own.slides.len() && both.slides.len() >= slides);
    assert!(both.listings.len() <= listings + own.listings.len() && both.listings.len() >= listings);
    let mut ids: Vec<String> = both.slides.iter().filter(|slide| !slide.numbers.is_empty()).map(Slide::id).collect();
    ids.sort();
    let all = ids.len();
    ids.dedup();
    assert_eq!(ids.len(), all, "two slides have one number");
}

fn scene(text: &str) {
    match Scene::from_toml(text, "scene.toml") {
        Ok(scene) => {
            assert!(!scene.prims.is_empty() && scene.flat);
            assert!(scene.bounds().min.is_finite() && scene.bounds().max.is_finite());
        }
        Err(wrong) => {
            assert!(wrong.line >= 1 && !wrong.message.is_empty() && wrong.to_string().len() < 3000, "{wrong}");
        }
    }
}
