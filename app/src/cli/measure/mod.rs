//! `raystep measure`: the lecture's tables, as printed and as measured here.

mod best;
mod fit;
mod growth;
pub(super) mod look;
mod rows;
mod survey;
pub(super) mod table;

use std::collections::{HashMap, HashSet};
use std::path::PathBuf;

use clap::Args;
use raystep_accel::{Prims, Structure};
use raystep_scene::Scene;
use raystep_scene::trial::rules::rule;

use super::progress::bar;
use super::spelt;
use super::told::{Format, to_csv, to_json};
use crate::export::Size;
use crate::fault::Fault;
use crate::files;
use look::{Look, Shot};
use rows::Row;
use survey::{Survey, survey, timed};

/// What to measure.
#[derive(Args, Debug)]
pub struct MeasureArguments {
    /// A shipped scene.
    #[arg(long, value_name = "NAME", default_value = "teapot-6321")]
    scene: String,
    /// With --best: a mesh of your own instead.
    #[arg(long, value_name = "FILE.obj", requires = "best", conflicts_with = "scene")]
    mesh: Option<PathBuf>,
    /// All structures over one scene or mesh, and what each is good at, instead of the tables.
    #[arg(long, conflicts_with_all = ["growth", "also", "shadows"])]
    best: bool,
    /// With --best: how long building and a ray take on this machine, now.
    #[arg(long, requires = "best")]
    times: bool,
    /// `close` (the object fills the picture), `scene` (the scene's own view), or EX,EY,EZ,TX,TY,TZ[,DEGREES]:
    /// the eye, what it looks at, and the vertical angle of view.
    #[arg(long, value_name = "CAMERA", default_value = "close", allow_hyphen_values = true)]
    camera: Look,
    /// The size of the picture: a ray for each pixel.
    #[arg(long, value_name = "WxH", default_value = "320x240")]
    size: Size,
    /// Shoot a shadow ray from each hit, too.
    #[arg(long)]
    shadows: bool,
    /// A structure of your own, beside the lecture's; may be repeated.
    #[arg(long, value_name = "\"KIND KEY=VALUE ...\"", conflicts_with = "growth")]
    also: Vec<String>,
    /// How steps and tests grow with the number of triangles, instead of the tables.
    #[arg(long, conflicts_with_all = ["scene", "camera", "shadows"])]
    growth: bool,
    /// With --growth: cut the teapot's patches into N×N at most.
    #[arg(long, value_name = "N", default_value_t = 100, requires = "growth",
          allow_negative_numbers = true, value_parser = spelt::whole(1_u32..=100))]
    finest: u32,
    /// How to write it.
    #[arg(long, value_enum, default_value = "text")]
    format: Format,
}

/// A row with what was measured.
struct Measured {
    row: Row,
    survey: Survey,
    build_ms: f64,
    bytes: usize,
}

/// Measures and prints.
pub(crate) fn run(arguments: &MeasureArguments) -> Result<(), Fault> {
    if arguments.best {
        return files::print(&best::run(arguments)?);
    }
    if arguments.growth {
        let growth = growth::measure(arguments.finest, arguments.size)?;
        return files::print(&match arguments.format {
            Format::Json => to_json(&growth)?,
            Format::Csv => to_csv(growth.iter())?,
            format => growth::page(&growth).written(format),
        });
    }
    let scene = Scene::named(&arguments.scene).map_err(|error| Fault::new(error.to_string()))?;
    let shot = Shot::of(&scene, arguments.camera, arguments.size, arguments.shadows);
    let mut rows = rows::rows();
    for line in &arguments.also {
        spelt::rule(line).map_err(|fault| Fault::new(format!("--also \"{line}\": {fault}")))?;
        rows.push(Row { table: "also", name: line.clone(), line: line.clone(), printed: None });
    }
    let measured = measure(&scene, &shot, rows)?;
    files::print(&match arguments.format {
        Format::Json => table::json(&measured)?,
        Format::Csv => table::csv(&measured)?,
        format => table::page(&scene, &shot, &measured).written(format),
    })
}

/// Measures each structure once, though several tables show it.
fn measure(scene: &Scene, shot: &Shot, rows: Vec<Row>) -> Result<Vec<Measured>, Fault> {
    let rays = survey::rays(&shot.camera, shot.size.into())?;
    let bounds = scene.bounds();
    let lines: HashSet<&str> = rows.iter().map(|row| &*row.line).collect();
    let bar = bar(lines.len() as u64 * rays.len() as u64, "rays");
    let mut known: HashMap<String, (Survey, f64, usize)> = HashMap::new();
    let mut measured = Vec::new();
    for mut row in rows {
        if scene.name != "teapot-6321" {
            row.printed = None;
        }
        if !known.contains_key(&row.line) {
            let (structure, build_ms) = timed(|| build(&scene.prims, &row.line, scene.flat));
            let structure = structure?;
            let survey = survey(&structure, &scene.prims, &bounds, &rays, shot.light, &bar);
            known.insert(row.line.clone(), (survey, build_ms, structure.bytes()));
        }
        let (survey, build_ms, bytes) = known[&row.line];
        measured.push(Measured { row, survey, build_ms, bytes });
    }
    bar.finish_and_clear();
    Ok(measured)
}

fn build(prims: &Prims, line: &str, flat: bool) -> Result<Structure, Fault> {
    let rule = rule(line);
    let rule = if flat { rule.flat() } else { rule };
    Structure::build(prims, &rule, &mut ()).map_err(|error| Fault::new(error.to_string()))
}
