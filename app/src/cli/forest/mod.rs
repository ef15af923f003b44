//! `raystep forest`: fifty billion triangles, slide 10.

mod memory;
mod surface;
mod told;

use std::path::PathBuf;
use std::time::Instant;

use clap::Args;
use glam::Vec3;
use rayon::prelude::*;
use raystep_accel::{Aabb, Accel, List, Mesh, Random, Ray};
use raystep_fast::{Daylight, Fast, Line, Settings, TwoLevels, Work};
use raystep_figure::{Figure, Image, Ink, Role, Theme};
use raystep_print::{png, svg};
use raystep_scene::{MOST_TREES, TRIANGLES_OF_A_TREE, Woods};

use super::progress::bar;
use super::spelt;
use crate::export::Size;
use crate::fault::Fault;
use crate::files;
use surface::Looks;
use told::Told;

/// How the forest is drawn.
#[derive(Args, Debug)]
pub struct ForestArguments {
    /// The size of the picture.
    #[arg(long, value_name = "WxH", default_value = "1000x1000")]
    size: Size,
    /// Rays from the eye for each pixel.
    #[arg(long, value_name = "N", default_value_t = 4, allow_negative_numbers = true,
          value_parser = spelt::whole(1_u32..=64))]
    samples: u32,
    /// How many trees there are.
    #[arg(long, value_name = "N", default_value_t = MOST_TREES,
          allow_negative_numbers = true, value_parser = spelt::whole(1_u32..=MOST_TREES))]
    trees: u32,
    /// Triangles of each tree, at least.
    #[arg(long, value_name = "N", default_value_t = TRIANGLES_OF_A_TREE,
          allow_negative_numbers = true, value_parser = spelt::whole(1000_u32..=4_000_000))]
    triangles: u32,
    /// Where to write the picture.
    #[arg(long, value_name = "FILE.png", default_value = "forest.png")]
    out: PathBuf,
}

/// Grows, builds, renders, writes, and tells what that took.
pub(crate) fn run(arguments: &ForestArguments) -> Result<(), Fault> {
    let &ForestArguments { size, samples, trees, triangles, ref out } = arguments;
    if out.extension().is_none_or(|ending| !ending.eq_ignore_ascii_case("png")) {
        return Err(Fault::new(format!("--out {}: the forest is written as FILE.png; end the name so", out.display())));
    }
    files::may_write(out, &[])?;
    let (woods, grown) = timed(|| {
        let bar = bar(5, "models grown");
        let woods = Woods::planted(trees, triangles, &mut || bar.inc(1));
        bar.finish_and_clear();
        woods
    });
    files::say("building the trees over the triangles ...");
    let (scene, built) = timed(|| TwoLevels::build(&woods.instances, &Settings::default()));
    let day = daylight(&woods, size, samples);
    let (lines, rendered) = timed(|| render(&day, &scene, &woods));
    let work = lines.iter().fold(Work::default(), |mut sum, line| {
        sum.triangles += line.work.triangles;
        sum.nodes += line.work.nodes;
        sum
    });
    let models = woods.instances.models();
    let told = Told {
        size,
        samples,
        trees: woods.trees() as u64,
        triangles: woods.instances.triangles(),
        stored: models.iter().map(|model| model.mesh.triangles.len() as u64).sum(),
        bytes: scene.bytes() as u64,
        threads: rayon::current_num_threads(),
        grown,
        built,
        rendered,
        seen: lines.iter().map(|line| line.seen).sum(),
        lit: lines.iter().map(|line| line.lit).sum(),
        tests: work.triangles,
        nodes: work.nodes,
        rate: brute_force(&models[0].mesh),
        resident: memory::most_resident(),
    };
    files::write(out, &picture(day.size, lines)?)?;
    files::print(&told.text())
}

/// Above the trees of a slope, over the valley, in the morning.
fn daylight(woods: &Woods, size: Size, samples: u32) -> Daylight {
    let above = |x: f32, y: f32, up: f32| Vec3::new(x, y, woods.land.height(x, y) + up);
    let pixels: glam::Vec2 = size.into();
    Daylight {
        eye: above(-150.0, -560.0, 22.0),
        target: above(60.0, 0.0, 4.0),
        fov_degrees: 50.0,
        size: [pixels.x as u32, pixels.y as u32],
        samples,
        sun: Vec3::new(-0.85, 0.15, 0.38).normalize(),
        haze: 2200.0,
        shade: 5.0,
    }
}

/// All rows, on all threads.
fn render(day: &Daylight, scene: &TwoLevels, woods: &Woods) -> Vec<Line> {
    let bar = bar(u64::from(day.size[1]), "rows");
    let row = |y: u32| {
        let line = day.row(y, scene, &Looks(woods));
        bar.inc(1);
        line
    };
    let lines = (0..day.size[1]).into_par_iter().map(row).collect();
    bar.finish_and_clear();
    lines
}

/// Rays that brute force is timed with, for each thread.
const TRIED: u64 = 8;

/// Tests a second that brute force makes on all threads.
fn brute_force(mesh: &Mesh) -> f64 {
    let bounds = mesh.corners.iter().fold(Aabb::EMPTY, |all, corner| all.union(Aabb::new(*corner, *corner)));
    let mut random = Random::new(1);
    let mut anywhere = || bounds.min + bounds.extent() * Vec3::new(random.unit(), random.unit(), random.unit());
    let rays: Vec<Ray> = std::iter::repeat_with(|| Ray::new(anywhere(), anywhere() - bounds.center()))
        .flatten()
        .take((TRIED * rayon::current_num_threads() as u64) as usize)
        .collect();
    let (hits, seconds) = timed(|| rays.par_iter().filter(|ray| List.intersect(mesh, ray, &mut ()).is_some()).count());
    std::hint::black_box(hits);
    (rays.len() * mesh.triangles.len()) as f64 / seconds.max(1e-9)
}

/// The picture as a file.
fn picture([width, height]: [u32; 2], lines: Vec<Line>) -> Result<Vec<u8>, Fault> {
    let rgba: Vec<u8> = lines.into_iter().flat_map(|line| line.rgba).collect();
    let max = glam::Vec2::new(width as f32, height as f32);
    let mut figure = Figure::new(max);
    let image = Image { width, height, rgba: rgba.into() };
    figure.add(Role::Scene, None, Ink::Image { min: glam::Vec2::ZERO, max, image });
    png(&svg(&figure, &Theme::LIGHT), 1.0).map_err(|error| Fault::new(error.to_string()))
}

/// What is done, and how many seconds it takes.
fn timed<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let begun = Instant::now();
    let done = work();
    (done, begun.elapsed().as_secs_f64())
}
