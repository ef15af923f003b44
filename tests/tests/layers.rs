//! Which crate may know which: read from the manifests and from the lock file.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use toml::Table;

/// Every arrow that is allowed between the crates of this project.
const ARROWS: &[(&str, &[&str])] = &[
    ("raystep-accel", &[]),
    ("raystep-scene", &["raystep-accel"]),
    ("raystep-fast", &["raystep-accel"]),
    ("raystep-lesson", &["raystep-scene", "raystep-fast", "raystep-accel"]),
    ("raystep-figure", &["raystep-accel"]),
    ("raystep-paint", &["raystep-figure", "raystep-fast", "raystep-accel"]),
    ("raystep-print", &["raystep-figure", "raystep-accel"]),
    (
        "raystep",
        &[
            "raystep-accel",
            "raystep-scene",
            "raystep-fast",
            "raystep-lesson",
            "raystep-figure",
            "raystep-paint",
            "raystep-print",
        ],
    ),
    (
        "raystep-tests",
        &[
            "raystep-accel",
            "raystep-scene",
            "raystep-fast",
            "raystep-lesson",
            "raystep-figure",
            "raystep-paint",
            "raystep-print",
            "raystep",
        ],
    ),
];

/// Only these may name the window and the GPU.
const WINDOW: &[&str] = &["raystep", "raystep-paint", "raystep-tests"];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn read(path: &Path) -> Table {
    let text = std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    text.parse().unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Package name → names of what it depends on, its own tests included when `all`.
fn manifests(all: bool) -> BTreeMap<String, Vec<String>> {
    let mut folders = vec![root().join("app"), root().join("tests")];
    let crates = std::fs::read_dir(root().join("crates")).expect("the folder crates");
    folders.extend(crates.map(|entry| entry.expect("an entry of crates").path()));
    let mut found = BTreeMap::new();
    for folder in folders {
        let manifest = read(&folder.join("Cargo.toml"));
        let name = manifest["package"]["name"].as_str().expect("a package name").to_owned();
        let kinds: &[&str] = if all { &["dependencies", "dev-dependencies"] } else { &["dependencies"] };
        let tables = kinds.iter().filter_map(|kind| manifest.get(*kind)?.as_table());
        found.insert(name, tables.flat_map(|table| table.keys().cloned()).collect());
    }
    found
}

#[test]
fn arrows_run_downwards() {
    let manifests = manifests(false);
    let mut known: Vec<_> = ARROWS.iter().map(|(name, _)| *name).collect();
    known.sort_unstable();
    let found: Vec<_> = manifests.keys().map(String::as_str).collect();
    assert_eq!(found, known, "a crate came or went: say in this test what it may know");
    for (name, allowed) in ARROWS {
        for needed in manifests[*name].iter().filter(|needed| needed.starts_with("raystep")) {
            assert!(allowed.contains(&needed.as_str()), "{name} may not depend on {needed}");
        }
    }
}

#[test]
fn the_textbook_needs_little() {
    for needed in &manifests(false)["raystep-accel"] {
        assert!(["glam", "libm"].contains(&needed.as_str()), "raystep-accel may not depend on {needed}");
    }
}

#[test]
fn only_the_window_and_the_painter_know_the_gpu() {
    for (name, needs) in manifests(true) {
        let gpu = needs.iter().find(|needed| needed.contains("egui") || *needed == "eframe" || *needed == "wgpu");
        if let Some(gpu) = gpu {
            assert!(WINDOW.contains(&name.as_str()), "{name} may not depend on {gpu}");
        }
    }
}

/// The rooms of the app that every way of showing slides shares.
const SHARED: &[&str] = &["shown", "export", "fault.rs", "files.rs"];

#[test]
fn what_every_window_shares_knows_none() {
    let mut files: Vec<PathBuf> = SHARED.iter().map(|name| root().join("app/src").join(name)).collect();
    while let Some(file) = files.pop() {
        if file.is_dir() {
            files.extend(std::fs::read_dir(&file).expect("a folder").map(|entry| entry.expect("an entry").path()));
            continue;
        }
        let text = std::fs::read_to_string(&file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
        for named in ["egui", "eframe", "wgpu", "raystep_paint"] {
            assert!(!text.contains(named), "{} may not name {named}", file.display());
        }
    }
}

#[test]
fn one_copy_of_each_shared_library() {
    let lock = read(&root().join("Cargo.lock"));
    let packages = lock["package"].as_array().expect("packages in the lock file");
    for shared in ["egui", "wgpu", "glam"] {
        let copies = packages.iter().filter(|package| package["name"].as_str() == Some(shared)).count();
        assert_eq!(copies, 1, "{copies} copies of {shared} in Cargo.lock");
    }
}
