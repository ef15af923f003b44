//! The lecture as a page for a browser: every beat of every slide as a picture, and one page that steps
//! through them with the arrow keys. It needs no network.

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

/// Writes the lecture into `folder`: pictures and an `index.html`.
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
    files::folder(folder)?;
    let bar = bar(pictures.len());
    let draw = |picture: &Picture<'_>| {
        bar.inc(1);
        let size = Vec2::new(1600.0, 1000.0);
        let (figure, _) = picture.session.figure(View::Plate, picture.step, Some(picture.beat), size, &Theme::LIGHT)?;
        files::write(&folder.join(&picture.file), svg(&figure, &Theme::LIGHT).as_bytes())
    };
    pictures.par_iter().try_for_each(draw)?;
    bar.finish_and_clear();
    files::write(&folder.join("index.html"), index(&pictures).as_bytes())
}

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
    for picture in pictures {
        let slide = picture.slide;
        let title = format!("{} · {} ({})", slide.section_title(), slide.title, picture.session.stage_name());
        // JSON is JavaScript; a "<" could end the script.
        let entry = serde_json::json!([picture.file, title]).to_string().replace('<', "\\u003c");
        let _ = writeln!(entries, "  {entry},");
    }
    INDEX.replace("/*pictures*/", &entries)
}

const INDEX: &str = include_str!("page.html");
