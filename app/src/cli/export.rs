//! `raystep export`: steps as pictures, without display or graphics card.

use std::collections::BTreeMap;
use std::io::IsTerminal;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use glam::Vec2;
use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;
use raystep_figure::Theme;
use raystep_lesson::{Library, NamedRay, Plays, Slide, Stage, StageKind};
use raystep_print::{PrintError, apng, gif, png, svg};

use super::fault::{Fault, about};
use super::session::{Session, View};
use super::{Size, files};

/// What to draw, how, and where to.
#[derive(Args, Debug)]
pub struct ExportArguments {
    /// The slide: section and number, as in 5/33.
    #[arg(long, value_name = "SLIDE", conflicts_with = "all", required_unless_present = "all")]
    slide: Option<String>,
    /// All slides.
    #[arg(long)]
    all: bool,
    /// The ray, by its name; without it, the ray that each beat wants.
    #[arg(long, value_name = "NAME")]
    ray: Option<String>,
    /// Only this stage; without it, every stage that the slide offers.
    #[arg(long, value_parser = ["flat", "solid"])]
    stage: Option<String>,
    /// These steps, as in 3..9; both ends are drawn.
    #[arg(long, value_name = "A..B", value_parser = steps, conflicts_with = "beats")]
    steps: Option<RangeInclusive<usize>>,
    /// The step of every beat; this is what is drawn if no steps are named.
    #[arg(long)]
    beats: bool,
    /// What to draw.
    #[arg(long, default_value = "plate")]
    view: View,
    /// The kind of file; apng and gif hold all steps of a walk in one.
    #[arg(long, default_value = "png")]
    format: Format,
    /// Width and height in pixels.
    #[arg(long, value_name = "WxH", default_value = "1600x1000")]
    size: Size,
    /// The colours.
    #[arg(long, default_value = "light", value_parser = ["light", "dark", "projector", "print"])]
    theme: String,
    /// Lessons to read instead of those in the program.
    #[arg(long, value_name = "DIR")]
    lessons: Option<PathBuf>,
    /// The folder to write to; it is made if need be.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

/// A kind of file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Format {
    /// Pixels.
    Png,
    /// Outlines that stay sharp at any size.
    Svg,
    /// A moving picture with all colours.
    Apng,
    /// A moving picture that opens everywhere.
    Gif,
    /// The whole walk as data.
    Json,
}

/// How long a moving picture shows a step.
const STEP_MILLIS: u16 = 900;

/// Draws what was asked for.
pub(crate) fn run(arguments: &ExportArguments) -> Result<(), Fault> {
    let library = match &arguments.lessons {
        Some(folder) => Library::from_dir(folder).map_err(about(folder))?,
        None => Library::embedded(),
    };
    if let Some(problem) = library.problems.first() {
        return Err(Fault::new(format!("{problem} (raystep check lists all)")));
    }
    let sessions = sessions(&library, arguments)?;
    let jobs = jobs(&sessions, arguments)?;
    if jobs.is_empty() {
        return Err(Fault::new("there is nothing to draw: none of the chosen rays reaches a beat"));
    }
    files::folder(&arguments.out)?;
    let count = jobs.len();
    let bar = bar(count);
    jobs.par_iter().try_for_each(|job| {
        bar.inc(1);
        job.write(arguments)
    })?;
    bar.finish_and_clear();
    eprintln!("raystep: {count} {} in {}", if count == 1 { "file" } else { "files" }, arguments.out.display());
    Ok(())
}

/// The walks and builds to draw.
fn sessions<'a>(library: &'a Library, arguments: &ExportArguments) -> Result<Vec<(&'a Slide, Session<'a>)>, Fault> {
    let mut sessions = Vec::new();
    for slide in chosen(library, arguments)? {
        for stage in StageKind::ALL.into_iter().filter_map(|kind| slide.stage(kind)) {
            if arguments.stage.as_deref().is_some_and(|name| name != stage.kind.name()) {
                continue;
            }
            // A build has no ray to be named.
            if slide.plays == Plays::Build && arguments.ray.is_some() {
                continue;
            }
            let rays = rays(slide, stage, arguments);
            sessions.extend(Session::open(library, slide, stage, &rays)?.into_iter().map(|session| (slide, session)));
        }
    }
    if sessions.is_empty() {
        return Err(Fault::new(nothing(library, arguments)));
    }
    Ok(sessions)
}

fn chosen<'a>(library: &'a Library, arguments: &ExportArguments) -> Result<Vec<&'a Slide>, Fault> {
    let Some(id) = &arguments.slide else { return Ok(library.slides.iter().collect()) };
    match library.slide(id) {
        Some(slide) => Ok(vec![slide]),
        None => Err(no_slide(library, id)),
    }
}

/// There is no such slide, but there are others.
pub(super) fn no_slide(library: &Library, id: &str) -> Fault {
    let known: Vec<String> = library.slides.iter().map(Slide::id).collect();
    Fault::new(format!("there is no slide \"{id}\"; there are {}", known.join(", ")))
}

/// The named ray, or those that the beats want; without beats, the stage's own.
fn rays<'a>(slide: &'a Slide, stage: &'a Stage, arguments: &ExportArguments) -> Vec<&'a NamedRay> {
    if let Some(name) = &arguments.ray {
        return stage.ray(name).into_iter().collect();
    }
    if arguments.steps.is_some() || arguments.format == Format::Json {
        return stage.rays.first().into_iter().collect();
    }
    let mut rays: Vec<&NamedRay> = Vec::new();
    for ray in (0..slide.beats.len()).filter_map(|beat| slide.ray_of(stage, beat)) {
        if !rays.iter().any(|known| known.name == ray.name) {
            rays.push(ray);
        }
    }
    rays
}

/// Why nothing was chosen.
fn nothing(library: &Library, arguments: &ExportArguments) -> String {
    let slides = chosen(library, arguments).unwrap_or_default();
    let stages = |slide: &Slide| slide.stages.iter().map(|stage| stage.kind.name()).collect::<Vec<_>>().join(" and ");
    match (slides.as_slice(), &arguments.ray, &arguments.stage) {
        ([slide], Some(_), _) if slide.plays == Plays::Build => {
            format!("slide {} plays how its structure is built: it has no rays", slide.id())
        }
        ([slide], Some(ray), _) => {
            let known: Vec<&str> =
                slide.stages.iter().flat_map(|stage| &stage.rays).map(|ray| ray.name.as_str()).collect();
            format!("slide {} has no ray \"{ray}\"; there are {}", slide.id(), known.join(", "))
        }
        ([slide], None, Some(stage)) => format!("slide {} has no {stage} stage, only {}", slide.id(), stages(slide)),
        _ => "there is no such slide, ray and stage".to_owned(),
    }
}

/// One file.
struct Job<'a> {
    session: &'a Session<'a>,
    file: String,
    /// Steps with the beat that wanted them.
    steps: Vec<(usize, Option<usize>)>,
}

fn jobs<'a>(sessions: &'a [(&Slide, Session<'a>)], arguments: &ExportArguments) -> Result<Vec<Job<'a>>, Fault> {
    let mut jobs = BTreeMap::new();
    for (slide, session) in sessions {
        let stem = session.file_stem();
        let view = if arguments.view == View::Plate { "" } else { view_name(arguments.view) };
        let last = session.steps();
        let steps: Vec<(usize, Option<usize>)> = match &arguments.steps {
            Some(range) if *range.start() > last => {
                return Err(Fault::new(format!("{stem}: the last step is {last}, before {}", range.start())));
            }
            Some(range) => (*range.start()..=last.min(*range.end())).map(|step| (step, None)).collect(),
            None => beats(slide, session, arguments),
        };
        let mut add = |file: String, steps| jobs.insert(file.clone(), Job { session, file, steps });
        match arguments.format {
            Format::Json => {
                add(format!("{stem}.json"), Vec::new());
            }
            Format::Apng | Format::Gif if !steps.is_empty() => {
                let ending = if arguments.format == Format::Gif { "gif" } else { "apng" };
                add(format!("{stem}{view}.{ending}"), steps);
            }
            Format::Apng | Format::Gif => {}
            Format::Png | Format::Svg => {
                let ending = if arguments.format == Format::Png { "png" } else { "svg" };
                for (step, beat) in steps {
                    let beat_name = beat.map_or_else(String::new, |beat| format!("-beat{:02}", beat + 1));
                    let file = format!("{stem}{view}{beat_name}-step{step:04}of{last:04}.{ending}");
                    add(file, vec![(step, beat)]);
                }
            }
        }
    }
    Ok(jobs.into_values().collect())
}

/// The beats that are told on this ray.
fn beats(slide: &Slide, session: &Session<'_>, arguments: &ExportArguments) -> Vec<(usize, Option<usize>)> {
    let own = |beat: &usize| arguments.ray.is_some() || session.is_told_here(*beat);
    (0..slide.beats.len()).filter(own).filter_map(|beat| Some((session.step_of(beat)?, Some(beat)))).collect()
}

fn view_name(view: View) -> &'static str {
    match view {
        View::Plate => "-plate",
        View::Space => "-space",
        View::Tree => "-tree",
    }
}

impl Job<'_> {
    fn write(&self, arguments: &ExportArguments) -> Result<(), Fault> {
        let path = arguments.out.join(&self.file);
        files::write(&path, &self.bytes(arguments, &path)?)
    }

    fn bytes(&self, arguments: &ExportArguments, path: &Path) -> Result<Vec<u8>, Fault> {
        let wrong = |error: PrintError| Fault::new(format!("{}: {error}", path.display()));
        if arguments.format == Format::Json {
            return self.session.json().map(String::into_bytes);
        }
        let theme = Theme::named(&arguments.theme).unwrap_or(&Theme::LIGHT);
        let pixels: Vec2 = arguments.size.into();
        let mut scale = 1.0;
        let mut drawings = Vec::new();
        for (step, beat) in &self.steps {
            let (figure, to_pixels) = self.session.figure(arguments.view, *step, *beat, pixels, theme);
            scale = to_pixels;
            drawings.push(svg(&figure, theme));
        }
        match (arguments.format, drawings.first()) {
            (Format::Apng, _) => apng(&drawings, scale, STEP_MILLIS).map_err(wrong),
            (Format::Gif, _) => gif(&drawings, scale, STEP_MILLIS).map_err(wrong),
            (Format::Png, Some(drawing)) => png(drawing, scale).map_err(wrong),
            (_, drawing) => Ok(drawing.cloned().unwrap_or_default().into_bytes()),
        }
    }
}

/// A bar on a terminal, nothing elsewhere.
pub(super) fn bar(count: usize) -> ProgressBar {
    if !std::io::stderr().is_terminal() || count < 2 {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} pictures, {eta} left");
    ProgressBar::new(count as u64).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}

/// `3..9` or `5`.
fn steps(text: &str) -> Result<RangeInclusive<usize>, String> {
    let number = |text: &str| text.trim().parse::<usize>().ok();
    let range = match text.split_once("..") {
        Some((first, last)) => number(first).zip(number(last.trim_start_matches('='))),
        None => number(text).map(|only| (only, only)),
    };
    let (first, last) = range.ok_or("write the first and the last step, as in 3..9, or one step")?;
    if first > last {
        return Err(format!("step {first} comes after step {last}: write the smaller one first"));
    }
    Ok(first..=last)
}
