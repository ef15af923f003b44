//! Which files there are to write, and the writing.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::ops::RangeInclusive;
use std::path::Path;

use clap::ValueEnum;
use rayon::prelude::*;
use raystep_figure::Theme;
use raystep_print::{PrintError, apng, gif, png, svg};

use super::{Session, Size, View};
use crate::fault::Fault;
use crate::files;

/// How steps are drawn.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Order {
    /// What a picture shows.
    pub(crate) view: View,
    /// The kind of file.
    pub(crate) format: Format,
    /// Its width and height.
    pub(crate) size: Size,
    /// Its colours.
    pub(crate) theme: &'static Theme,
}

/// A kind of file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
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

impl Format {
    /// How its files' names end.
    pub(crate) fn ending(self) -> &'static str {
        match self {
            Format::Png => "png",
            Format::Svg => "svg",
            Format::Apng => "apng",
            Format::Gif => "gif",
            Format::Json => "json",
        }
    }
}

/// The steps to draw.
#[derive(Clone, Debug)]
pub(crate) enum Which {
    /// Those of the beats that are told on each ray.
    Beats,
    /// Those of all beats that a ray reaches, even of those told on another.
    ReachedBeats,
    /// These; both ends are drawn.
    Steps(RangeInclusive<usize>),
}

/// How long a moving picture shows a step.
const STEP_MILLIS: u16 = 900;

/// One file.
pub(crate) struct Job<'a> {
    session: &'a Session<'a>,
    file: String,
    /// Steps with the beat that wanted them.
    steps: Vec<(usize, Option<usize>)>,
}

/// The files to write, in the order of their names.
pub(crate) fn jobs<'a>(sessions: &'a [Session<'a>], which: &Which, order: &Order) -> Result<Vec<Job<'a>>, Fault> {
    let mut jobs: BTreeMap<String, Job<'_>> = BTreeMap::new();
    for session in sessions {
        let stem = session.file_stem();
        let view = if order.view == View::Plate { "" } else { view_name(order.view) };
        let last = session.steps();
        let steps = steps(session, which)?;
        let mut add = |file: String, steps| match jobs.entry(file) {
            Entry::Vacant(free) => {
                let file = free.key().clone();
                free.insert(Job { session, file, steps });
                Ok(())
            }
            Entry::Occupied(taken) => {
                Err(Fault::new(format!("two pictures would be {}: give their rays other names", taken.key())))
            }
        };
        let ending = order.format.ending();
        match order.format {
            Format::Json => {
                add(format!("{stem}.{ending}"), Vec::new())?;
            }
            Format::Apng | Format::Gif if !steps.is_empty() => {
                add(format!("{stem}{view}.{ending}"), steps)?;
            }
            Format::Apng | Format::Gif => {}
            Format::Png | Format::Svg => {
                for (step, beat) in steps {
                    let beat_name = beat.map_or_else(String::new, |beat| format!("-beat{:02}", beat + 1));
                    let file = format!("{stem}{view}{beat_name}-step{step:04}of{last:04}.{ending}");
                    add(file, vec![(step, beat)])?;
                }
            }
        }
    }
    if jobs.is_empty() {
        return Err(Fault::new("there is nothing to draw: none of the chosen rays reaches a beat"));
    }
    Ok(jobs.into_values().collect())
}

/// The steps of one walk, with the beats that want them.
fn steps(session: &Session<'_>, which: &Which) -> Result<Vec<(usize, Option<usize>)>, Fault> {
    let last = session.steps();
    let beats = |told: &dyn Fn(usize) -> bool| {
        session
            .beats()
            .filter(|beat| told(*beat))
            .filter_map(|beat| Some((session.step_of(beat)?, Some(beat))))
            .collect()
    };
    match which {
        Which::Beats => Ok(beats(&|beat| session.is_told_here(beat))),
        Which::ReachedBeats => Ok(beats(&|_| true)),
        Which::Steps(range) if *range.start() > last => {
            let (stem, first) = (session.file_stem(), range.start());
            Err(Fault::new(format!("{stem}: the last step is {last}, before {first}")))
        }
        Which::Steps(range) => Ok((*range.start()..=last.min(*range.end())).map(|step| (step, None)).collect()),
    }
}

fn view_name(view: View) -> &'static str {
    match view {
        View::Plate => "-plate",
        View::Space => "-space",
        View::Tree => "-tree",
    }
}

/// How many pictures there are to draw in all.
pub(crate) fn pictures(jobs: &[Job<'_>]) -> usize {
    jobs.iter().map(|job| job.steps.len().max(1)).sum()
}

/// Writes the files into a folder, which is made if need be, and says their names. `go_on` is asked before
/// each picture.
pub(crate) fn write(
    jobs: &[Job<'_>],
    order: &Order,
    folder: &Path,
    go_on: &(dyn Fn() -> bool + Sync),
) -> Result<Vec<String>, Fault> {
    files::folder(folder)?;
    jobs.par_iter().try_for_each(|job| {
        let path = folder.join(&job.file);
        files::write(&path, &job.bytes(order, &path, go_on)?)
    })?;
    Ok(jobs.iter().map(|job| job.file.clone()).collect())
}

impl Job<'_> {
    fn bytes(&self, order: &Order, path: &Path, go_on: &(dyn Fn() -> bool + Sync)) -> Result<Vec<u8>, Fault> {
        let wrong = |error: PrintError| Fault::new(format!("{}: {error}", path.display()));
        let stopped = || Fault::new("the export was cancelled");
        if order.format == Format::Json {
            return if go_on() { Ok(self.session.json().into_bytes()) } else { Err(stopped()) };
        }
        let mut scale = 1.0;
        let mut drawings = Vec::new();
        for (step, beat) in &self.steps {
            if !go_on() {
                return Err(stopped());
            }
            let size = order.size.into();
            let (figure, to_pixels) = self.session.figure(order.view, *step, *beat, size, order.theme)?;
            scale = to_pixels;
            drawings.push(svg(&figure, order.theme));
        }
        match (order.format, drawings.first()) {
            (Format::Apng, _) => apng(&drawings, scale, STEP_MILLIS).map_err(wrong),
            (Format::Gif, _) => gif(&drawings, scale, STEP_MILLIS).map_err(wrong),
            (Format::Png, Some(drawing)) => png(drawing, scale).map_err(wrong),
            (_, drawing) => Ok(drawing.cloned().unwrap_or_default().into_bytes()),
        }
    }
}
