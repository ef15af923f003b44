//! `raystep export`: steps as pictures, without display or graphics card.

mod at;
mod chosen;
mod own;

use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};

use clap::Args;
use raystep_accel::Grain;
use raystep_figure::Theme;
use raystep_lesson::Library;
use raystep_print::Lettering;

use super::lessons::Lessons;
use super::progress::bar;
use crate::export::{
    Format, Order, Piece, STEP_MILLIS, Session, Size, View, Which, delay, jobs, pictures, span, write,
};
use crate::fault::Fault;
use crate::files;
use crate::shown::Link;

/// What to draw, how, and where to.
#[derive(Args, Debug)]
pub struct ExportArguments {
    /// The slide: section and number, as in 5/33, or the number alone.
    #[arg(long, value_name = "SLIDE", conflicts_with = "all", required_unless_present_any = ["all", "scene", "mesh", "at"])]
    slide: Option<String>,
    /// All slides.
    #[arg(long)]
    all: bool,
    /// A place as Ctrl+L copies it, as in "5/33?step=13": its slide, stage and ray, what was set there, and its step.
    #[arg(long, value_name = "LINK", value_parser = str::parse::<Link>, conflicts_with_all = ["slide", "all", "ray",
          "stage", "scene", "mesh", "structure", "rule", "pixel", "build", "camera"])]
    at: Option<Link>,
    /// The ray: a name of the slide's, or OX,OY,OZ,DX,DY,DZ[,T_MIN,T_MAX] as trace takes it; without it, the ray that
    /// each beat wants.
    #[arg(long, value_name = "NAME|NUMBERS", allow_hyphen_values = true)]
    ray: Option<String>,
    #[command(flatten)]
    own: own::Own,
    /// Only this stage; without it, every stage that the slide offers.
    #[arg(long, value_parser = ["flat", "solid"])]
    stage: Option<String>,
    /// These steps, as in 3..9; both ends are drawn.
    #[arg(long, value_name = "A..B", value_parser = span, conflicts_with = "beats")]
    steps: Option<RangeInclusive<usize>>,
    /// The step of every beat; this is what is drawn if no steps are named. Films hold all steps.
    #[arg(long)]
    beats: bool,
    /// Leave out the steps that are finer; films stop at decisions if nothing is said.
    #[arg(long, value_parser = ["arithmetic", "decision", "visit"])]
    grain: Option<String>,
    /// What to draw.
    #[arg(long, default_value = "plate")]
    view: View,
    /// A plate of these panes, as in title,space,tree,t: the views, and title, text and legend.
    #[arg(long, value_name = "A,B,C", value_delimiter = ',', conflicts_with = "view")]
    panes: Vec<Piece>,
    /// Whether the signs of space are explained; without it, on plates.
    #[arg(long, value_parser = ["on", "off"])]
    legend: Option<String>,
    /// The kind of file; apng, gif, mp4 and webm hold all steps of a walk in one.
    #[arg(long, default_value = "png")]
    format: Format,
    /// Letters of an SVG file: as outlines, as text in faces that the file brings along, or as text in faces that it
    /// only names.
    #[arg(long, default_value = "outlines", value_parser = ["outlines", "real", "named"])]
    text: String,
    /// Width and height in pixels.
    #[arg(long, value_name = "WxH", default_value = "1600x1000")]
    size: Size,
    /// Cut off the margins on which nothing is drawn: the file is then no larger than --size.
    #[arg(long)]
    crop: bool,
    /// Tell times of this machine, too; without it files are the same everywhere.
    #[arg(long)]
    times: bool,
    /// Leave the ground out.
    #[arg(long)]
    transparent: bool,
    /// How many milliseconds a film shows a step; twice as long a beat, three times as long the last one.
    #[arg(long, value_name = "MS", default_value_t = STEP_MILLIS, allow_negative_numbers = true, value_parser = delay)]
    delay: u16,
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
    let order = order(arguments)?;
    let library = arguments.lessons.read()?;
    if arguments.own.is_asked() {
        let (ground, ray) = own::ground(&library, arguments)?;
        return draw(&own::sessions(&ground, ray), &order, None, arguments);
    }
    let (grounds, step) = match &arguments.at {
        Some(link) => {
            let (stood, step) = at::stood(&library, link, arguments)?;
            (vec![stood], step)
        }
        None => (chosen::grounds(&library, arguments)?, None),
    };
    // What is wrong elsewhere was said, and is drawn by nobody here.
    let drawn =
        |file: &str| file.starts_with("listings/") || grounds.iter().any(|stood| stood.ground.slide.file == file);
    if let Some(problem) = library.problems.iter().find(|problem| drawn(&problem.file)) {
        return Err(Fault::new(format!("{problem} (raystep check lists all)")));
    }
    let sessions: Vec<Session<'_>> = grounds.iter().flat_map(chosen::Stood::sessions).collect();
    if sessions.is_empty() {
        return Err(Fault::new(chosen::nothing(&library, arguments)));
    }
    draw(&sessions, &order, step, arguments)
}

/// Draws what was chosen, and says how much that was. Of a place with a step that alone is drawn, unless a film is.
fn draw(
    sessions: &[Session<'_>],
    order: &Order,
    step: Option<usize>,
    arguments: &ExportArguments,
) -> Result<(), Fault> {
    let step = step.filter(|_| !arguments.beats && !order.format.is_film());
    let which = match arguments.steps.clone().or(step.map(|step| step..=step)) {
        Some(range) => Which::Steps(range),
        None if arguments.ray.is_some() || arguments.at.is_some() => Which::ReachedBeats,
        None => Which::Beats,
    };
    let jobs = jobs(sessions, &which, order)?;
    let bar = bar(pictures(&jobs, order) as u64, "pictures");
    let drawn = write(&jobs, order, &arguments.out, &|| {
        bar.inc(1);
        true
    })?;
    bar.finish_and_clear();
    // Steps that a walk does not have are none of its pictures: who counts the files knows why.
    if let Some((range, last)) = arguments.steps.as_ref().zip(sessions.iter().map(Session::steps).max())
        && *range.end() > last
    {
        files::say(&format!("--steps {}..{}: the last step there is is {last}", range.start(), range.end()));
    }
    let count = drawn.len();
    files::say(&format!("{count} {} in {}", if count == 1 { "file" } else { "files" }, arguments.out.display()));
    Ok(())
}

/// How it is to be drawn.
fn order(arguments: &ExportArguments) -> Result<Order, Fault> {
    let ExportArguments { view, format, size, .. } = *arguments;
    let lettering = match arguments.text.as_str() {
        "real" => Lettering::Embedded,
        "named" => Lettering::Named,
        _ => Lettering::Outlines,
    };
    if lettering != Lettering::Outlines && format != Format::Svg {
        let why = match format {
            Format::Pdf => "a PDF file has text anyhow: leave --text out",
            _ => "only an SVG file has letters as text: write --format svg, or leave --text out",
        };
        return Err(Fault::new(format!("--text {}: {why}", arguments.text)));
    }
    Ok(Order {
        pieces: arguments.panes.clone(),
        lettering,
        crop: arguments.crop,
        clear: arguments.transparent,
        legend: arguments.legend.as_deref().map(|legend| legend == "on"),
        grain: arguments.grain.as_deref().map(|grain| match grain {
            "arithmetic" => Grain::Arithmetic,
            "visit" => Grain::Visit,
            _ => Grain::Decision,
        }),
        delay: arguments.delay,
        ..Order::new(view, format, size, Theme::named(&arguments.theme).unwrap_or(&Theme::LIGHT))
    })
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
