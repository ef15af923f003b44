//! `raystep race`: the ladder of slide 64 on this machine.

mod gpu;
mod plate;
mod told;

use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::Args;
use glam::Vec2;
use raystep_accel::{Mesh, Prims, Ray, RayError};
use raystep_fast::{Race, Row, Rung, tile_order};
use raystep_figure::{counted, whole};

use super::measure::look::{Look, Shot};
use super::progress::bar;
use super::subject;
use super::told::Format;
use crate::fault::Fault;
use crate::files;

/// What is raced over, and how it is told.
#[derive(Args, Debug)]
pub struct RaceArguments {
    /// A shipped scene.
    #[arg(long, value_name = "NAME", default_value = "teapot-6321")]
    scene: String,
    /// A mesh of your own instead.
    #[arg(long, value_name = "FILE.obj", conflicts_with = "scene")]
    mesh: Option<PathBuf>,
    /// Seconds that each rung is timed.
    #[arg(long, value_name = "S", default_value_t = 0.5, allow_negative_numbers = true, value_parser = seconds)]
    seconds: f64,
    /// How what was found is written.
    #[arg(long, value_name = "FORMAT", default_value = "text")]
    format: Format,
    /// A plate with bars as well.
    #[arg(long, value_name = "FILE.svg|FILE.png")]
    out: Option<PathBuf>,
}

/// Two to this many rays go across the picture, and as many down.
const POWER: u32 = 9;

fn seconds(text: &str) -> Result<f64, String> {
    let known = text.parse::<f64>().ok().filter(|seconds| (0.01..=60.0).contains(seconds));
    known.ok_or_else(|| "write seconds from 0.01 to 60, as in 0.5".to_owned())
}

/// Races and tells.
pub(crate) fn run(arguments: &RaceArguments) -> Result<(), Fault> {
    if let Some(out) = &arguments.out {
        plate::kind(out)?;
        let read: Vec<&Path> = arguments.mesh.iter().map(PathBuf::as_path).collect();
        files::may_write(out, &read)?;
    }
    let scene = match &arguments.mesh {
        Some(path) => subject::mesh(path)?,
        None => subject::named(&arguments.scene)?,
    };
    let shot = Shot::of(&scene, Look::Close, "512x512".parse().map_err(Fault::new)?, false);
    let side = (1 << POWER) as f32;
    let ray = |[x, y]: [u32; 2]| shot.camera.ray(Vec2::new(x as f32 + 0.5, y as f32 + 0.5), Vec2::splat(side));
    let mesh: &Mesh = match &scene.prims {
        Prims::Mesh(mesh) if !scene.flat && !mesh.triangles.is_empty() => mesh,
        _ => {
            return Err(Fault::new(format!(
                "{} is no solid mesh: fast structures stand over triangles alone; name teapot-6321, stadium, teapot:NxN \
                 or a mesh",
                scene.name
            )));
        }
    };
    let wrong = |error: RayError| Fault::new(format!("the camera shoots no rays: {error}"));
    let rays: Vec<Ray> = tile_order(POWER).map(ray).collect::<Result<_, _>>().map_err(wrong)?;
    let rows = race(mesh, &rays, arguments.seconds)?;
    let about = format!(
        "{}: {}; {} rays, one for each pixel of a picture of 512x512, in tiles",
        scene.name,
        counted(mesh.triangles.len() as u64, "triangle", "triangles"),
        whole(rays.len() as u64)
    );
    if let Some(out) = &arguments.out {
        files::write(out, &plate::plate(out, &about, &rows)?)?;
    }
    files::print(&match arguments.format {
        Format::Csv => told::csv(&rows)?,
        Format::Json => told::json(&rows)?,
        format => told::page(&about, &rows, rays.len()).written(format),
    })
}

fn race(mesh: &Mesh, rays: &[Ray], seconds: f64) -> Result<Vec<Row>, Fault> {
    let begun = Instant::now();
    let clock = || begun.elapsed().as_secs_f64();
    let stopped = || Fault::new("the race was given up");
    let bar = bar(Rung::ALL.len() as u64, "rungs");
    let race = Race::new(mesh, rays, seconds, &clock, &|| true).ok_or_else(stopped)?;
    let run = |rung: Rung| {
        let row = if rung == Rung::Gpu { gpu::run(&race, mesh, rays, &clock) } else { race.run(rung) };
        bar.inc(1);
        row
    };
    let rows: Option<Vec<Row>> = Rung::ALL.into_iter().map(run).collect();
    bar.finish_and_clear();
    rows.ok_or_else(stopped)
}
