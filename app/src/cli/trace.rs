//! `raystep trace`: rays in, hits and counters out.

use std::io::IsTerminal;
use std::path::{Path, PathBuf};

use clap::Args;
use glam::Vec2;
use indicatif::ProgressBar;
use rayon::prelude::*;
use raystep_accel::{Accel, Cost, Hit, Ray, Rule, Structure, Trace};
use raystep_figure::{Camera, whole};
use raystep_print::{Record, Told};
use raystep_scene::Scene;

use super::rays;
use super::subject::Subject;
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
    /// Write the whole walk of the one ray.
    #[arg(long)]
    json: bool,
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
    let text = if arguments.json {
        let [ray] = rays.as_slice() else {
            let count = rays.len();
            return Err(Fault::new(format!("--json writes the walk of one ray, and there are {count}: leave one in")));
        };
        walk(&scene, &rule, &structure, ray.as_ref().map_err(|why| Fault::new(why.clone()))?)
    } else {
        hits(&scene, &structure, &rays)?
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
        let unusable = rays.iter().filter(|ray| ray.is_err()).count();
        if unusable > 0 {
            let (file, all) = (name(path), rays.len());
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

/// The table of hits.
fn hits(scene: &Scene, structure: &Structure, rays: &[Result<Ray, String>]) -> Result<String, Fault> {
    let bar = if rays.len() > 10_000 && std::io::stderr().is_terminal() {
        ProgressBar::new(rays.len() as u64)
    } else {
        ProgressBar::hidden()
    };
    let answer = |ray: &Result<Ray, String>| -> Result<(Option<Hit>, Cost), String> {
        bar.inc(1);
        let ray = ray.as_ref().map_err(String::clone)?;
        let mut cost = Cost::default();
        Ok((structure.intersect(&scene.prims, ray, &mut cost), cost))
    };
    let mut writer = csv::Writer::from_writer(Vec::new());
    let broken = |error: csv::Error| Fault::new(error.to_string());
    writer
        .write_record(["ray", "hit", "t", "prim", "prim_tests", "node_visits", "cell_steps", "box_tests"])
        .map_err(broken)?;
    // Some at a time, so that only their rows fill the memory.
    let answers = rays.chunks(SOME).flat_map(|some| some.par_iter().map(answer).collect::<Vec<_>>());
    for (index, answer) in answers.enumerate() {
        let none = String::new;
        let row = match answer {
            Err(why) => [index.to_string(), format!("unusable: {why}"), none(), none(), none(), none(), none(), none()],
            Ok((hit, cost)) => [
                index.to_string(),
                hit.is_some().to_string(),
                hit.map_or_else(none, |hit| hit.t.to_string()),
                hit.map_or_else(none, |hit| hit.prim.to_string()),
                cost.prim_tests.to_string(),
                cost.node_visits.to_string(),
                cost.cell_steps.to_string(),
                cost.box_tests.to_string(),
            ],
        };
        writer.write_record(row).map_err(broken)?;
    }
    bar.finish_and_clear();
    let bytes = writer.into_inner().map_err(|error| Fault::new(error.to_string()))?;
    String::from_utf8(bytes).map_err(|error| Fault::new(error.to_string()))
}

/// One walk, event by event.
fn walk(scene: &Scene, rule: &Rule, structure: &Structure, ray: &Ray) -> String {
    let mut tape = Trace::new(TAPE);
    let hit = structure.intersect(&scene.prims, ray, &mut tape);
    if tape.lost > 0 {
        let (kept, lost) = (whole(tape.events.len() as u64), whole(tape.lost));
        files::say(&format!("the first {kept} events of the walk are written; {lost} more are counted as `lost`"));
    }
    raystep_print::json(&Record {
        scene: &scene.name,
        origin: scene.origin.to_array(),
        kind: rule.kind(),
        parameters: &rule.parameters().into_iter().map(|p| (p.key.to_owned(), p.value)).collect::<Vec<_>>(),
        nodes: structure.node_count(),
        bytes: structure.bytes(),
        told: Told::Walk { name: None, ray, events: &tape.events, hit },
        lost: tape.lost,
    })
}

/// `800,500`
pub(super) fn pixel(text: &str) -> Result<[u32; 2], String> {
    let number = |text: &str| text.trim().parse().ok();
    let pair = text.split_once(',').and_then(|(x, y)| Some([number(x)?, number(y)?]));
    pair.ok_or_else(|| "write two whole numbers with a comma between them, as in 800,500".to_owned())
}
