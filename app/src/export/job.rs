//! Which files there are to write, and the writing.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::ops::RangeInclusive;
use std::path::Path;

use glam::Vec2;
use rayon::prelude::*;
use raystep_accel::Grain;
use raystep_figure::{Figure, Pane, whole};
use raystep_print::{around, drawing, part, pdf, png};

use super::drawing::inked;
use super::ground::cancelled;
use super::{Format, Order, Session, View, film, video};
use crate::fault::Fault;
use crate::files;

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

/// One file.
pub(crate) struct Job<'a> {
    session: &'a Session<'a>,
    file: String,
    /// Steps with the beat that wanted them.
    steps: Vec<(usize, Option<usize>)>,
}

/// A film shows at most so many pictures: nobody looks at more.
const LONGEST: usize = 5000;

/// The files to write, in the order of their names.
pub(crate) fn jobs<'a>(sessions: &'a [Session<'a>], which: &Which, order: &Order) -> Result<Vec<Job<'a>>, Fault> {
    order.has_room()?;
    let mut jobs: BTreeMap<String, Job<'_>> = BTreeMap::new();
    let shown: Vec<&Session<'_>> = sessions.iter().filter(|session| session.missing(order).is_none()).collect();
    // One of many slides may lack what the others have.
    if let (true, Some(session)) = (shown.is_empty(), sessions.first()) {
        return Err(Fault::new(session.missing(order).unwrap_or_default()));
    }
    for session in shown {
        let (stem, marks, ending) = (session.file_stem(), order.marks(), order.format.ending());
        let last = session.steps();
        let steps = steps(session, which, order)?;
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
        if order.format == Format::Json {
            add(format!("{stem}.{ending}"), Vec::new())?;
        } else if order.view == View::Heat && !session.reel().has(Pane::Heat) {
            // What all rays cost is the same at every step of one of them.
            add(format!("{stem}{marks}.{ending}"), vec![(last, None)])?;
        } else if order.format.is_film() {
            if steps.len() > LONGEST {
                let count = whole(steps.len() as u64);
                return Err(Fault::new(format!(
                    "{stem}: a film of {count} pictures is too long, since at most {LONGEST} are shown: write a coarser \
                     --grain, or fewer --steps"
                )));
            }
            let part = match which {
                Which::Steps(range) => format!("-step{:04}to{:04}", range.start(), last.min(*range.end())),
                _ => String::new(),
            };
            if !steps.is_empty() {
                add(format!("{stem}{marks}{part}.{ending}"), steps)?;
            }
        } else {
            for (step, beat) in steps {
                let beat_name = beat.map_or_else(String::new, |beat| format!("-beat{:02}", beat + 1));
                let file = format!("{stem}{marks}{beat_name}-step{step:04}of{last:04}.{ending}");
                add(file, vec![(step, beat)])?;
            }
        }
    }
    if jobs.is_empty() {
        return Err(Fault::new("there is nothing to draw: none of the chosen rays reaches a beat"));
    }
    Ok(jobs.into_values().collect())
}

/// The steps of one walk, with the beats that want them.
fn steps(session: &Session<'_>, which: &Which, order: &Order) -> Result<Vec<(usize, Option<usize>)>, Fault> {
    let last = session.steps();
    let beats = |told: &dyn Fn(usize) -> bool| -> Vec<(usize, Option<usize>)> {
        session
            .beats()
            .filter(|beat| told(*beat))
            .filter_map(|beat| Some((session.step_of(beat)?, Some(beat))))
            .collect()
    };
    let told = beats(&|beat| session.is_told_here(beat));
    // A film plays all that happens, beat or not.
    let usual = order.format.is_film().then_some(Grain::Decision);
    let stops = |range: RangeInclusive<usize>, grain: Option<Grain>| {
        let beat = |step: usize| told.iter().find(|(at, _)| *at == step).and_then(|(_, beat)| *beat);
        let is_stop = |step: &usize| grain.is_none_or(|grain| session.stops().stops(*step, grain));
        range.filter(is_stop).map(|step| (step, if order.format.is_film() { beat(step) } else { None })).collect()
    };
    match which {
        Which::Beats | Which::ReachedBeats if order.format.is_film() => {
            // Nothing is told of some rays that are drawn for others.
            let silent = told.is_empty() && matches!(which, Which::Beats) && !session.beats().is_empty();
            Ok(if silent { Vec::new() } else { stops(0..=last, order.grain.or(usual)) })
        }
        Which::Beats if session.beats().is_empty() => Ok(vec![(last, None)]),
        Which::Beats => Ok(told),
        Which::ReachedBeats => {
            let reached = beats(&|_| true);
            Ok(if reached.is_empty() { vec![(last, None)] } else { reached })
        }
        Which::Steps(range) if *range.start() > last => {
            let (stem, first) = (session.file_stem(), range.start());
            Err(Fault::new(format!("{stem}: the last step is {last}, before {first}")))
        }
        // Whoever names steps gets all of them, unless a grain is named, too.
        Which::Steps(range) => Ok(stops(*range.start()..=last.min(*range.end()), order.grain)),
    }
}

/// How many pictures there are to draw in all.
pub(crate) fn pictures(jobs: &[Job<'_>], order: &Order) -> usize {
    jobs.iter().map(|job| job.steps.len().max(1) * film::rounds(order.format)).sum()
}

/// Writes the files into a folder, which is made if need be, and says their names. `go_on` is asked before
/// each picture.
pub(crate) fn write(
    jobs: &[Job<'_>],
    order: &Order,
    folder: &Path,
    go_on: &(dyn Fn() -> bool + Sync),
) -> Result<Vec<String>, Fault> {
    video::ready(order)?;
    files::folder(folder)?;
    jobs.par_iter().try_for_each(|job| job.write(order, &folder.join(&job.file), go_on))?;
    Ok(jobs.iter().map(|job| job.file.clone()).collect())
}

impl Job<'_> {
    fn write(&self, order: &Order, path: &Path, go_on: &(dyn Fn() -> bool + Sync)) -> Result<(), Fault> {
        let wrong = |error: &dyn std::fmt::Display| Fault::new(format!("{}: {error}", path.display()));
        if order.format == Format::Json {
            return if go_on() { files::write(path, self.session.json().as_bytes()) } else { Err(cancelled()) };
        }
        // All pictures of a film are cut alike.
        let cut = if order.crop { self.inked(order, go_on)? } else { None };
        let draw = |index: usize| {
            let (figure, scale) = self.figure(order, index)?;
            let figure = match cut {
                Some(cut) => part(figure, cut.map(|corner| corner / scale)),
                None => figure,
            };
            Ok((figure, scale))
        };
        if order.format.is_film() {
            let drawing_at = |index: usize| {
                let (figure, scale) = draw(index)?;
                Ok((drawing(&figure, &order.manner(1.0)), scale))
            };
            let film = film::Film { steps: &self.steps, draw: &drawing_at, go_on };
            return match order.format {
                Format::Mp4 | Format::Webm => files::fill(path, |part| video::write(&film, order, part)),
                _ => files::write(path, &film::bytes(&film, order)?),
            };
        }
        if !go_on() {
            return Err(cancelled());
        }
        let (figure, scale) = draw(0)?;
        let bytes = match order.format {
            Format::Png => png(&drawing(&figure, &order.manner(1.0)), scale).map_err(|error| wrong(&error))?,
            Format::Pdf => pdf(&figure, self.session.title(), &order.manner(scale)).map_err(|error| wrong(&error))?,
            _ => drawing(&figure, &order.manner(scale)).into_bytes(),
        };
        files::write(path, &bytes)
    }

    /// The picture of a step; an error where nothing is on it.
    fn figure(&self, order: &Order, index: usize) -> Result<(Figure, f32), Fault> {
        let (step, beat) = self.steps[index];
        let (figure, scale) = self.session.figure_of(order, step, beat, order.size.into())?;
        if figure.marks.is_empty() && self.steps.len() == 1 {
            let (stem, view) = (self.session.file_stem(), order.view.name());
            return Err(Fault::new(format!("{stem}: the view {view} shows nothing at step {step}")));
        }
        Ok((figure, scale))
    }

    /// The part of the page on which any of its pictures draws, in whole pixels.
    fn inked(&self, order: &Order, go_on: &(dyn Fn() -> bool + Sync)) -> Result<Option<[Vec2; 2]>, Fault> {
        let mut all = None;
        for index in 0..self.steps.len() {
            if !go_on() {
                return Err(cancelled());
            }
            let (figure, scale) = self.figure(order, index)?;
            let pixels = inked(&figure).map(|[min, max]| [(min * scale).floor(), (max * scale).ceil()]);
            all = [all, pixels].into_iter().flatten().reduce(around);
        }
        Ok(all)
    }
}
