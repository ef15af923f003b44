//! Times, which differ from machine to machine: rays a second, milliseconds of a build, seconds of a picture. The clock is
//! given: nothing here knows one.

use raystep_accel::{Accel, Cancelled, Grow, Mesh, Observer, Prims, Ray, Structure};
use raystep_fast::{Fast, Isa, Pace, Race, Runner, Settings, Told, TwoLevels, tile_order};
use raystep_scene::{Scene, Scenes};

use super::measure::through;
use super::table::{Lanes, Runs};
use super::{Board, Column, Entry, Numbers, Panel, Picture, Rendered, Row, Stroke, standing};
use crate::Plan;

/// What times are measured with.
pub trait Stopwatch: Sync {
    /// Seconds since any moment.
    fn seconds(&self) -> f64;
    /// Whether somebody still waits for the times.
    fn goes_on(&self) -> bool;
    /// The same rays on a graphics card, or a sentence that says why not; nothing if it shall not go on.
    fn graphics_card(&self, race: &Race<'_>, mesh: &Mesh, rays: &[Ray]) -> Option<Result<Told, String>>;
}

/// What was timed of something on a board; what it has not is no number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Timed {
    /// Millions of rays a second: the median of several rounds.
    pub speed: f64,
    /// The slowest and the quickest of them.
    pub spread: [f64; 2],
    /// Milliseconds of the building.
    pub build: f64,
    /// Of the time of a picture, the part in which rays are intersected.
    pub share: f64,
    /// Seconds that a picture took.
    pub seconds: f64,
}

/// What was timed, or a sentence that says why nothing was.
pub type Timing = Result<Timed, String>;

/// Two to this many rays go across the picture whose rays are timed, and as many down: as for `raystep race`.
const POWER: u32 = 9;
/// The same where a whole line of structures is timed.
const POWER_OF_LINE: u32 = 7;
/// Seconds for a row, and for a dot of a line.
const SECONDS: f64 = 0.4;
const SECONDS_OF_DOT: f64 = 0.15;
/// Rays of the picture whose seconds are told.
const PICTURE: f64 = 1e6;

impl Timed {
    /// Nothing yet.
    pub(super) const NOTHING: Timed =
        Timed { speed: f64::NAN, spread: [f64::NAN; 2], build: f64::NAN, share: f64::NAN, seconds: f64::NAN };

    fn of(told: &Told) -> Timed {
        let (speed, spread, build) = (told.mrays_per_s, told.spread, told.build_ms);
        Timed { speed, spread, build, seconds: PICTURE * 1e-6 / speed, ..Timed::NOTHING }
    }

    /// Microseconds of a ray.
    pub fn time(&self) -> f64 {
        1.0 / self.speed
    }
}

/// What a board has to say of a place of one of its panels, if times are told there.
pub(super) fn is_timed(board: &Board, (panel, place): (usize, usize)) -> bool {
    match board.panels.get(panel) {
        Some(Panel::Table(table)) => {
            let tells = table.columns.iter().any(|(column, _)| column.is_timed());
            tells && table.rows.get(place).is_some_and(|row| row.plan.is_some() || row.fast.is_some())
        }
        Some(Panel::Chart(chart)) => chart
            .drawn
            .get(place)
            .is_some_and(|drawn| matches!(drawn.stroke, Stroke::Growth { of: Column::Picture, .. })),
        Some(Panel::Pictures(pictures)) => pictures.times,
        Some(Panel::Meter(_) | Panel::Maps(_)) | None => false,
    }
}

/// Times what stands at a place of a board; of a line also its dots.
///
/// # Errors
/// Nobody waits any more.
pub(super) fn time(
    board: &Board,
    place: (usize, usize),
    numbers: &Numbers,
    scene: &Scene,
    stopwatch: &dyn Stopwatch,
) -> Result<(Timing, Vec<[f64; 2]>), Cancelled> {
    let unknown = |error: &dyn std::fmt::Display| Ok((Err(error.to_string()), Vec::new()));
    match board.entry(place) {
        Some(Entry::Row(row)) => {
            let shares = matches!(&board.panels[place.0], Panel::Table(table) if table.columns.iter().any(|(column, _)| *column == Column::Share));
            let own = match row.scene.as_deref().map(|name| board.scenes.named(name)) {
                Some(Ok(own)) => Some(own),
                Some(Err(error)) => return unknown(&error),
                None => None,
            };
            let timing = of_row(row, numbers, shares, own.as_deref().unwrap_or(scene), stopwatch)?;
            Ok((timing, Vec::new()))
        }
        Some(Entry::Drawn(drawn)) => match &drawn.stroke {
            Stroke::Growth { plan, fast, scenes, .. } => {
                let dots = line(plan.as_ref(), *fast, scenes, &board.scenes, stopwatch)?;
                Ok((Ok(Timed::NOTHING), dots))
            }
            Stroke::Point(..) | Stroke::Law { .. } => Ok((Ok(Timed::NOTHING), Vec::new())),
        },
        Some(Entry::Picture(picture)) => Ok((of_picture(picture, scene, &board.scenes, stopwatch)?, Vec::new())),
        Some(Entry::Map(..)) | None => Ok((Ok(Timed::NOTHING), Vec::new())),
    }
}

fn of_row(
    row: &Row,
    numbers: &Numbers,
    shares: bool,
    scene: &Scene,
    stopwatch: &dyn Stopwatch,
) -> Result<Timing, Cancelled> {
    let plan = row.plan.as_ref().map(|plan| plan.at(numbers));
    if shares {
        let share = match &plan {
            Some(plan) => Rendered::share(plan, scene, stopwatch)?,
            None => None,
        };
        let told = share.map(|share| Timed { share, ..Timed::NOTHING });
        return Ok(told.ok_or_else(|| "nothing is drawn".to_owned()));
    }
    let clock = || stopwatch.seconds();
    let goes_on = || stopwatch.goes_on();
    let rays = rays(scene, POWER);
    let Prims::Mesh(mesh) = &scene.prims else {
        let speed = speed_of(plan.as_ref(), row.fast.is_some(), scene, &rays, SECONDS, stopwatch)?;
        return Ok(speed.map(|(_, timed)| timed).ok_or_else(|| "it is no mesh".to_owned()));
    };
    let race = Race::new(mesh, &rays, SECONDS, &clock, &goes_on).ok_or(Cancelled)?;
    if row.how.runs == Runs::GraphicsCard {
        let told = stopwatch.graphics_card(&race, mesh, &rays).ok_or(Cancelled)?;
        return Ok(told.map(|told| Timed::of(&told)));
    }
    let rule = plan.as_ref().and_then(|plan| plan.rule(false).ok());
    let runner = match (&rule, row.fast) {
        (Some(rule), _) => Runner::Textbook(rule),
        (None, Some(kind)) if row.how.runs == Runs::Threads => Runner::Together(kind),
        (None, Some(kind)) => match instructions(row.how.isa) {
            Some(isa) => Runner::Alone(kind, isa),
            None => return Ok(Err("this machine lacks it".to_owned())),
        },
        (None, None) => return Ok(Err("nothing is built".to_owned())),
    };
    let told = race.time(runner).ok_or(Cancelled)?;
    Ok(told.map(|told| Timed::of(&told)))
}

/// The instructions that a row asks for, if this machine has them; the best, if it does not ask.
fn instructions(asked: Option<Lanes>) -> Option<Isa> {
    match asked {
        None => Some(Isa::best()),
        Some(Lanes::Portable) => Isa::all().last().copied(),
        Some(Lanes::Named(name)) => Isa::all().into_iter().find(|isa| isa.name() == name),
    }
}

/// The rays of a picture as high as wide, close to the scene, in tiles.
fn rays(scene: &Scene, power: u32) -> Vec<Ray> {
    let (view, side) = (scene.close_view(), 1 << power);
    tile_order(power).filter_map(|at| through(&view, [side, side], at).ok()).collect()
}

/// How fast rays walk through what a plan says, or through two fast levels, whatever the scene is made of; and how many
/// Whether a ray hits something.
type Asks<'a> = Box<dyn Fn(&Ray) -> bool + 'a>;

/// primitives there are.
fn speed_of(
    plan: Option<&Plan>,
    fast: bool,
    scene: &Scene,
    rays: &[Ray],
    seconds: f64,
    stopwatch: &dyn Stopwatch,
) -> Result<Option<(f64, Timed)>, Cancelled> {
    let clock = || stopwatch.seconds();
    let goes_on = || stopwatch.goes_on();
    let pace = Pace { clock: &clock, go_on: &goes_on, seconds };
    let begun = clock();
    let mut hits = 0_u64;
    let (number, ask): (f64, Asks<'_>) = match (&scene.prims, plan, fast) {
        (Prims::Instances(instances), _, true) => {
            let built = TwoLevels::build(instances, &Settings::default());
            (instances.triangles() as f64, Box::new(move |ray| built.intersect(ray).is_some()))
        }
        (Prims::Mesh(mesh), _, true) => {
            let built = raystep_fast::FastKind::Bvh8.build(mesh, &Settings::default());
            (mesh.triangles.len() as f64, Box::new(move |ray| built.intersect(ray).is_some()))
        }
        (prims, Some(plan), _) => {
            let Some(built) = standing::structure(plan, scene, &mut While(stopwatch))? else { return Ok(None) };
            let number = match prims {
                Prims::Instances(instances) => instances.triangles() as f64,
                Prims::Mesh(mesh) => mesh.triangles.len() as f64,
                _ => return Ok(None),
            };
            (number, Box::new(move |ray| Structure::intersect(&built, prims, ray, &mut ()).is_some()))
        }
        _ => return Ok(None),
    };
    let build = (clock() - begun) * 1e3;
    let mut shoot = |some: &[Ray]| hits += some.iter().filter(|ray| ask(ray)).count() as u64;
    let some = pace.some(rays, &mut shoot).ok_or(Cancelled)?;
    let ([median, least, most], _) = pace.rounds(some.len(), || shoot(&some)).ok_or(Cancelled)?;
    std::hint::black_box(hits);
    let (speed, spread) = (median * 1e-6, [least * 1e-6, most * 1e-6]);
    Ok(Some((number, Timed { speed, spread, build, seconds: PICTURE * 1e-6 / speed, ..Timed::NOTHING })))
}

/// Seconds of a picture of a million rays, over scenes of more and more primitives.
fn line(
    plan: Option<&Plan>,
    fast: bool,
    names: &[String],
    scenes: &Scenes,
    stopwatch: &dyn Stopwatch,
) -> Result<Vec<[f64; 2]>, Cancelled> {
    let mut dots = Vec::new();
    for scene in names.iter().filter_map(|name| scenes.named(name).ok()) {
        let rays = rays(&scene, POWER_OF_LINE);
        if let Some((number, timed)) = speed_of(plan, fast, &scene, &rays, SECONDS_OF_DOT, stopwatch)? {
            dots.push([number, timed.seconds]);
        }
    }
    Ok(dots)
}

fn of_picture(
    picture: &Picture,
    scene: &Scene,
    scenes: &Scenes,
    stopwatch: &dyn Stopwatch,
) -> Result<Timing, Cancelled> {
    let own = match picture.scene.as_deref().map(|name| scenes.named(name)) {
        Some(Ok(own)) => Some(own),
        Some(Err(error)) => return Ok(Err(error.to_string())),
        None => None,
    };
    let begun = stopwatch.seconds();
    let made = Rendered::anew(picture, own.as_deref().unwrap_or(scene), &mut While(stopwatch))?;
    let seconds = stopwatch.seconds() - begun;
    Ok(made.map(|_| Timed { seconds, ..Timed::NOTHING }).ok_or_else(|| "nothing is drawn".to_owned()))
}

/// Lets a builder give up.
pub(super) struct While<'a>(pub(super) &'a dyn Stopwatch);

impl Observer<Grow> for While<'_> {
    fn on(&mut self, _: Grow) {}

    fn cancelled(&self) -> bool {
        !self.0.goes_on()
    }
}
