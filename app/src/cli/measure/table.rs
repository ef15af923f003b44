//! The tables as text, comma-separated values and JSON.

use std::fmt::Write;

use raystep_accel::Primitives;
use raystep_figure::Camera;
use raystep_figure::whole;
use raystep_scene::Scene;
use serde::Serialize;

use super::Measured;
use super::look::Shot;
use super::rows::spelt_out;
use crate::fault::Fault;

/// A row as files hold it.
#[derive(Serialize)]
struct Record<'a> {
    table: &'a str,
    row: &'a str,
    rule: String,
    printed: Option<f64>,
    tests_per_ray: f64,
    tests_per_box_ray: f64,
    tests_per_hit_ray: f64,
    total: u64,
    visits_per_ray: f64,
    build_ms: f64,
    bytes: usize,
}

fn record(measured: &Measured) -> Record<'_> {
    let Measured { row, survey, build_ms, bytes } = measured;
    Record {
        table: row.table,
        row: &row.name,
        rule: spelt_out(&row.line),
        printed: row.printed.map(|(tests, _)| tests),
        tests_per_ray: survey.tests_per_ray(),
        tests_per_box_ray: survey.tests_per_box_ray(),
        tests_per_hit_ray: survey.tests_per_hit_ray(),
        total: survey.all.prim_tests,
        visits_per_ray: survey.visits_per_ray(),
        build_ms: *build_ms,
        bytes: *bytes,
    }
}

pub(super) fn json(measured: &[Measured]) -> Result<String, Fault> {
    let records: Vec<_> = measured.iter().map(record).collect();
    to_json(&records)
}

/// JSON with a line's end.
pub(in crate::cli) fn to_json(records: &impl Serialize) -> Result<String, Fault> {
    let json = serde_json::to_string_pretty(records).map_err(|error| Fault::new(error.to_string()))?;
    Ok(json + "\n")
}

pub(super) fn csv(measured: &[Measured]) -> Result<String, Fault> {
    to_csv(measured.iter().map(record))
}

/// Comma-separated values under their names.
pub(in crate::cli) fn to_csv(records: impl Iterator<Item = impl Serialize>) -> Result<String, Fault> {
    let broken = |error: &dyn std::fmt::Display| Fault::new(error.to_string());
    let mut writer = csv::Writer::from_writer(Vec::new());
    for record in records {
        writer.serialize(record).map_err(|error| broken(&error))?;
    }
    let bytes = writer.into_inner().map_err(|error| broken(&error))?;
    String::from_utf8(bytes).map_err(|error| broken(&error))
}

/// What a table is about.
fn title(table: &str) -> String {
    match table {
        "also" => "As asked for".to_owned(),
        "other" => "Structures that the lecture prints no figures for".to_owned(),
        "volumes" => "A hierarchy's volumes and builders".to_owned(),
        slide => format!("Slide {slide}"),
    }
}

/// A page that says how it was measured, then table by table what was printed and what was measured.
pub(super) fn text(scene: &Scene, shot: &Shot, measured: &[Measured]) -> String {
    let mut page = heading(scene, shot, measured);
    let mut table = "";
    let mut above: Option<&Measured> = None;
    for row in measured {
        if row.row.table != table {
            table = row.row.table;
            above = None;
            page += &format!("\n{}\n{COLUMNS}\n", title(table));
        }
        page += &line(row, above);
        above = Some(row);
    }
    page += "\nParameters, the same in every table:\n";
    let mut said = Vec::new();
    for row in measured {
        if !said.contains(&&row.row.line) {
            said.push(&row.row.line);
            page += &format!("  {:<22} {}\n", row.row.name, spelt_out(&row.row.line));
        }
    }
    page += NOTES;
    page
}

const COLUMNS: &str = "row                      printed   tests/ray   per box ray   per hit ray   to row above     \
                       printed total           total   visits/ray   boxes/ray   build ms        bytes";

const NOTES: &str = "
A test is a ray against a primitive: each one counts, also one that is made again. Visits are nodes or cells entered;
boxes are volumes tested. A ray is counted once, whatever it meets. \"Per box ray\" averages over the rays that meet the
box around everything, \"per hit ray\" over those that hit. \"To row above\" is the ratio as printed, then as measured.
The lecture's totals, divided by its tests per ray, give about 587,072 rays on slides 22 and 24 and about 1,579,877 on
slide 41: two runs, from cameras that it does not name. So the match is of kind, not of digits.
";

fn heading(scene: &Scene, shot: &Shot, measured: &[Measured]) -> String {
    let mut page = format!("{}: {} primitives, {} pixels", scene.name, whole(scene.prims.len() as u64), shot.size);
    if let Camera::Solid { eye, target, fov_degrees, .. } = shot.camera {
        let _ = write!(page, ", eye {eye:.2} towards {target:.2}, {fov_degrees}°");
    }
    let light =
        |light| format!("One shadow ray from each hit to the light at {light:.2}; a blocked one counts as a hit.\n");
    page += ".\n";
    page += &shot.light.map_or_else(|| "Primary rays only.\n".to_owned(), light);
    if let Some(Measured { survey, .. }) = measured.first() {
        let share = |rays: u64| 100.0 * rays as f64 / survey.rays.max(1) as f64;
        let [boxed, hits] = [survey.box_rays, survey.hit_rays].map(share);
        let _ = writeln!(page, "{} rays: {boxed:.0} % meet the box, {hits:.0} % hit.", whole(survey.rays));
    }
    page
}

fn line(measured: &Measured, above: Option<&Measured>) -> String {
    let Measured { row, survey, build_ms, bytes } = measured;
    let printed = row.printed.map_or_else(|| "-".to_owned(), |(tests, _)| format!("{tests:.2}"));
    let ratio = above.and_then(|above| {
        let here = survey.tests_per_ray() / above.survey.tests_per_ray();
        Some(format!("{:.4}, {here:.4}", row.printed?.0 / above.row.printed?.0))
    });
    let printed_total = row.printed.and_then(|(_, total)| total).map_or_else(|| "-".to_owned(), whole);
    format!(
        "{:<22} {printed:>9} {:>11.2} {:>13.2} {:>13.2} {:>14} {printed_total:>17} {:>15} {:>12.2} {:>11.2} \
         {build_ms:>10.1} {:>12}\n",
        row.name,
        survey.tests_per_ray(),
        survey.tests_per_box_ray(),
        survey.tests_per_hit_ray(),
        ratio.unwrap_or_else(|| "-".to_owned()),
        whole(survey.all.prim_tests),
        survey.visits_per_ray(),
        survey.boxes_per_ray(),
        whole(*bytes as u64),
    )
}
