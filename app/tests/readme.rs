//! What the README promises of the command line: every line of it is understood, and every ray in it hits something.

use std::path::{Path, PathBuf};
use std::process::Command;

use clap::Parser;
use raystep::cli::Arguments;
use raystep::shown::Link;
use raystep_lesson::Library;

const README: &str = include_str!("../../README.md");

/// The lines of the README that call Raystep, without what they are said to do.
fn calls() -> Vec<Vec<String>> {
    let block =
        README.split("```").find(|block| block.trim_start().starts_with("raystep ")).expect("a list of commands");
    let lines = block.lines().filter(|line| line.starts_with("raystep"));
    lines.map(|line| words(line.split("   ").next().unwrap_or(line))).collect()
}

/// Words as a shell takes them; quoted ones stay together.
fn words(line: &str) -> Vec<String> {
    let mut words = Vec::new();
    for (index, part) in line.split('"').enumerate() {
        match index % 2 {
            0 => words.extend(part.split_whitespace().map(str::to_owned)),
            _ => words.push(part.to_owned()),
        }
    }
    words
}

#[test]
fn every_line_is_understood() {
    let calls = calls();
    assert!(calls.len() > 12, "{calls:?}");
    for call in calls {
        if let Err(error) = Arguments::try_parse_from(&call) {
            panic!("{call:?}: {error}");
        }
    }
}

/// Every slide, ray and step that a line or a link of the README names is in the lecture.
#[test]
fn every_place_is_there() {
    let library = Library::embedded();
    let mut places = 0;
    let mut there = |link: &str| {
        let link: Link = link.parse().unwrap_or_else(|wrong| panic!("{link}: {wrong}"));
        let (view, wrong) = link.view(&library);
        assert!(view.is_some() && wrong.is_empty(), "{link}: {wrong:?}");
        places += 1;
    };
    let after = |call: &[String], key: &str| call.windows(2).find(|pair| pair[0] == key).map(|pair| pair[1].clone());
    for call in calls() {
        if let Some(link) = after(&call, "--at") {
            there(&link);
        }
        let slide = after(&call, "--slide");
        if let (Some(slide), Some(ray)) = (slide, after(&call, "--ray").filter(|ray| !ray.contains(','))) {
            there(&Link { slide, ray: Some(ray), ..Link::default() }.to_string());
        }
    }
    let links = README.split('`').filter(|text| text.contains('?') && text.contains("step=") && !text.contains('\n'));
    links.for_each(&mut there);
    assert!(places >= 3, "{places}");
}

/// A folder with the files that the lines name: a mesh, and rays at it.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("readme").join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    std::fs::write(folder.join("model.obj"), "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n").unwrap();
    std::fs::write(folder.join("rays.csv"), "ox,oy,oz,dx,dy,dz\n1,1,5,0,0,-1\n").unwrap();
    folder
}

#[test]
fn every_ray_hits_something() {
    let folder = folder("rays");
    let traced = calls().into_iter().filter(|call| call.get(1).is_some_and(|word| word == "trace"));
    let mut hits = 0;
    for call in traced {
        let output =
            Command::new(env!("CARGO_BIN_EXE_raystep")).args(&call[1..]).current_dir(&folder).output().unwrap();
        let (mut told, said) = (String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap());
        assert!(output.status.success(), "{call:?}: {said}");
        if let Some(out) = call.iter().position(|word| word == "--out") {
            told = std::fs::read_to_string(folder.join(&call[out + 1])).unwrap();
        }
        let met = ["The ray hits primitive", "\"hit\":{", "\"hit\": {", ",true,"];
        assert!(met.iter().any(|met| told.contains(met)), "{call:?} hits nothing: {told}");
        hits += 1;
    }
    assert!(hits >= 4, "{hits} lines trace rays");
}

#[test]
fn what_is_quick_is_done() {
    let folder = folder("quick");
    let quick = |call: &[String]| match call.get(1).map(String::as_str) {
        Some("export") => !call.contains(&"--all".to_owned()),
        Some("handout") => call.contains(&"--slide".to_owned()),
        _ => false,
    };
    let mut done = 0;
    for call in calls().into_iter().filter(|call| quick(call)) {
        let output =
            Command::new(env!("CARGO_BIN_EXE_raystep")).args(&call[1..]).current_dir(&folder).output().unwrap();
        assert!(output.status.success(), "{call:?}: {}", String::from_utf8_lossy(&output.stderr));
        done += 1;
    }
    assert!(done >= 2, "{done} lines write pictures");
}
