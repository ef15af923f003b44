//! How steps and tests grow with the number of triangles, slides 10 and 65.

use std::collections::BTreeSet;

use glam::Vec3;
use indicatif::ProgressBar;
use raystep_accel::{Primitives, Prims, Random, Ray, Rule};
use raystep_figure::whole;
use raystep_scene::Scene;
use raystep_scene::trial::scenes::needles;
use serde::Serialize;

use super::survey::{self, survey, timed};
use super::{build, fit, look};
use crate::cli::progress::bar;
use crate::cli::told::{Align, Grid, Page};
use crate::export::Size;
use crate::fault::Fault;

/// One structure over one number of triangles.
#[derive(Serialize)]
pub(super) struct Point {
    table: &'static str,
    row: &'static str,
    rule: String,
    triangles: u64,
    rays: u64,
    cells_per_ray: f64,
    nodes_per_ray: f64,
    boxes_per_ray: f64,
    tests_per_ray: f64,
    build_ms: f64,
    bytes: usize,
}

impl Point {
    /// Cells, nodes and boxes together.
    fn steps_per_ray(&self) -> f64 {
        self.cells_per_ray + self.nodes_per_ray + self.boxes_per_ray
    }
}

/// The teapot's patches are cut into so many squares.
const STEPS: [u32; 12] = [1, 2, 3, 5, 7, 10, 15, 20, 30, 45, 70, 100];
/// Needles through one point: each of them lies in every box around it.
const NEEDLES: [usize; 5] = [10, 30, 100, 300, 1000];
/// Fewer rays are shot where all of them would make more tests than this.
const MOST_TESTS: f64 = 1e8;
/// One ray in so many says how many tests that would be.
const SAMPLE: usize = 97;
/// Rays at the needles.
const AT_NEEDLES: usize = 2000;

/// The structures that are compared; their depth must not stop them early.
fn lines() -> Vec<(&'static str, &'static str)> {
    let line = |kind| match kind {
        "grid" => "grid resolution=3n",
        "kd" => "kd max_depth=64 min_objects=2",
        kind => kind,
    };
    Rule::KINDS.into_iter().map(|kind| (kind, line(kind))).collect()
}

/// Measures the teapot from 1×1 to `finest` and the needles.
pub(super) fn measure(finest: u32, size: Size) -> Result<Vec<Point>, Fault> {
    let teapot =
        |steps| Scene::named(&format!("teapot:{steps}x{steps}")).map_err(|error| Fault::new(error.to_string()));
    // One camera for all: the one that the ten-step teapot fills.
    let shot = look::Shot::of(&teapot(10)?, look::Look::Close, size, false);
    let rays = survey::rays(&shot.camera, size.into())?;
    let steps: Vec<u32> = STEPS.into_iter().filter(|steps| *steps <= finest).collect();
    let bar = bar((lines().len() * (steps.len() * rays.len() + NEEDLES.len() * AT_NEEDLES)) as u64, "rays");
    let mut points = Vec::new();
    for steps in steps {
        points.extend(measure_all("growth", &teapot(steps)?.prims, &rays, &bar)?);
    }
    let rays = at_the_needles();
    for n in NEEDLES {
        points.extend(measure_all("needles", &Prims::Few(needles(1, n)), &rays, &bar)?);
    }
    bar.finish_and_clear();
    Ok(points)
}

fn measure_all(table: &'static str, prims: &Prims, rays: &[Ray], bar: &ProgressBar) -> Result<Vec<Point>, Fault> {
    let bounds = raystep_accel::OneBox::around(prims).bounds;
    let point = |(kind, line)| {
        let (structure, build_ms) = timed(|| build(prims, line, false));
        let structure = structure?;
        let every_nth = |n: usize| rays.iter().copied().step_by(n.max(1)).collect::<Vec<Ray>>();
        let shoot = |rays: &[Ray], bar: &ProgressBar| survey(&structure, prims, &bounds, rays, None, bar);
        let sample = shoot(&every_nth(SAMPLE), &ProgressBar::hidden());
        let tests = sample.tests_per_ray() * rays.len() as f64;
        let some = every_nth((tests / MOST_TESTS).ceil() as usize);
        let found = shoot(&some, bar);
        bar.inc((rays.len() - some.len()) as u64);
        let per_ray = |count: u64| count as f64 / found.rays.max(1) as f64;
        Ok(Point {
            table,
            row: kind,
            rule: super::rows::spelt_out(line),
            triangles: prims.len() as u64,
            rays: found.rays,
            cells_per_ray: per_ray(found.all.cell_steps),
            nodes_per_ray: per_ray(found.all.node_visits),
            boxes_per_ray: per_ray(found.all.box_tests),
            tests_per_ray: per_ray(found.all.prim_tests),
            build_ms,
            bytes: structure.bytes(),
        })
    };
    lines().into_iter().map(point).collect()
}

/// From all around, at the point where the needles cross.
fn at_the_needles() -> Vec<Ray> {
    let mut random = Random::new(2);
    let from = std::iter::repeat_with(|| {
        Vec3::new(random.range(-1.0, 1.0), random.range(-1.0, 1.0), random.range(-1.0, 1.0)) * 3.0
    });
    from.filter_map(|from| Ray::new(from, -from).ok()).take(AT_NEEDLES).collect()
}

/// What was found, and the laws fitted to it.
pub(super) fn page(points: &[Point]) -> Page {
    let mut page = Page::default();
    for (name, title) in [
        ("growth", "The teapot, from coarse to fine; one camera, primary rays"),
        ("needles", "Needles through one point, and rays at that point: here no structure helps"),
    ] {
        page.heading(title);
        let of_table = || points.iter().filter(|point| point.table == name);
        let kinds: BTreeSet<usize> =
            of_table().filter_map(|point| Rule::KINDS.iter().position(|kind| *kind == point.row)).collect();
        for kind in kinds.into_iter().map(|kind| Rule::KINDS[kind]) {
            of_kind(&mut page, &of_table().filter(|point| point.row == kind).collect::<Vec<_>>());
        }
    }
    page.text(
        "Steps are cells, nodes and boxes together. An exponent of 1 is a law that is linear, one near 0 a law that \
         hardly grows; the residual says how far the points lie from the logarithm, in parts of their mean.",
    );
    page
}

/// The rows of one structure and the laws fitted to them.
fn of_kind(page: &mut Page, points: &[&Point]) {
    let Some(first) = points.first() else { return };
    page.text(first.rule.clone());
    let heads = ["triangles", "cells per ray", "nodes per ray", "boxes per ray", "tests per ray", "build ms", "bytes"];
    let mut grid = Grid::new(heads.map(|head| (head, Align::Right)));
    for point in points {
        let [cells, nodes, boxes, tests] =
            [point.cells_per_ray, point.nodes_per_ray, point.boxes_per_ray, point.tests_per_ray]
                .map(|count| format!("{count:.2}"));
        let (triangles, bytes) = (whole(point.triangles), whole(point.bytes as u64));
        grid.row([triangles, cells, nodes, boxes, tests, format!("{:.1}", point.build_ms), bytes]);
    }
    page.table(grid);
    let pairs =
        |y: fn(&Point) -> f64| points.iter().map(|point| (point.triangles as f64, y(point))).collect::<Vec<_>>();
    let mut laws = Vec::new();
    for (what, pairs) in [("steps", pairs(Point::steps_per_ray)), ("tests", pairs(|point| point.tests_per_ray))] {
        if pairs.len() < 3 || pairs.iter().all(|(_, y)| *y == 0.0) {
            continue;
        }
        let (power, log) = (fit::power(&pairs), fit::logarithm(&pairs));
        laws.push(format!(
            "{what}: exponent {:.2}; logarithm {:.2} {} {:.2}·log2 n, residual {:.0} %",
            power.exponent,
            log.start,
            if log.slope < 0.0 { '-' } else { '+' },
            log.slope.abs(),
            log.residual * 100.0
        ));
    }
    if !laws.is_empty() {
        page.lines(laws);
    }
}
