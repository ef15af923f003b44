//! `raystep trace`: of one ray the walk, of a table of rays the hits and counters.

use std::path::{Path, PathBuf};

use clap::Args;
use glam::Vec2;
use indicatif::ProgressBar;
use rayon::prelude::*;
use raystep_accel::{Accel, Cost, Hit, Ray, Rule, Structure, Trace};
use raystep_figure::{Camera, number, whole};
use raystep_print::{Record, Told};
use raystep_scene::Scene;
use serde::Serialize;

use super::progress::bar;
use super::rays;
use super::subject::Subject;
use super::told::{Align, Format, Grid, Page, to_csv, to_json};
use super::walked::Walked;
use crate::export::Size;
use crate::fault::Fault;
use crate::files;
use crate::shown::camera;

/// What to trace, and how.
#[derive(Args, Debug)]
pub struct TraceArguments {
    #[command(flatten)]
    subject: Subject,
    /// A table of rays with the header ox,oy,oz,dx,dy,dz[,t_min,t_max].
    #[arg(long, value_name = "FILE.csv", conflicts_with = "pixel", required_unless_present_any = ["pixel", "ray"])]
    rays: Option<PathBuf>,
    /// One ray: where it starts, its direction, and the t that count.
    #[arg(long, value_name = "OX,OY,OZ,DX,DY,DZ[,T_MIN,T_MAX]", conflicts_with_all = ["pixel", "rays"],
          allow_hyphen_values = true)]
    ray: Option<String>,
    /// The ray through the middle of a pixel of a solid scene, counted from the upper left one.
    #[arg(long, value_name = "X,Y", value_parser = pixel)]
    pixel: Option<[u32; 2]>,
    /// The size of the picture that the pixel belongs to.
    #[arg(long, value_name = "WxH", default_value = "1600x1000")]
    size: Size,
    /// Where to write; without it, to the standard output.
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// How to write it; without it, as the ending of --out says, else as a text.
    #[arg(long, value_enum)]
    format: Option<Format>,
}

/// How many events of one walk are kept.
const TAPE: usize = 1_000_000;

/// So many rays walk before their hits are written.
const SOME: usize = 1 << 16;

/// Walks the rays.
pub(crate) fn run(arguments: &TraceArguments) -> Result<(), Fault> {
    if let Some(path) = &arguments.out {
        let read = [&arguments.subject.mesh, &arguments.rays].into_iter().flatten();
        files::may_write(path, &read.map(PathBuf::as_path).collect::<Vec<_>>())?;
    }
    let scene = arguments.subject.scene()?;
    let rule = arguments.subject.rule(scene.flat)?;
    let rays = table(arguments, &scene)?;
    let structure = Structure::build(&scene.prims, &rule, &mut ()).map_err(|error| Fault::new(error.to_string()))?;
    let format = arguments.format.or(arguments.out.as_deref().and_then(Format::of_ending)).unwrap_or(Format::Text);
    let text = match rays.as_slice() {
        [ray] if arguments.rays.is_none() => {
            walk(&scene, &rule, &structure, ray.as_ref().map_err(|why| Fault::new(why.clone()))?, format)?
        }
        _ => hits(&scene, &structure, &rays, format)?,
    };
    match &arguments.out {
        Some(path) => files::write(path, text.as_bytes()),
        None => files::print(&text),
    }
}

fn name(path: &Path) -> String {
    path.display().to_string()
}

fn table(arguments: &TraceArguments, scene: &Scene) -> Result<Vec<Result<Ray, String>>, Fault> {
    if let Some(path) = &arguments.rays {
        let rays = rays::read_moved(&files::read(path)?, &name(path), scene.origin)?;
        let (file, all) = (name(path), rays.len());
        let unusable = rays.iter().filter(|ray| ray.is_err()).count();
        if unusable == all {
            let why = rays.first().and_then(|ray| ray.as_ref().err());
            let why = why.map_or_else(
                || "no row stands below its first line".to_owned(),
                |why| format!("none of its {all} rows is one, the first one since {why}"),
            );
            return Err(Fault::new(format!("{file} has no ray: {why}")));
        }
        if unusable > 0 {
            files::say(&format!("{file}: {unusable} of {all} rows are no rays; the table of hits says why"));
        }
        return Ok(rays);
    }
    if let Some(line) = &arguments.ray {
        let ray = rays::read_one(line, scene.origin).map_err(|why| Fault::new(format!("--ray {line}: {why}")))?;
        return Ok(vec![Ok(ray)]);
    }
    let camera = camera::of_scene(scene, arguments.size.into());
    through(scene, &camera, arguments.size, arguments.pixel.unwrap_or_default()).map(|ray| vec![Ok(ray)])
}

/// The ray through the middle of a pixel of a picture of this size.
pub(super) fn through(scene: &Scene, camera: &Camera, size: Size, [x, y]: [u32; 2]) -> Result<Ray, Fault> {
    if scene.flat {
        return Err(Fault::new(format!(
            "--pixel: {} is flat, and a ray through a pixel would fall onto it from above; write one in its plane, as \
             in --ray 0,1,0,1,0.5,0",
            scene.name
        )));
    }
    let pixels: Vec2 = size.into();
    let at = Vec2::new(x as f32 + 0.5, y as f32 + 0.5);
    if at.x > pixels.x || at.y > pixels.y {
        return Err(Fault::new(format!("--pixel {x},{y} lies outside a picture of {size}")));
    }
    camera.ray(at, pixels).map_err(|error| Fault::new(error.to_string()))
}

/// What a ray of a table met, as files hold it; of an unusable one `hit` says why.
#[derive(Serialize)]
struct Row {
    ray: usize,
    hit: String,
    t: Option<String>,
    prim: Option<u32>,
    prim_tests: Option<u64>,
    node_visits: Option<u64>,
    cell_steps: Option<u64>,
    box_tests: Option<u64>,
}

impl Row {
    /// The same with a hit that is true or false, and why there is neither.
    fn object(&self) -> serde_json::Value {
        let mut object = serde_json::json!(self);
        let hit = self.hit.parse::<bool>().ok();
        object["hit"] = hit.into();
        object["t"] = self.t.as_ref().and_then(|t| t.parse::<f32>().ok()).into();
        if hit.is_none() {
            object["wrong"] = self.hit.clone().into();
        }
        object
    }
}

/// The table of hits.
fn hits(scene: &Scene, structure: &Structure, rays: &[Result<Ray, String>], format: Format) -> Result<String, Fault> {
    let bar = if rays.len() > 10_000 { bar(rays.len() as u64, "rays") } else { ProgressBar::hidden() };
    let answer = |ray: &Result<Ray, String>| -> Result<(Option<Hit>, Cost), String> {
        bar.inc(1);
        let ray = ray.as_ref().map_err(String::clone)?;
        let mut cost = Cost::default();
        Ok((structure.intersect(&scene.prims, ray, &mut cost), cost))
    };
    // Some at a time, so that only their rows fill the memory.
    let answers = rays.chunks(SOME).flat_map(|some| some.par_iter().map(answer).collect::<Vec<_>>());
    let rows = answers.enumerate().map(|(ray, answer)| row(ray, answer));
    let text = match format {
        Format::Csv => to_csv(rows)?,
        Format::Json => to_json(&rows.map(|row| row.object()).collect::<Vec<_>>())?,
        format => page(rows).written(format),
    };
    bar.finish_and_clear();
    Ok(text)
}

fn row(ray: usize, answer: Result<(Option<Hit>, Cost), String>) -> Row {
    match answer {
        Err(why) => Row {
            ray,
            hit: format!("unusable: {why}"),
            t: None,
            prim: None,
            prim_tests: None,
            node_visits: None,
            cell_steps: None,
            box_tests: None,
        },
        Ok((hit, cost)) => Row {
            ray,
            hit: hit.is_some().to_string(),
            t: hit.map(|hit| hit.t.to_string()),
            prim: hit.map(|hit| hit.prim.0),
            prim_tests: Some(cost.prim_tests),
            node_visits: Some(cost.node_visits),
            cell_steps: Some(cost.cell_steps),
            box_tests: Some(cost.box_tests),
        },
    }
}

/// The rows for people.
fn page(rows: impl Iterator<Item = Row>) -> Page {
    let counts = ["primitives tested", "nodes visited", "cells entered", "volumes tested"];
    let heads = [("ray", Align::Right), ("hit", Align::Left), ("t", Align::Right), ("primitive", Align::Right)];
    let mut grid = Grid::new(heads.into_iter().chain(counts.map(|head| (head, Align::Right))));
    for row in rows {
        let count = |count: Option<u64>| count.map_or_else(String::new, whole);
        let hit = match &*row.hit {
            "true" => "yes".to_owned(),
            "false" => "no".to_owned(),
            why => why.to_owned(),
        };
        grid.row([
            whole(row.ray as u64),
            hit,
            row.t.and_then(|t| t.parse().ok()).map_or_else(String::new, number),
            row.prim.map_or_else(String::new, |prim| prim.to_string()),
            count(row.prim_tests),
            count(row.node_visits),
            count(row.cell_steps),
            count(row.box_tests),
        ]);
    }
    let mut page = Page::default();
    page.table(grid);
    page
}

/// One walk, event by event.
fn walk(scene: &Scene, rule: &Rule, structure: &Structure, ray: &Ray, format: Format) -> Result<String, Fault> {
    let mut tape = Trace::new(TAPE);
    let hit = structure.intersect(&scene.prims, ray, &mut tape);
    if tape.lost > 0 {
        let (kept, lost) = (whole(tape.events.len() as u64), whole(tape.lost));
        files::say(&format!("the first {kept} events of the walk are written; {lost} more are counted as `lost`"));
    }
    if format != Format::Json {
        return Walked { scene, rule, structure, ray, tape: &tape, hit }.written(format);
    }
    Ok(raystep_print::json(&Record {
        scene: &scene.name,
        origin: scene.origin.to_array(),
        kind: rule.kind(),
        parameters: &rule.parameters().into_iter().map(|p| (p.key.to_owned(), p.value)).collect::<Vec<_>>(),
        nodes: structure.node_count(),
        bytes: structure.bytes(),
        told: Told::Walk { name: None, ray, events: &tape.events, hit },
        lost: tape.lost,
    }))
}

/// `800,500`
pub(super) fn pixel(text: &str) -> Result<[u32; 2], String> {
    let number = |text: &str| text.trim().parse().ok();
    let pair = text.split_once(',').and_then(|(x, y)| Some([number(x)?, number(y)?]));
    pair.ok_or_else(|| "write two whole numbers with a comma between them, as in 800,500".to_owned())
}
