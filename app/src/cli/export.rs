//! `raystep export`: steps as pictures, without display or graphics card.

use std::io::IsTerminal;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use raystep_figure::Theme;
use raystep_lesson::{Library, NamedRay, Slide, Stage, StageKind};

use super::lessons::Lessons;
use crate::export::{Format, Ground, Order, Session, Size, View, Which, jobs, pictures, rays_of_beats, write};
use crate::fault::Fault;
use crate::files;

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
    #[command(flatten)]
    lessons: Lessons,
    /// The folder to write to; it is made if need be.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

/// Draws what was asked for.
pub(crate) fn run(arguments: &ExportArguments) -> Result<(), Fault> {
    let library = arguments.lessons.read()?;
    let grounds = grounds(&library, arguments)?;
    // What is wrong elsewhere was said, and is drawn by nobody here.
    let drawn =
        |file: &str| file.starts_with("listings/") || grounds.iter().any(|(ground, _)| ground.slide.file == file);
    if let Some(problem) = library.problems.iter().find(|problem| drawn(&problem.file)) {
        return Err(Fault::new(format!("{problem} (raystep check lists all)")));
    }
    let sessions: Vec<Session<'_>> = grounds.iter().flat_map(|(ground, rays)| Session::of_rays(ground, rays)).collect();
    if sessions.is_empty() {
        return Err(Fault::new(nothing(&library, arguments)));
    }
    let which = match &arguments.steps {
        Some(range) => Which::Steps(range.clone()),
        None if arguments.ray.is_some() => Which::ReachedBeats,
        None => Which::Beats,
    };
    let theme = Theme::named(&arguments.theme).unwrap_or(&Theme::LIGHT);
    let order = Order { view: arguments.view, format: arguments.format, size: arguments.size, theme };
    let jobs = jobs(&sessions, &which, &order)?;
    let bar = bar(pictures(&jobs));
    let drawn = write(&jobs, &order, &arguments.out, &|| {
        bar.inc(1);
        true
    })?;
    bar.finish_and_clear();
    let count = drawn.len();
    files::say(&format!("{count} {} in {}", if count == 1 { "file" } else { "files" }, arguments.out.display()));
    Ok(())
}

/// Lessons that are read to be drawn are whole, and not none.
pub(super) fn readable(library: &Library, lessons: Option<&Path>) -> Result<(), Fault> {
    if let Some(problem) = library.problems.first() {
        return Err(Fault::new(format!("{problem} (raystep check lists all)")));
    }
    match lessons {
        Some(folder) if library.slides.is_empty() => {
            Err(Fault::new(format!("{}: there is no slide in it, no SECTION/SLIDE.md", folder.display())))
        }
        _ => Ok(()),
    }
}

/// A stage, built, with the rays that walk on it.
type Stood<'a> = (Ground<'a>, Vec<&'a NamedRay>);

/// The stages to draw.
fn grounds<'a>(library: &'a Library, arguments: &ExportArguments) -> Result<Vec<Stood<'a>>, Fault> {
    let mut grounds = Vec::new();
    for slide in chosen(library, arguments)? {
        for stage in StageKind::ALL.into_iter().filter_map(|kind| slide.stage(kind)) {
            let rays = rays(slide, stage, arguments);
            let left_out = arguments.stage.as_deref().is_some_and(|name| name != stage.kind.name());
            // A build has no ray to be named.
            let nothing = if !slide.plays.has_rays() { arguments.ray.is_some() } else { rays.is_empty() };
            if !left_out && !nothing {
                grounds.push((Ground::of_stage(library, slide, stage)?, rays));
            }
        }
    }
    Ok(grounds)
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
    rays_of_beats(slide, stage)
}

/// Why nothing was chosen.
fn nothing(library: &Library, arguments: &ExportArguments) -> String {
    let slides = chosen(library, arguments).unwrap_or_default();
    let stages = |slide: &Slide| slide.stages.iter().map(|stage| stage.kind.name()).collect::<Vec<_>>().join(" and ");
    match (slides.as_slice(), &arguments.ray, &arguments.stage) {
        ([slide], Some(_), _) if !slide.plays.has_rays() => {
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
