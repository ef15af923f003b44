//! What observing a walk costs: nothing while nobody watches.
//!
//! `cargo bench --bench silence` walks the same rays through the same structures twice, observed by `()`
//! and by hand-stripped copies of the walks, in pairs of rounds that take turns, and prints the median
//! ratio with its spread. Counters (`Cost`) and full traces are measured beside them.
//!
//! `cargo bench --bench silence -- --instructions` counts instructions instead. It needs valgrind:
//! each walk runs once under `valgrind --tool=callgrind --toggle-collect='*counted*'`, which counts
//! within the functions of that name only.

mod instructions;
mod rounds;
mod stripped;

use std::hint::black_box;

use criterion::Criterion;
use raystep_accel::{
    Accel, Bvh, BvhRule, Cost, Grid, GridRule, Hit, Kd, KdRule, Mesh, Primitives, Prims, Ray, Trace, Visit,
};
use raystep_scene::Scene;
use stripped::{bvh::StrippedBvh, grid::StrippedGrid, kd::StrippedKd};

/// The structures, each with its stripped copy.
struct Stage {
    mesh: Mesh,
    rays: Vec<Ray>,
    grid: (Grid, StrippedGrid),
    kd: (Kd, StrippedKd),
    bvh: (Bvh, StrippedBvh),
}

/// A walk of the nearest hit for each ray; the sum of all t keeps it from being left out.
type Walk<'a> = Box<dyn Fn() -> f32 + 'a>;

impl Stage {
    fn new() -> Stage {
        let scene = Scene::named("teapot-6321").expect("the teapot is shipped");
        let Prims::Mesh(mesh) = scene.prims else { unreachable!("the teapot is a mesh") };
        let (grid_rule, kd_rule, bvh_rule) = (GridRule::default(), KdRule::default(), BvhRule::default());
        let grid = Grid::build(&mesh, &grid_rule, &mut ()).expect("() does not cancel");
        let kd = Kd::build(&mesh, &kd_rule, &mut ()).expect("() does not cancel");
        let bvh = Bvh::build(&mesh, &bvh_rule, &mut ()).expect("() does not cancel");
        let rays = rays(&grid.lattice.bounds);
        Stage {
            rays,
            grid: (grid.clone(), StrippedGrid::of(&grid, grid_rule.mailbox, mesh.len())),
            kd: (kd.clone(), StrippedKd::of(&kd, kd_rule.mailbox, mesh.len())),
            bvh: (bvh.clone(), StrippedBvh::of(&bvh, bvh_rule.order)),
            mesh,
        }
    }

    /// For each structure its name, the stripped walk and the walk observed by `()`.
    fn pairs(&self) -> [(&'static str, Walk<'_>, Walk<'_>); 3] {
        let Stage { mesh, rays, grid, kd, bvh } = self;
        [
            ("grid", stripped_walk(rays, |ray| grid.1.intersect(mesh, ray)), silent_walk(&grid.0, mesh, rays)),
            ("kd", stripped_walk(rays, |ray| kd.1.intersect(mesh, ray)), silent_walk(&kd.0, mesh, rays)),
            ("bvh", stripped_walk(rays, |ray| bvh.1.intersect(mesh, ray)), silent_walk(&bvh.0, mesh, rays)),
        ]
    }

    /// For each structure its name and the walks observed by `Cost` and by a trace.
    fn watched(&self) -> [(&'static str, Walk<'_>, Walk<'_>); 3] {
        let Stage { mesh, rays, grid, kd, bvh } = self;
        [
            ("grid", counting_walk(&grid.0, mesh, rays), tracing_walk(&grid.0, mesh, rays)),
            ("kd", counting_walk(&kd.0, mesh, rays), tracing_walk(&kd.0, mesh, rays)),
            ("bvh", counting_walk(&bvh.0, mesh, rays), tracing_walk(&bvh.0, mesh, rays)),
        ]
    }
}

/// Rays from two sides through a raster over the box, three quarters of which meet the teapot or its floor.
fn rays(bounds: &raystep_accel::Aabb) -> Vec<Ray> {
    const ACROSS: u32 = 40;
    let (center, size) = (bounds.center(), bounds.extent().length());
    let eyes = [glam::Vec3::new(0.6, -1.0, 0.5), glam::Vec3::new(-1.0, 0.3, 0.2)].map(|eye| center + eye * size);
    let mut rays = Vec::new();
    for eye in eyes {
        for i in 0..ACROSS * ACROSS {
            let at = |k: u32| (k as f32 + 0.5) / ACROSS as f32;
            let (u, v) = (at(i % ACROSS), at(i / ACROSS));
            let target = bounds.min + bounds.extent() * glam::Vec3::new(u, 1.0 - u, v);
            rays.extend(Ray::new(eye, target - eye));
        }
    }
    rays
}

fn sum(rays: &[Ray], walk: impl Fn(&Ray) -> Option<Hit>) -> f32 {
    rays.iter().filter_map(|ray| walk(black_box(ray))).map(|hit| hit.t).sum()
}

fn stripped_walk<'a>(rays: &'a [Ray], walk: impl Fn(&Ray) -> Option<Hit> + 'a) -> Walk<'a> {
    Box::new(move || counted_stripped(rays, &walk))
}

fn silent_walk<'a>(structure: &'a impl Accel, prims: &'a impl Primitives, rays: &'a [Ray]) -> Walk<'a> {
    Box::new(move || counted_silent(rays, &|ray| structure.intersect(prims, ray, &mut ())))
}

fn counting_walk<'a>(structure: &'a impl Accel, prims: &'a impl Primitives, rays: &'a [Ray]) -> Walk<'a> {
    Box::new(move || {
        let mut cost = Cost::default();
        let answer = rays.iter().filter_map(|ray| structure.intersect(prims, ray, &mut cost)).map(|hit| hit.t).sum();
        black_box(cost);
        answer
    })
}

fn tracing_walk<'a>(structure: &'a impl Accel, prims: &'a impl Primitives, rays: &'a [Ray]) -> Walk<'a> {
    Box::new(move || {
        sum(rays, |ray| {
            let mut trace: Trace<Visit> = Trace::new(100_000);
            let hit = structure.intersect(prims, ray, &mut trace);
            black_box(trace);
            hit
        })
    })
}

/// Instructions are counted in here.
#[inline(never)]
fn counted_stripped(rays: &[Ray], walk: &impl Fn(&Ray) -> Option<Hit>) -> f32 {
    sum(rays, walk)
}

/// Instructions are counted in here.
#[inline(never)]
fn counted_silent(rays: &[Ray], walk: &impl Fn(&Ray) -> Option<Hit>) -> f32 {
    sum(rays, walk)
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let asked = |word: &str| arguments.iter().any(|argument| argument == word);
    let stage = Stage::new();
    if let [walk, structure, copy] = arguments.iter().map(String::as_str).collect::<Vec<_>>()[..]
        && walk == instructions::WALK
    {
        // Under valgrind, started by the branch below.
        instructions::walk(&stage, structure, copy);
        return;
    }
    for (structure, stripped, silent) in stage.pairs() {
        assert_eq!(stripped().to_bits(), silent().to_bits(), "the stripped {structure} answers differently");
    }
    if asked("--instructions") {
        instructions::table();
    } else {
        let rounds = if asked("--test") { 2 } else { 200 };
        rounds::table(&stage, rounds);
        let mut criterion = Criterion::default().configure_from_args();
        for ((structure, stripped, silent), (_, counting, tracing)) in stage.pairs().into_iter().zip(stage.watched()) {
            let mut group = criterion.benchmark_group(structure);
            for (name, walk) in [("stripped", stripped), ("()", silent), ("Cost", counting), ("trace", tracing)] {
                group.bench_function(name, |bencher| bencher.iter(&walk));
            }
        }
        criterion.final_summary();
    }
}
