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
use crate::cli::told::{Align, Grid, Page, to_csv, to_json};
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

pub(super) fn csv(measured: &[Measured]) -> Result<String, Fault> {
    to_csv(measured.iter().map(record))
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
pub(super) fn page(scene: &Scene, shot: &Shot, measured: &[Measured]) -> Page {
    let mut page = Page::default();
    heading(&mut page, scene, shot, measured);
    for table in measured.chunk_by(|a, b| a.row.table == b.row.table) {
        page.heading(title(table[0].row.table));
        if table.iter().any(|measured| measured.row.printed.is_some()) {
            page.table(printed(table));
        }
        page.table(counted(table));
    }
    page.heading("Parameters, the same in every table");
    let mut rules: Vec<(&str, String)> = Vec::new();
    for Measured { row, .. } in measured {
        if !rules.iter().any(|(line, _)| *line == row.line) {
            rules.push((&row.line, format!("{}: {}", row.name, spelt_out(&row.line))));
        }
    }
    page.lines(rules.into_iter().map(|(_, rule)| rule).collect());
    for note in NOTES {
        page.text(note);
    }
    page
}

const NOTES: [&str; 2] = [
    "A test is a ray against a primitive: each one counts, also one that is made again. Visits are nodes or cells \
     entered; boxes are volumes tested. A ray is counted once, whatever it meets. \"Tests per box ray\" averages over \
     the rays that meet the box around everything, \"tests per hit ray\" over those that hit. \"To row above\" is the \
     ratio of tests per ray.",
    "The lecture's totals, divided by its tests per ray, give about 587,072 rays on slides 22 and 24 and about \
     1,579,877 on slide 41: two runs, from cameras that it does not name. So the match is of kind, not of digits.",
];

fn heading(page: &mut Page, scene: &Scene, shot: &Shot, measured: &[Measured]) {
    let prims = raystep_figure::counted(scene.prims.len() as u64, "primitive", "primitives");
    let mut about = format!("{}: {prims}, {} pixels", scene.name, shot.size);
    if let Camera::Solid { eye, target, fov_degrees, .. } = shot.camera {
        let _ = write!(about, ", eye {eye:.2} towards {target:.2}, {fov_degrees}°");
    }
    let light =
        |light| format!(" One shadow ray from each hit to the light at {light:.2}; a blocked one counts as a hit.");
    about += ".";
    about += &shot.light.map_or_else(|| " Primary rays only.".to_owned(), light);
    if let Some(Measured { survey, .. }) = measured.first() {
        let share = |rays: u64| 100.0 * rays as f64 / survey.rays.max(1) as f64;
        let [boxed, hits] = [survey.box_rays, survey.hit_rays].map(share);
        let _ = write!(about, " {} rays: {boxed:.0} % meet the box, {hits:.0} % hit.", whole(survey.rays));
    }
    page.text(about);
}

/// As the lecture prints it, beside what was measured here.
fn printed(table: &[Measured]) -> Grid {
    let heads = [
        "tests per ray, printed",
        "tests per ray, here",
        "to row above, printed",
        "to row above, here",
        "total, printed",
        "total, here",
    ];
    let mut grid = Grid::new([("row", Align::Left)].into_iter().chain(heads.map(|head| (head, Align::Right))));
    for (index, own @ Measured { row, survey, .. }) in table.iter().enumerate() {
        let none = || "-".to_owned();
        let above = index.checked_sub(1).and_then(|above| table.get(above));
        let ratios = above.and_then(|above| {
            let here = survey.tests_per_ray() / above.survey.tests_per_ray();
            Some([row.printed?.0 / above.row.printed?.0, here].map(|ratio| format!("{ratio:.4}")))
        });
        let [ratio, here] = ratios.unwrap_or_else(|| [none(), none()]);
        grid.row([
            row.name.clone(),
            row.printed.map_or_else(none, |(tests, _)| format!("{tests:.2}")),
            format!("{:.2}", survey.tests_per_ray()),
            ratio,
            here,
            row.printed.and_then(|(_, total)| total).map_or_else(none, whole),
            whole(own.survey.all.prim_tests),
        ]);
    }
    grid
}

/// What was counted here.
fn counted(table: &[Measured]) -> Grid {
    let heads = [
        "tests per ray",
        "tests per box ray",
        "tests per hit ray",
        "visits per ray",
        "boxes per ray",
        "build ms",
        "bytes",
    ];
    let mut grid = Grid::new([("row", Align::Left)].into_iter().chain(heads.map(|head| (head, Align::Right))));
    for Measured { row, survey, build_ms, bytes } in table {
        let counts = [
            survey.tests_per_ray(),
            survey.tests_per_box_ray(),
            survey.tests_per_hit_ray(),
            survey.visits_per_ray(),
            survey.boxes_per_ray(),
        ];
        let counts = counts.map(|count| format!("{count:.2}"));
        let last = [format!("{build_ms:.1}"), whole(*bytes as u64)];
        grid.row([row.name.clone()].into_iter().chain(counts).chain(last));
    }
    grid
}
