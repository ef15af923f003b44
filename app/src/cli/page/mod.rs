//! The lecture as a page for a browser: every beat of every slide as a picture with its text, its question and its
//! answer, stepped through with the arrow keys or by a finger. It needs no network.

mod html;

use std::collections::HashSet;
use std::fmt::Write;
use std::path::Path;

use glam::Vec2;
use rayon::prelude::*;
use raystep_figure::Theme;
use raystep_lesson::{Library, Slide, StageKind};
use raystep_print::{Layer, stack, svg};

use super::progress::bar;
use crate::export::{Asked, Ground, Session, Telling, View, rays_of_beats};
use crate::fault::Fault;
use crate::files;
pub(super) use html::{escaped, html, plain};

/// Where the lecture is written when no window can open.
pub const FOLDER: &str = "raystep-lecture";

/// A slide on one of its stages: one file of pictures.
struct Stack<'a> {
    slide: &'a Slide,
    stage: &'static str,
    file: String,
    beats: Vec<Beat<'a>>,
}

/// One picture of it.
struct Beat<'a> {
    session: &'a Session<'a>,
    beat: usize,
    step: usize,
    name: String,
    telling: Telling,
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
    let stacks: Vec<Stack<'_>> = sessions.iter().filter_map(|(slide, sessions)| stack_of(slide, sessions)).collect();
    if stacks.is_empty() {
        return Err(Fault::new("there is nothing to draw: no slide has a beat that its ray reaches"));
    }
    let mut known = HashSet::new();
    if let Some(twice) = stacks.iter().find(|stack| !known.insert(&stack.file)) {
        return Err(Fault::new(format!("two slides would be {}: give them other names", twice.file)));
    }
    let bar = bar(stacks.iter().map(|stack| stack.beats.len() as u64).sum(), "pictures");
    files::whole_folder(folder, &is_ours, |folder| {
        stacks.par_iter().try_for_each(|stack| {
            let layers = stack.layers(&|| bar.inc(1))?;
            files::write(&folder.join(&stack.file), self::stack(&layers).as_bytes())
        })?;
        bar.finish_and_clear();
        files::write(&folder.join(INDEX_NAME), index(&stacks).as_bytes())
    })
}

/// Whether a file of that name is written by [`write`]: only then an older one is replaced.
fn is_ours(name: &str) -> bool {
    name == INDEX_NAME || name.starts_with("slide") && name.ends_with(".svg")
}

const INDEX_NAME: &str = "index.html";

/// The beats of a slide on a stage, in order; nothing if none is reached.
fn stack_of<'a>(slide: &'a Slide, sessions: &'a [Session<'a>]) -> Option<Stack<'a>> {
    let beat = |beat: usize| {
        let session = sessions.iter().find(|session| session.is_told_here(beat))?;
        let (step, telling) = (session.step_of(beat)?, session.telling(beat)?);
        Some(Beat { session, beat, step, name: format!("beat{:02}", beat + 1), telling })
    };
    let beats: Vec<Beat<'_>> = (0..slide.beats.len()).filter_map(beat).collect();
    let first = sessions.first()?;
    let file = format!("{}.svg", first.file_stem());
    (!beats.is_empty()).then(|| Stack { slide, stage: first.stage_name(), file, beats })
}

impl Stack<'_> {
    /// The pictures: of a beat that asks, first the one in which it is asked.
    fn layers(&self, drawn: &(dyn Fn() + Sync)) -> Result<Vec<Layer>, Fault> {
        let layer = |beat: &Beat<'_>, asked: Option<usize>| {
            let size = Vec2::new(1600.0, 1000.0);
            let (step, told) = asked.map_or((beat.step, Some(beat.beat)), |before| (before, None));
            let (figure, _) = beat.session.figure(View::Plate, step, told, size, &Theme::LIGHT)?;
            let (name, says) = match asked {
                Some(_) => (beat.asked_name(), beat.asked_alt()),
                None => (beat.name.clone(), beat.alt()),
            };
            Ok(Layer { name, says, svg: svg(&figure, &Theme::LIGHT) })
        };
        let mut layers = Vec::new();
        for beat in &self.beats {
            if let Some(asked) = &beat.telling.asked {
                layers.push(layer(beat, Some(asked.before))?);
            }
            layers.push(layer(beat, None)?);
            drawn();
        }
        Ok(layers)
    }

    /// The slide's name on the page.
    fn title(&self) -> String {
        format!("{} · {}", self.slide.numbers_text(), self.slide.title)
    }

    fn html(&self) -> String {
        let mut out = String::new();
        for beat in &self.beats {
            let on = match beat.session.ray_name() {
                Some(ray) => format!("{} · {} · {ray}", self.slide.section_title(), self.stage),
                None => format!("{} · {}", self.slide.section_title(), self.stage),
            };
            let file = escaped(&self.file);
            let link = match beat.telling.asked {
                None => format!("href=\"{file}#{}\"", beat.name),
                Some(_) => format!(
                    "href=\"{file}#{}\" data-href=\"{file}#{}\" data-alt=\"{}\"",
                    beat.asked_name(),
                    beat.name,
                    escaped(&beat.alt()),
                ),
            };
            let alt = if beat.telling.asked.is_some() { beat.asked_alt() } else { beat.alt() };
            let _ = write!(
                out,
                "<section>\n<p class=\"about\">{}</p>\n<h2>{}</h2>\n<a {link}><img width=\"1600\" height=\"1000\" \
                 alt=\"{}\"></a>\n<div class=\"said\">\n",
                escaped(&format!("{} · {on}", self.slide.numbers_text())),
                escaped(&self.slide.title),
                escaped(&alt),
            );
            // The question comes before what is said, which answers it.
            let said = format!("<h3>{}</h3>\n{}", inline(&beat.telling.heading), html(&beat.telling.text));
            match &beat.telling.asked {
                Some(asked) => out += &question(asked, &said),
                None => out += &said,
            }
            out += "</div>\n</section>\n";
        }
        out
    }
}

impl Beat<'_> {
    /// What the picture is called in which its question is asked.
    fn asked_name(&self) -> String {
        format!("{}-asked", self.name)
    }

    /// What that picture shows.
    fn asked_alt(&self) -> String {
        let before = self.telling.asked.as_ref().map_or(0, |asked| asked.before);
        format!("Step {before} of {}: {}", self.session.steps(), plain(&self.session.shows(before)))
    }

    /// What the picture shows.
    fn alt(&self) -> String {
        let heading = plain(&self.telling.heading);
        format!("{heading}. Step {} of {}: {}", self.step, self.session.steps(), plain(&self.telling.shows))
    }
}

/// A question, and what is said once it is answered.
fn question(asked: &Asked, said: &str) -> String {
    let mut out = format!("<div class=\"question\">{}\n<ol type=\"A\">\n", html(&asked.question));
    asked.answers.iter().for_each(|answer| _ = writeln!(out, "<li>{}</li>", inline(&answer.label)));
    out += "</ol>\n</div>\n<details><summary>Answer</summary>\n";
    out += &answers(asked);
    out += said;
    out + "</details>\n"
}

/// The right answer, and why the others are wrong.
pub(super) fn answers(asked: &Asked) -> String {
    let mut out = String::new();
    for (letter, answer) in ('A'..='Z').zip(&asked.answers) {
        let label = inline(&answer.label);
        match &answer.reason {
            _ if answer.right => _ = writeln!(out, "<p class=\"right\"><b>{letter}: {label}</b></p>"),
            Some(reason) => _ = writeln!(out, "<p class=\"wrong\">Not {letter}, {label}: {}</p>", inline(reason)),
            None => {}
        }
    }
    out
}

/// A text of one paragraph, without that.
pub(super) fn inline(markdown: &str) -> String {
    let whole = html(markdown);
    let bare = whole.strip_prefix("<p>").and_then(|rest| rest.strip_suffix("</p>"));
    bare.filter(|bare| !bare.contains("<p>")).map(str::to_owned).unwrap_or(whole)
}

/// The page.
fn index(stacks: &[Stack<'_>]) -> String {
    let mut options = String::new();
    let mut at = 0;
    for section in stacks.chunk_by(|a, b| a.slide.section == b.slide.section) {
        let _ = writeln!(options, "<optgroup label=\"{}\">", escaped(section[0].slide.section_title()));
        for stack in section {
            let twice = section.iter().filter(|other| std::ptr::eq(other.slide, stack.slide)).count() > 1;
            let on = if twice { format!(" ({})", stack.stage) } else { String::new() };
            let _ = writeln!(options, "<option value=\"{at}\">{}{on}</option>", escaped(&stack.title()));
            at += stack.beats.len();
        }
        options += "</optgroup>\n";
    }
    let beats: String = stacks.iter().map(Stack::html).collect();
    INDEX.replace("<!--slides-->", &options).replace("<!--beats-->", &beats)
}

const INDEX: &str = include_str!("page.html");
