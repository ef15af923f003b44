//! The lecture as a page for a browser: every beat of every slide as a picture, and one page that steps
//! through them with the arrow keys. It needs no network.

use std::collections::HashSet;
use std::fmt::Write;
use std::path::Path;

use glam::Vec2;
use rayon::prelude::*;
use raystep_figure::Theme;
use raystep_lesson::{Library, Slide, StageKind};
use raystep_print::svg;

use super::export::bar;
use crate::export::{Ground, Session, View, rays_of_beats};
use crate::fault::Fault;
use crate::files;

/// Where the lecture is written when no window can open.
pub const FOLDER: &str = "raystep-lecture";

/// One picture of the lecture.
struct Picture<'a> {
    slide: &'a Slide,
    session: &'a Session<'a>,
    beat: usize,
    step: usize,
    file: String,
}

/// Writes the lecture as `folder`: pictures and an `index.html`. It is there whole or, as before, not at all.
///
/// # Errors
/// A sentence that says what cannot be drawn or written.
pub fn write(library: &Library, folder: &Path) -> Result<(), Fault> {
    let mut grounds = Vec::new();
    for slide in &library.slides {
        for stage in StageKind::ALL.into_iter().filter_map(|kind| slide.stage(kind)) {
            grounds.push((slide, stage, Ground::of_stage(library, slide, stage)?));
        }
    }
    let sessions: Vec<(&Slide, Vec<Session<'_>>)> = grounds
        .iter()
        .map(|(slide, stage, ground)| (*slide, Session::of_rays(ground, &rays_of_beats(slide, stage))))
        .collect();
    let pictures = pictures(&sessions);
    if pictures.is_empty() {
        return Err(Fault::new("there is nothing to draw: no slide has a beat that its ray reaches"));
    }
    let mut known = HashSet::new();
    if let Some(twice) = pictures.iter().find(|picture| !known.insert(&picture.file)) {
        return Err(Fault::new(format!("two pictures would be {}: give their rays other names", twice.file)));
    }
    let bar = bar(pictures.len());
    files::whole_folder(folder, &is_ours, |folder| {
        let draw = |picture: &Picture<'_>| {
            bar.inc(1);
            let size = Vec2::new(1600.0, 1000.0);
            let (figure, _) =
                picture.session.figure(View::Plate, picture.step, Some(picture.beat), size, &Theme::LIGHT)?;
            files::write(&folder.join(&picture.file), svg(&figure, &Theme::LIGHT).as_bytes())
        };
        pictures.par_iter().try_for_each(draw)?;
        bar.finish_and_clear();
        files::write(&folder.join(INDEX_NAME), index(&pictures).as_bytes())
    })
}

/// Whether a file of that name is written by [`write`]: only then an older one is replaced.
fn is_ours(name: &str) -> bool {
    name == INDEX_NAME || name.starts_with("slide") && name.ends_with(".svg")
}

const INDEX_NAME: &str = "index.html";

/// The beats in the order of the lecture: of each slide and stage, one after the other.
fn pictures<'a>(sessions: &'a [(&'a Slide, Vec<Session<'a>>)]) -> Vec<Picture<'a>> {
    let mut pictures = Vec::new();
    for (slide, sessions) in sessions {
        for beat in 0..slide.beats.len() {
            let Some(session) = sessions.iter().find(|session| session.is_told_here(beat)) else { continue };
            let Some(step) = session.step_of(beat) else { continue };
            let file = format!("{}-beat{:02}.svg", session.file_stem(), beat + 1);
            pictures.push(Picture { slide, session, beat, step, file });
        }
    }
    pictures
}

/// The page.
fn index(pictures: &[Picture<'_>]) -> String {
    let mut entries = String::new();
    for (index, picture) in pictures.iter().enumerate() {
        let slide = picture.slide;
        let before = index.checked_sub(1).map(|before| &pictures[before]);
        let starts = before.is_none_or(|before| !is_same_stage(before, picture));
        let title = format!("{} · {} ({})", slide.section_title(), slide.title, picture.session.stage_name());
        // JSON is JavaScript; a "<" could end the script.
        let entry = serde_json::json!([picture.file, title, u8::from(starts)]).to_string().replace('<', "\\u003c");
        let _ = writeln!(entries, "  {entry},");
    }
    INDEX.replace("/*pictures*/", &entries)
}

/// Whether both show the same slide on the same stage, whatever their titles.
fn is_same_stage(a: &Picture<'_>, b: &Picture<'_>) -> bool {
    std::ptr::eq(a.slide, b.slide) && a.session.stage_name() == b.session.stage_name()
}

const INDEX: &str = include_str!("page.html");
