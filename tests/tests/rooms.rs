//! Which room of a crate may know which: read from the `use` lines and paths of its sources.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// The rooms of each crate that has some, from the ground up: a room may know itself and those before it, never one
/// after it. A room is a module, by its path from `src` on (`bsp`, `window/look`): a folder or a single file, without
/// what is a room of its own below it. The root of a crate joins its rooms and is none.
const HOUSES: &[(&str, &[&str])] = &[
    (
        "crates/accel/src",
        &[
            "geometry",
            "events",
            "slab",
            "objects",
            "prims",
            "common",
            "rule",
            "list",
            "one_box",
            "grid",
            "octree",
            "bsp",
            "kd",
            "volume",
            "bvh",
            "structure",
            "instancing",
            "packet",
            "mistakes",
            "event",
        ],
    ),
    (
        "crates/fast/src",
        &[
            "lanes",
            "pages",
            "stack",
            "judge",
            "leaf",
            "build",
            "fast",
            "bvh2",
            "bvh8",
            "packet",
            "kd",
            "grid",
            "kinds",
            "instances",
            "daylight",
            "race",
        ],
    ),
    ("crates/figure/src", &["theme", "page", "words", "world", "stage", "moments", "panes", "kinds"]),
    (
        "app/src",
        &[
            "fault",
            "fields",
            "folders",
            "texts",
            "reading",
            "files",
            "report",
            "clock",
            "shown",
            "rating",
            "export",
            "window/look",
            "window/work",
            "window/panes/spoken",
            "window/panes",
            "window/panes/present",
            "window/panes/speaker",
            "window/bars",
            "window/dialogs",
            "window/keys",
            "window/wishes",
            "window",
            "cli",
        ],
    ),
];

/// In these rooms no files know each other in a circle.
const STRAIGHT: &[(&str, &[&str])] = &[
    ("app/src", &["shown", "export", "window"]),
    ("crates/figure/src", &["theme", "page", "words", "world", "stage", "moments", "panes", "kinds"]),
];

/// The sources of a crate by module path: `grid/walk` for `grid/walk.rs`, `grid` for `grid/mod.rs`, nothing for the
/// root. Tests inside them may know every room.
type Sources = BTreeMap<String, String>;

fn sources(folder: &Path, module: &str, found: &mut Sources) {
    let entries = std::fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    for entry in entries {
        let path = entry.expect("an entry of a folder").path();
        let stem = path.file_stem().expect("a name").to_str().expect("a name in Unicode");
        let name = match stem {
            "lib" | "main" | "mod" => module.to_owned(),
            _ => join(module, stem),
        };
        if path.is_dir() {
            sources(&path, &name, found);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
            found.entry(name).or_default().push_str(&code(&text));
        }
    }
}

/// A file without its comments and its tests.
fn code(text: &str) -> String {
    let text = text.split("#[cfg(test)]\nmod tests").next().unwrap_or_default();
    text.lines().map(|line| line.split("//").next().unwrap_or_default()).flat_map(|line| [line, "\n"]).collect()
}

fn join(module: &str, name: &str) -> String {
    if module.is_empty() { name.to_owned() } else { format!("{module}/{name}") }
}

/// The paths of a `use` tree, with the name that each goes by: `a::{b, c as d}` is `a/b` as b and `a/c` as d.
fn spread(tree: &str, before: &str, found: &mut Vec<(String, String)>) {
    let tree = tree.trim();
    if let Some((path, inner)) = tree.split_once('{') {
        let path = path.trim().trim_end_matches("::").split("::").fold(before.to_owned(), |all, name| join(&all, name));
        let (mut depth, mut start) = (0, 0);
        let inner = inner.strip_suffix('}').unwrap_or(inner);
        for (at, letter) in inner.char_indices().chain([(inner.len(), ',')]) {
            match letter {
                '{' => depth += 1,
                '}' => depth -= 1,
                ',' if depth == 0 => {
                    spread(&inner[start..at], &path, found);
                    start = at + 1;
                }
                _ => {}
            }
        }
    } else if !tree.is_empty() {
        let (path, name) = tree.split_once(" as ").unwrap_or((tree, ""));
        let path = path.trim().split("::").fold(before.to_owned(), |all, name| join(&all, name));
        let path = path.strip_suffix("/self").unwrap_or(&path).to_owned();
        let last = path.rsplit('/').next().unwrap_or_default();
        let name = if name.is_empty() { last } else { name.trim() }.to_owned();
        found.push((path, name));
    }
}

/// What a module says about others.
#[derive(Default)]
struct Said {
    /// Paths that it names, from the root of the crate on.
    known: Vec<String>,
    /// Names that it hands on, and what they stand for.
    handed: Vec<(String, String)>,
}

fn read(module: &str, text: &str, sources: &Sources) -> Said {
    let mut said = Said::default();
    let mut paths = Vec::new();
    let mut rest = String::new();
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        // A `use` stands first in its line, but for who may see it.
        let head = line.split_once("use ").map(|(head, _)| head.trim());
        let Some(head) = head.filter(|head| head.is_empty() || head.starts_with("pub")) else {
            rest.push_str(line);
            rest.push('\n');
            continue;
        };
        let mut statement = line.to_owned();
        while !statement.contains(';') {
            statement.push_str(lines.next().expect("the end of a use"));
        }
        let tree = statement.split_once("use ").map_or("", |(_, tree)| tree.trim_end().trim_end_matches(';'));
        let mut found = Vec::new();
        spread(tree, "", &mut found);
        paths.extend(found.into_iter().map(|(path, name)| (path, head.starts_with("pub").then_some(name))));
    }
    // Paths in the midst of code.
    for first in ["crate::", "super::"] {
        for (at, _) in rest.match_indices(first) {
            let is_start = !rest[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_' || c == ':');
            let end = rest[at..].find(|c: char| !(c.is_alphanumeric() || c == '_' || c == ':'));
            let path = rest[at..].get(..end.unwrap_or(rest.len() - at)).unwrap_or_default();
            if is_start {
                paths.push((path.trim_end_matches(':').replace("::", "/"), None));
            }
        }
    }
    for (path, handed) in paths {
        if let Some(path) = from_the_root(module, &path, sources) {
            said.handed.extend(handed.map(|name| (join(module, &name), path.clone())));
            said.known.push(path);
        }
    }
    said
}

/// A path as the module means it; nothing for what lies outside the crate.
fn from_the_root(module: &str, path: &str, sources: &Sources) -> Option<String> {
    let mut here = module.to_owned();
    let mut names = path.split('/').peekable();
    let first = *names.peek()?;
    if !["crate", "self", "super"].contains(&first) && !sources.contains_key(&join(module, first)) {
        return None;
    }
    for name in names {
        here = match name {
            "crate" => String::new(),
            "self" => here,
            "super" => here.rsplit_once('/').map_or(String::new(), |(parent, _)| parent.to_owned()),
            name => join(&here, name),
        };
    }
    Some(here)
}

/// Whether a path is the module or lies in it.
fn lies_in(path: &str, module: &str) -> bool {
    path.strip_prefix(module).is_some_and(|rest| rest.is_empty() || rest.starts_with('/'))
}

/// The room in which a path lies: the innermost.
fn room(path: &str, rooms: &[&str]) -> Option<usize> {
    let holding = rooms.iter().enumerate().filter(|(_, room)| lies_in(path, room));
    holding.max_by_key(|(_, room)| room.len()).map(|(index, _)| index)
}

/// Names that are handed on, and what they stand for.
type Handed<'a> = BTreeMap<&'a str, &'a str>;

fn handed<'a>(said: &'a BTreeMap<&str, Said>) -> Handed<'a> {
    said.values().flat_map(|said| &said.handed).map(|(name, path)| (name.as_str(), path.as_str())).collect()
}

/// What a path stands for, through every hand it goes through.
fn home(path: &str, handed: &Handed<'_>) -> String {
    let mut path = path.to_owned();
    for _ in 0..8 {
        let Some((name, stands_for)) = handed.iter().find(|(name, _)| lies_in(&path, name)) else { break };
        path = format!("{stands_for}{}", &path[name.len()..]);
    }
    path
}

/// The files in a room that know each other in a circle, and those that know such files.
fn circle<'a>(room: &str, sources: &'a Sources) -> BTreeSet<&'a str> {
    let said: BTreeMap<&str, Said> =
        sources.iter().map(|(module, text)| (module.as_str(), read(module, text, sources))).collect();
    let handed = handed(&said);
    let inside = || sources.keys().map(String::as_str).filter(|module| lies_in(module, room));
    // A path lies in the file with the longest name.
    let file = |path: &str| inside().filter(|module| lies_in(path, module)).max_by_key(|module| module.len());
    let mut left: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for module in inside() {
        let known = left.entry(module).or_default();
        for path in &said[module].known {
            let home = home(path, &handed);
            known.extend(file(&home));
            // Who takes what a folder hands on knows the folder, and with it all that its own file knows.
            let hand = file(path).filter(|_| home != *path);
            known.extend(hand.filter(|hand| !lies_in(module, hand) && !lies_in(hand, module)));
        }
        known.remove(module);
    }
    // Whoever knows nobody who is left may go.
    while let Some(free) = left.iter().find(|(_, known)| known.is_empty()).map(|(module, _)| *module) {
        left.remove(free);
        for known in left.values_mut() {
            known.remove(free);
        }
    }
    left.into_keys().collect()
}

/// Every sentence that is to be said about the rooms: modules without a room, rooms without a module, arrows upwards.
fn complaints(rooms: &[&str], sources: &Sources) -> BTreeSet<String> {
    let said: BTreeMap<&str, Said> =
        sources.iter().map(|(module, text)| (module.as_str(), read(module, text, sources))).collect();
    let handed = handed(&said);
    let mut found = BTreeSet::new();
    for room in rooms.iter().filter(|room| !sources.contains_key(**room)) {
        found.insert(format!("there is no room {room}"));
    }
    for (module, said) in said.iter().filter(|(module, _)| !module.is_empty()) {
        let Some(here) = room(module, rooms) else {
            found.insert(format!("{module} stands in no room: say where it belongs"));
            continue;
        };
        for path in &said.known {
            let home = home(path, &handed);
            if let Some(there) = room(&home, rooms).filter(|there| *there > here) {
                found.insert(format!("{module} may not know {home}: {} stands below {}", rooms[here], rooms[there]));
            }
        }
    }
    found
}

#[test]
fn arrows_between_rooms_run_downwards() {
    for (src, rooms) in HOUSES {
        let mut found = Sources::new();
        sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(src), "", &mut found);
        let complaints = complaints(rooms, &found);
        assert!(complaints.is_empty(), "{src}:\n{}", complaints.into_iter().collect::<Vec<_>>().join("\n"));
    }
}

#[test]
fn files_stand_in_no_circle() {
    for (src, rooms) in STRAIGHT {
        let mut found = Sources::new();
        sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(src), "", &mut found);
        for room in *rooms {
            let circle = circle(room, &found);
            assert!(circle.is_empty(), "{src}: in a circle, or above one: {circle:?}");
        }
    }
}

#[test]
fn a_circle_is_found() {
    let check = |line: &str, expected: &[&str]| {
        let sources: Sources = [
            ("", "mod room;\n"),
            ("room", "mod first;\nmod second;\nmod third;\nmod inner;\npub use third::Third;\n"),
            ("room/inner", "mod deep;\nuse super::first::First;\npub use deep::Deep;\n"),
            ("room/inner/deep", ""),
            ("room/first", "use super::second::Second;\n"),
            ("room/second", line),
            ("room/third", "use super::first::First;\n"),
        ]
        .map(|(module, text)| (module.to_owned(), code(text)))
        .into();
        assert_eq!(circle("room", &sources).into_iter().collect::<Vec<_>>(), expected, "{line}");
    };
    check("", &[]);
    check("use crate::elsewhere::First;\n", &[]);
    check("use crate::room::Third;\n", &["room", "room/first", "room/inner", "room/second", "room/third"]);
    check("use super::inner::Deep;\n", &["room", "room/first", "room/inner", "room/second", "room/third"]);
    check("use super::inner::deep::Deep;\n", &[]);
}

#[test]
fn an_arrow_upwards_is_found() {
    let check = |module: &str, line: &str, expected: &[&str]| {
        let mut sources: Sources = [
            ("", "mod low;\nmod high;\npub use low::Low;\npub use high::{High, inner::Deep as Renamed};\n"),
            ("low", "pub struct Low;\n"),
            ("high", "pub mod inner;\npub(crate) mod attic;\npub use inner::Deep;\n"),
            ("high/inner", "pub struct Deep;\n"),
            ("high/attic", "pub struct Top;\n"),
        ]
        .map(|(module, text)| (module.to_owned(), text.to_owned()))
        .into();
        sources.entry(module.to_owned()).or_default().push_str(&code(line));
        let found = complaints(&["low", "high", "high/attic"], &sources);
        assert_eq!(found.iter().map(String::as_str).collect::<Vec<_>>(), expected, "{module}: {line}");
    };
    let low_knows = |path: &str, room: &str| format!("low may not know {path}: low stands below {room}");
    check("low", "use std::fmt;\n", &[]);
    check("high", "use crate::Low;\n", &[]);
    check("high/inner", "use super::super::Low;\n", &[]);
    check("low", "use crate::{Low, High};\n", &[&low_knows("high/High", "high")]);
    check("low", "use super::{\n    Renamed,\n};\n", &[&low_knows("high/inner/Deep", "high")]);
    check(
        "low",
        "use crate::{high::{self, inner::Deep}};\n",
        &[&low_knows("high/inner/Deep", "high"), &low_knows("high", "high")],
    );
    check("low", "fn f() -> crate::High {}\n", &[&low_knows("high/High", "high")]);
    check("low", "fn f() {\n    use crate::high::Deep;\n}\n", &[&low_knows("high/inner/Deep", "high")]);
    check("low", "/// See [`High`](crate::High).\n", &[]);
    check("low", "#[cfg(test)]\nmod tests {\n    use crate::High;\n}\n", &[]);
    check(
        "high/inner",
        "use super::attic::Top;\n",
        &["high/inner may not know high/attic/Top: high stands below high/attic"],
    );
    check("cellar", "", &["cellar stands in no room: say where it belongs"]);
}
