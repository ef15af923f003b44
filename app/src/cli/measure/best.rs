//! `raystep measure --best`: which structure is best for a scene or a mesh?

use indicatif::ProgressBar;
use raystep_accel::Primitives;
use raystep_figure::{counted, number, whole};
use serde::Serialize;

use super::MeasureArguments;
use super::look::Shot;
use crate::cli::progress::bar;
use crate::cli::subject;
use crate::cli::told::{Align, Format, Grid, Page, to_csv, to_json};
use crate::fault::Fault;
use crate::rating::{Candidate, Rated, rate, rays, told};

/// A structure as files hold it; times are left out unless they are asked for.
#[derive(Serialize)]
struct Record {
    structure: &'static str,
    rule: String,
    rays: u64,
    tests_per_ray: f64,
    visits_per_ray: f64,
    boxes_per_ray: f64,
    nodes: Option<u64>,
    bytes: u64,
    #[serde(skip_serializing_if = "Option::is_none")]
    build_ms: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    ray_us: Option<f64>,
}

/// Measures all structures, and says what was found.
pub(super) fn run(arguments: &MeasureArguments) -> Result<String, Fault> {
    let scene = match &arguments.mesh {
        Some(path) => subject::mesh(path)?,
        None => subject::named(&arguments.scene)?,
    };
    if scene.flat {
        return Err(Fault::new(format!(
            "{} is flat: rays through a picture would fall onto it from above; name a solid scene or a mesh",
            scene.name
        )));
    }
    let shot = Shot::of(&scene, arguments.camera, arguments.size, false);
    let pixels: glam::Vec2 = shot.size.into();
    let wrong = |error: raystep_accel::RayError| Fault::new(format!("the camera shoots no rays: {error}"));
    let rays = rays(&shot.camera, [pixels.x as u32, pixels.y as u32]).map_err(wrong)?;
    let candidates = Candidate::all(&scene);
    let bar: ProgressBar = bar(candidates.len() as u64, "structures");
    let mut rated = Vec::new();
    for what in candidates {
        rated.extend(rate(&scene, what, &rays, &|| true));
        bar.inc(1);
    }
    bar.finish_and_clear();
    let records: Vec<Record> = rated.iter().map(|rated| record(rated, arguments.times)).collect();
    match arguments.format {
        Format::Json => to_json(&records),
        Format::Csv => to_csv(records.iter()),
        format => {
            let least = rated.iter().map(|rated| rated.rays).min().unwrap_or(0);
            let fewer = match least < rays.len() as u64 {
                true => format!(" Brute force is asked by {} of them.", whole(least)),
                false => String::new(),
            };
            let about = format!(
                "{}: {}; {}, one for each pixel of a picture of {}.{fewer}",
                scene.name,
                counted(scene.prims.len() as u64, "primitive", "primitives"),
                counted(rays.len() as u64, "ray", "rays"),
                shot.size
            );
            let mut page = Page::default();
            page.text(about);
            tell(&mut page, &rated, arguments.times);
            Ok(page.written(format))
        }
    }
}

fn record(rated: &Rated, times: bool) -> Record {
    Record {
        structure: rated.what.kind(),
        rule: rated.what.written(),
        rays: rated.rays,
        tests_per_ray: rated.tests,
        visits_per_ray: rated.visits,
        boxes_per_ray: rated.boxes,
        nodes: rated.nodes,
        bytes: rated.bytes,
        build_ms: times.then_some(rated.build_ms),
        ray_us: times.then_some(rated.ray_us),
    }
}

/// The table, then a sentence for each.
fn tell(page: &mut Page, rated: &[Rated], times: bool) {
    let mut heads = vec!["tests per ray", "visits per ray", "boxes per ray", "nodes, cells", "bytes"];
    if times {
        heads.extend(["build ms", "one ray, µs"]);
    }
    let heads = heads.into_iter().map(|head| (head, Align::Right));
    let mut grid = Grid::new([("structure", Align::Left)].into_iter().chain(heads));
    for rated in rated {
        let [tests, visits, boxes] = [rated.tests, rated.visits, rated.boxes].map(|value| format!("{value:.2}"));
        let nodes = rated.nodes.map_or_else(String::new, whole);
        let mut cells = vec![rated.what.name().to_owned(), tests, visits, boxes, nodes, whole(rated.bytes)];
        if times {
            cells.extend([number(rated.build_ms as f32), number(rated.ray_us as f32)]);
        }
        grid.row(cells);
    }
    page.table(grid);
    page.lines(told(rated, times));
    page.text("Less is better in every column. Steps are visits (nodes or cells entered) and boxes (volumes tested) together.");
}
