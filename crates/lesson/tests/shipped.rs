//! The lessons that come with the program are right.

use raystep_accel::{PrimId, Primitives, Random, Ray};
use raystep_lesson::{Library, Play, Plays, Slide, StageKind, check};

#[test]
fn nothing_is_wrong_in_the_shipped_lessons() {
    let problems = check(&Library::embedded(), &|_, _| Vec::new());
    let text: Vec<String> = problems.iter().map(ToString::to_string).collect();
    assert!(problems.is_empty(), "{}", text.join("\n"));
}

#[test]
fn there_are_slides_on_every_topic_and_their_names_are_their_own() {
    let library = Library::embedded();
    let ids: Vec<String> = library.slides.iter().map(Slide::id).collect();
    let mut unique = ids.clone();
    unique.sort();
    unique.dedup();
    assert_eq!(ids.len(), unique.len(), "{ids:?}");
    // All structures are shown on both stages; only instances are solid alone, since they place meshes. Walks side by
    // side are flat, boards have no stage, and pairs lie in a space of their own.
    let staged = |slide: &&Slide| {
        slide.section != "02-slabs" && !matches!(slide.plays, Plays::Board | Plays::Walks | Plays::Pairs)
    };
    for slide in library.slides.iter().filter(staged) {
        let placed = slide.stages.iter().any(|stage| stage.scene.starts_with("forest"));
        // What is taken out of a tree and put into it is dragged in the plane.
        let changed = slide.stages.iter().any(|stage| !stage.changes.is_empty());
        assert_eq!(slide.stages.len(), if placed || changed { 1 } else { 2 }, "{}", slide.file);
    }
}

#[test]
fn every_slide_of_the_lecture_is_covered_and_asks() {
    let library = Library::embedded();
    let mut covered = Vec::new();
    for slide in &library.slides {
        let numbers =
            slide.numbers.iter().filter_map(|number| number.trim_end_matches(char::is_alphabetic).parse().ok());
        let numbers: Vec<u32> = numbers.collect();
        // Two numbers are a range.
        covered.extend(*numbers.iter().min().unwrap()..=*numbers.iter().max().unwrap());
        assert!(slide.beats.iter().any(|beat| beat.ask.is_some()), "{} asks nothing", slide.file);
        let walked = slide.plays.has_rays();
        assert!(!walked || slide.stages.iter().all(|stage| stage.rays.len() >= 2), "{} has one ray", slide.file);
        assert!(!slide.notes.is_empty(), "{} has no notes", slide.file);
    }
    let missing: Vec<u32> = (1..=66).filter(|number| !covered.contains(number)).collect();
    assert!(missing.is_empty(), "{missing:?}");
}

/// Every question on this ray has one right answer, and every other answer its reason.
fn check_questions(slide: &Slide, play: &Play) {
    for (beat, step) in slide.beats.iter().zip(&play.beats) {
        let (Some(ask), Some(step)) = (&beat.ask, step) else { continue };
        let choices = ask.choices(play, *step);
        let right = choices.iter().filter(|choice| choice.right).count();
        assert_eq!(right, 1, "{}: {} on {:?}: {choices:?}", slide.file, beat.title, play.tape.ray());
        for choice in choices.iter().filter(|choice| !choice.right) {
            assert!(choice.reason.is_some(), "{}: {}: no reason for {choice:?}", slide.file, beat.title);
        }
    }
}

#[test]
fn questions_have_one_right_answer_and_reasons_for_the_others_on_every_ray() {
    let library = Library::embedded();
    let mut random = Random::new(15);
    for slide in &library.slides {
        for stage in &slide.stages {
            let built = stage.draft(slide.plays).unwrap();
            if let (false, Some(play)) = (slide.plays.has_rays(), built.play(None, &slide.beats)) {
                check_questions(slide, &play);
                continue;
            }
            let scene = built.scene.clone();
            let play = |ray| built.play(Some(ray), &slide.beats).unwrap();
            for ray in &stage.rays {
                check_questions(slide, &play(ray.ray));
            }
            if stage.kind == StageKind::Solid {
                continue;
            }
            // Rays that nobody chose, around the scene and in it.
            let bounds = (0..scene.prims.len())
                .fold(raystep_accel::Aabb::EMPTY, |all, prim| all.union(scene.prims.bounds(PrimId(prim as u32))));
            let mut point = || {
                let mut part = || random.below(1000) as f32 / 500.0 - 0.5;
                let at = bounds.min + bounds.extent() * glam::Vec3::new(part(), part(), 0.0);
                glam::Vec3::new(at.x, at.y, 0.0)
            };
            for _ in 0..50 {
                let (from, towards) = (point(), point());
                if let Ok(ray) = Ray::new(from, towards - from) {
                    check_questions(slide, &play(ray));
                }
            }
        }
    }
}
