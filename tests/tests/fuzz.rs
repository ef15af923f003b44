//! Six readers and walkers take any bytes: a few thousand inputs each, and as many as one likes:
//!
//! `RAYSTEP_FUZZ_RUNS=10000000 cargo test --release -p raystep-tests --test fuzz -- --nocapture`
//!
//! `RAYSTEP_FUZZ_SEED` chooses other inputs. The slowest input and the peak of the program's memory are printed.

use std::path::Path;

use raystep_tests::fuzz::{TARGETS, drive};

/// Runs a target so many times, or as often as the environment says.
fn check(name: &str, runs: u64) {
    let number = |name: &str| std::env::var(name).ok().and_then(|text| text.parse().ok());
    let target = TARGETS.iter().find(|target| target.name == name).expect("a target of that name");
    let runs = number("RAYSTEP_FUZZ_RUNS").unwrap_or(runs);
    let keep = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let report = drive::run(target, runs, number("RAYSTEP_FUZZ_SEED").unwrap_or(1), keep);
    println!(
        "{name}: {} runs in {:.1?}, the slowest {:.1?} ({} bytes), at most {} MiB",
        report.runs,
        report.time,
        report.slowest,
        report.slowest_input.len(),
        report.peak_mib
    );
    assert!(report.peak_mib < 1024, "{name}: {} MiB", report.peak_mib);
}

#[test]
fn any_bytes_are_an_obj_or_a_sentence() {
    check("obj", 20_000);
}

#[test]
fn any_bytes_are_a_table_of_rays_or_a_sentence() {
    check("rays", 20_000);
}

#[test]
fn any_bytes_are_slides_and_scenes_or_sentences() {
    check("files", 2000);
}

#[test]
fn any_bytes_are_a_text_that_can_be_set() {
    check("texts", 1000);
}

#[test]
fn any_bytes_are_walks_that_brute_force_agrees_with() {
    check("walks", 10_000);
}

#[test]
fn any_bytes_are_settings_that_make_sense() {
    check("settings", 5000);
}
