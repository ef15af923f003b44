//! `raystep handout`: the lecture on pages to be printed, a few beats each, with questions, and the answers at the end.

mod entry;
mod sheet;

use std::collections::HashSet;
use std::fmt::Write;
use std::path::PathBuf;

use clap::Args;
use rayon::prelude::*;
use raystep_figure::{Figure, Theme};
use raystep_lesson::{Library, NamedRay, Slide, StageKind};
use raystep_print::{Leaf, Manner, Passage, pdf_pages, svg};

use super::lessons::Lessons;
use super::page::escaped;
use super::progress::bar;
use crate::export::{Ground, Session, rays_of_beats};
use crate::fault::Fault;
use crate::files;
use crate::shown::unknown::no_slide;
use entry::{Entry, answers, entries};
use sheet::{A4, HEIGHT, Sheet, WIDTH};

/// What to print.
#[derive(Args, Debug)]
pub struct HandoutArguments {
    /// The folder to write to: pages, and a handout.html that holds them all.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// A handout.pdf of all pages as well.
    #[arg(long)]
    pdf: bool,
    /// Only these slides, as in 5/33; may be repeated.
    #[arg(long, value_name = "SLIDE")]
    slide: Vec<String>,
    /// Only this section: its number, as in 5, or its folder; may be repeated.
    #[arg(long, value_name = "SECTION")]
    section: Vec<String>,
    /// Only this stage; without it, the one that each slide opens on.
    #[arg(long, value_parser = ["flat", "solid"])]
    stage: Option<String>,
    #[command(flatten)]
    lessons: Lessons,
}

/// A page with what is read of it aloud.
struct Printed {
    figure: Figure,
    passages: Vec<Passage>,
}

impl Printed {
    /// What it shows, in words.
    fn says(&self) -> String {
        self.passages.iter().map(|passage| passage.says.as_str()).collect::<Vec<_>>().join(" ")
    }
}

/// Draws the pages and writes them.
pub(crate) fn run(arguments: &HandoutArguments) -> Result<(), Fault> {
    let library = arguments.lessons.read()?;
    let slides = chosen(&library, arguments)?;
    let mut grounds = Vec::new();
    for slide in &slides {
        let wished = arguments.stage.as_deref().and_then(|name| StageKind::ALL.into_iter().find(|k| k.name() == name));
        let stage = match wished {
            Some(kind) => slide.stage(kind),
            None => slide.opening_stage(StageKind::Flat),
        };
        if let Some(stage) = stage {
            let rays: Vec<&NamedRay> = rays_of_beats(slide, stage);
            grounds.push((*slide, Ground::of_stage(&library, slide, stage)?, rays));
        }
    }
    let sessions: Vec<(&Slide, Vec<Session<'_>>)> =
        grounds.iter().map(|(slide, ground, rays)| (*slide, Session::of_rays(ground, rays))).collect();
    let bar = bar(sessions.len() as u64, "slides");
    let drawn: Vec<Vec<Entry>> = sessions
        .par_iter()
        .map(|(slide, sessions)| {
            let drawn = entries(slide, &about(slide), sessions);
            bar.inc(1);
            drawn
        })
        .collect::<Result<_, Fault>>()?;
    bar.finish_and_clear();
    let mut drawn: Vec<(&Slide, Vec<Entry>)> =
        sessions.iter().map(|(slide, _)| *slide).zip(drawn).filter(|(_, entries)| !entries.is_empty()).collect();
    number(&mut drawn);
    let pages = pages(&drawn);
    if pages.is_empty() {
        return Err(Fault::new("there is nothing to print: no chosen slide has a beat that its ray reaches"));
    }
    let names: Vec<String> = (1..=pages.len()).map(|page| format!("page{page:03}.svg")).collect();
    let is_ours =
        |name: &str| name == INDEX_NAME || name == PDF_NAME || name.starts_with("page") && name.ends_with(".svg");
    files::whole_folder(&arguments.out, &is_ours, |folder| {
        pages.par_iter().zip(&names).try_for_each(|(page, name)| {
            files::write(&folder.join(name), svg(&page.figure, &Theme::PRINT).as_bytes())
        })?;
        if arguments.pdf {
            let leaves: Vec<Leaf<'_>> =
                pages.iter().map(|page| Leaf { figure: &page.figure, passages: &page.passages }).collect();
            let manner = Manner { scale: A4 / WIDTH, ..Manner::plain(&Theme::PRINT) };
            let written = pdf_pages(&leaves, "Raystep: handout", &manner);
            let written = written.map_err(|error| Fault::new(error.to_string()))?;
            files::write(&folder.join(PDF_NAME), &written)?;
        }
        files::write(&folder.join(INDEX_NAME), index(&pages, &names).as_bytes())
    })?;
    let (count, out) = (pages.len(), arguments.out.display());
    let open = if arguments.pdf { PDF_NAME } else { INDEX_NAME };
    files::say(&format!("{count} {} in {out}; open its {open}", if count == 1 { "page" } else { "pages" }));
    Ok(())
}

const INDEX_NAME: &str = "handout.html";
const PDF_NAME: &str = "handout.pdf";

/// The slides that are asked for, in the order of the lecture.
fn chosen<'a>(library: &'a Library, arguments: &HandoutArguments) -> Result<Vec<&'a Slide>, Fault> {
    if let Some(wrong) = arguments.slide.iter().find(|id| library.slide(id).is_none()) {
        return Err(Fault::new(no_slide(library, wrong)));
    }
    let number = |slide: &Slide| slide.id().split('/').next().unwrap_or_default().to_owned();
    let is_of = |slide: &Slide, section: &str| number(slide) == section || slide.section == section;
    if let Some(wrong) = arguments.section.iter().find(|name| !library.slides.iter().any(|slide| is_of(slide, name))) {
        let mut known: Vec<String> =
            library.slides.iter().map(|slide| format!("{} ({})", number(slide), slide.section_title())).collect();
        known.dedup();
        return Err(Fault::new(format!("there is no section \"{wrong}\"; there are {}", known.join(", "))));
    }
    let named: HashSet<String> =
        arguments.slide.iter().filter_map(|id| library.slide(id)).map(|slide| slide.file.clone()).collect();
    let all = arguments.slide.is_empty() && arguments.section.is_empty();
    let wanted = |slide: &&Slide| {
        all || named.contains(&slide.file) || arguments.section.iter().any(|section| is_of(slide, section))
    };
    Ok(library.slides.iter().filter(wanted).collect())
}

/// Of which slide a sheet is.
fn about(slide: &Slide) -> String {
    format!("{} · {}", slide.section_title(), slide.numbers_text())
}

/// Numbers the questions from the first page to the last.
fn number(drawn: &mut [(&Slide, Vec<Entry>)]) {
    let asked = drawn.iter_mut().flat_map(|(_, entries)| entries).filter(|entry| entry.asks());
    for (entry, number) in asked.zip(1..) {
        entry.number = number;
    }
}

/// The pages: each slide begins on one of its own, then come the answers.
fn pages(drawn: &[(&Slide, Vec<Entry>)]) -> Vec<Printed> {
    let mut pages = Vec::new();
    for (slide, entries) in drawn {
        let about = about(slide);
        let mut sheet = Sheet::new(&slide.title, &about);
        for entry in entries {
            sheet.add(entry.piece());
        }
        pages.extend(sheet.finish());
    }
    if drawn.iter().any(|(_, entries)| entries.iter().any(Entry::asks)) {
        let mut sheet = Sheet::new("Answers", "At the end of this handout");
        for (slide, entries) in drawn {
            for entry in entries.iter().filter(|entry| entry.asks()) {
                sheet.add(answers(entry, &format!("{} · {}", slide.numbers_text(), slide.title)));
            }
        }
        pages.extend(sheet.finish());
    }
    let count = pages.len();
    pages.into_iter().zip(1..).map(|(page, number)| page.numbered(number, count)).collect()
}

/// All pages, one below the other, each of them one sheet of paper.
fn index(pages: &[Printed], names: &[String]) -> String {
    let mut shown = String::new();
    for ((page, name), number) in pages.iter().zip(names).zip(1..) {
        let says = escaped(&format!("Page {number} of {}. {}", pages.len(), page.says()));
        let _ = writeln!(
            shown,
            "<img loading=\"lazy\" width=\"{WIDTH}\" height=\"{HEIGHT}\" src=\"{name}\" alt=\"{says}\">"
        );
    }
    INDEX.replace("<!--pages-->", &shown)
}

const INDEX: &str = include_str!("handout.html");
