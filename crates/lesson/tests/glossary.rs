//! The glossary and the vocabulary of events name the same things, in the same order.

use raystep_accel::{Abreast, Fit, Grow, Reveal, Trial, Visit};

const GLOSSARY: &str = include_str!("../../../lessons/glossary.md");

/// The names listed under a heading, each with a few words.
fn listed(heading: &str) -> Vec<&'static str> {
    let section = GLOSSARY.split("\n## ").find(|section| section.starts_with(heading)).unwrap_or_default();
    let lines = section.lines().filter_map(|line| line.strip_prefix("- `"));
    lines
        .filter_map(|line| line.split_once("`: "))
        .filter(|(_, words)| words.len() > 10)
        .map(|(name, _)| name)
        .collect()
}

fn names(vocabulary: &[(&'static [&'static str], &[&str])]) -> Vec<&'static str> {
    vocabulary.iter().flat_map(|(names, _)| names.iter().copied()).collect()
}

#[test]
fn every_event_is_in_the_glossary_and_nothing_else() {
    assert_eq!(listed("Walks"), names(Visit::NAMES));
    assert_eq!(listed("Builders"), names(Grow::NAMES));
    assert_eq!(listed("Boards"), names(Reveal::NAMES));
    assert_eq!(listed("Packets"), names(Abreast::NAMES));
    assert_eq!(listed("Fits"), names(Fit::NAMES));
    // The slabs of boxes go by the names of walks.
    let own: Vec<&str> = names(Trial::NAMES).into_iter().filter(|name| !name.starts_with("slab.")).collect();
    assert_eq!(listed("Pairs"), own);
}
