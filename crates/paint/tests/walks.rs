//! Walks on the GPU answer as brute force does. Steps aside where no driver answers, unless `RAYSTEP_REQUIRE_GPU=1`.

use std::time::Instant;

use glam::{Vec2, Vec3};
use raystep_accel::{Accel, Hit, List, Mesh, Prims, Random, Ray, Shape, Want, pinhole};
use raystep_fast::{Bvh2, Fast, Settings, Work};
use raystep_paint::compute::{Fault, Gpu, Judged, Walker};
use raystep_scene::trial::rays::Targets;
use raystep_scene::trial::scenes::cases;
use raystep_scene::{Scene, View};

/// A device, or nothing and a line that says so.
fn gpu() -> Option<Gpu> {
    match Gpu::new() {
        Ok(gpu) => Some(gpu),
        Err(none) if std::env::var("RAYSTEP_REQUIRE_GPU").as_deref() == Ok("1") => panic!("{none}"),
        Err(none) => {
            println!("stepping aside: {none}");
            None
        }
    }
}

/// The triangles of a scene.
fn mesh(prims: &Prims) -> Mesh {
    let mut mesh = Mesh::default();
    match prims {
        Prims::Mesh(own) => mesh = own.clone(),
        Prims::Few(shapes) => {
            for shape in shapes {
                if let Shape::Triangle(triangle) = shape {
                    let first = mesh.corners.len() as u32;
                    mesh.corners.extend([triangle.a, triangle.b, triangle.c]);
                    mesh.triangles.push([first, first + 1, first + 2]);
                }
            }
        }
        Prims::Instances(_) => {}
    }
    mesh
}

fn bits(hit: Option<Hit>) -> Option<(u32, u32)> {
    hit.map(|hit| (hit.t.to_bits(), hit.prim.0))
}

/// Asks rays on the GPU; the answers must be those of `right`. How much was left to the CPU, of both questions.
fn check(name: &str, walker: &Walker<'_>, rays: &[Ray], right: &[Option<Hit>]) -> [Judged; 2] {
    let (found, nearest) = walker.nearest(rays).unwrap_or_else(|fault| panic!("{name}: {fault}"));
    assert_eq!([found.len(), right.len()], [rays.len(); 2], "{name}");
    for (i, (found, right)) in found.iter().zip(right).enumerate() {
        assert!(bits(*found) == bits(*right), "{name}, ray {i}: {found:?} instead of {right:?}\n{:?}", rays[i]);
    }
    let (found, any) = walker.any(rays).unwrap_or_else(|fault| panic!("{name}: {fault}"));
    for (i, (found, right)) in found.iter().zip(right).enumerate() {
        assert!(*found == right.is_some(), "{name}, ray {i}: any = {found}, hit = {right:?}\n{:?}", rays[i]);
    }
    [nearest, any]
}

/// Rays that touch something exactly, as many as are asked for.
fn trial(prims: &Prims, seed: u64, many: u32) -> Vec<Ray> {
    let targets = Targets::of(prims, false, &[]);
    let random = &mut Random::new(seed);
    (0..many).filter_map(|i| targets.ray(prims, i, random)).collect()
}

/// A picture as wide as high, row by row.
fn picture(view: &View, side: u32) -> Vec<Ray> {
    let pixel = |number: u32| {
        let at = (Vec2::new((number % side) as f32, (number / side) as f32) + 0.5) / side as f32 * 2.0 - 1.0;
        pinhole(view.eye, view.target, view.up, view.fov_degrees, at, 1.0).expect("the view is a view")
    };
    (0..side * side).map(pixel).collect()
}

/// From anywhere in a box in any direction.
fn anywhere(low: Vec3, high: Vec3, many: u32) -> Vec<Ray> {
    let random = &mut Random::new(5);
    let mut vector = || Vec3::new(random.unit(), random.unit(), random.unit());
    (0..many)
        .filter_map(|_| Ray::new(low + (high - low) * vector(), (vector() * 2.0 - 1.0).normalize_or_zero()).ok())
        .collect()
}

/// So many rays of each trial scene; `RAYSTEP_WALKS` asks for more.
fn many() -> u32 {
    std::env::var("RAYSTEP_WALKS").map_or(1000, |many| many.parse().expect("RAYSTEP_WALKS is a number"))
}

#[test]
fn trials_agree_with_brute_force() {
    let Some(gpu) = gpu() else { return };
    let (mut shot, mut hits, mut on_cpu) = (0, 0, 0);
    for (case, seed) in cases().into_iter().filter(|case| !case.flat).zip(1..) {
        let mesh = mesh(&case.prims);
        let tree = Bvh2::build(&mesh, &Settings::default());
        let walker = Walker::new(&gpu, &mesh, &tree).unwrap();
        let prims = Prims::Mesh(mesh.clone());
        let rays = trial(&prims, seed, many());
        let right: Vec<_> = rays.iter().map(|ray| List.intersect(&prims, ray, &mut ())).collect();
        let [nearest, _] = check(&case.name, &walker, &rays, &right);
        shot += rays.len();
        hits += right.iter().flatten().count();
        on_cpu += nearest.on_cpu;
    }
    println!("{}: {shot} rays, {hits} hit, {on_cpu} walked on the CPU", gpu.adapter);
    assert!(hits > shot / 5, "too few of {shot} rays hit anything: {hits}");
    assert!(on_cpu < shot * 9 / 10, "too few of {shot} rays are walked on the GPU: all but {on_cpu}");
}

#[test]
fn the_teapot_agrees() {
    let Some(gpu) = gpu() else { return };
    let scene = Scene::named("teapot-6321").unwrap();
    let mesh = mesh(&scene.prims);
    let tree = Bvh2::build(&mesh, &Settings::default());
    let walker = Walker::new(&gpu, &mesh, &tree).unwrap();
    println!("{}, {} bytes there", gpu.adapter, walker.bytes());
    let bounds = scene.bounds();
    for (name, rays, mostly) in [
        ("primary", picture(&scene.close_view(), 160), true),
        ("random", anywhere(bounds.min, bounds.max, 20_000), true),
        ("trial", trial(&scene.prims, 1, 8000), false),
    ] {
        let right = tree.intersect_many(&rays);
        let hits = right.iter().flatten().count();
        assert!(hits > rays.len() / 5, "{name}: {hits}");
        let [nearest, any] = check(name, &walker, &rays, &right);
        println!("{name}: {nearest:?}, any: {any:?}");
        if mostly {
            assert!(nearest.on_cpu <= rays.len() / 1000, "{name}: {nearest:?}");
            // Hardly more is judged than is hit, and of what any hit answers hardly anything.
            assert!(nearest.triangles < hits * 11 / 10, "{name}: {nearest:?}, {hits} hits");
            assert!(any.triangles < hits / 100, "{name}: {any:?}, {hits} hits");
        }
        let start = Instant::now();
        walker.nearest(&rays).unwrap();
        println!("{name}: {:.3} million rays a second", rays.len() as f64 / start.elapsed().as_secs_f64() / 1e6);
    }
}

#[test]
fn counts_are_those_of_the_walk() {
    let Some(gpu) = gpu() else { return };
    let scene = Scene::named("teapot-6321").unwrap();
    let mesh = mesh(&scene.prims);
    let tree = Bvh2::build(&mesh, &Settings::default());
    let walker = Walker::new(&gpu, &mesh, &tree).unwrap();
    let rays = picture(&scene.close_view(), 128);
    let (counts, _) = walker.counts(&rays, Want::Nearest).unwrap();
    let mut sums = [Work::default(); 2];
    for (ray, count) in rays.iter().zip(&counts) {
        let mut own = Work::default();
        tree.walk(ray, Want::Nearest, &mut own);
        sums[0] += own;
        sums[1] += *count;
        // The root at least.
        assert!(count.nodes >= 1 && count.boxes >= 2, "{count:?}");
    }
    println!("counted on the CPU: {:?}\non the GPU: {:?}", sums[0], sums[1]);
    for [own, there] in [[sums[0].nodes, sums[1].nodes], [sums[0].triangles, sums[1].triangles]] {
        assert!(there.abs_diff(own) <= own / 20, "{there} instead of {own}");
    }
}

#[test]
fn more_rays_than_go_there_at_once() {
    let Some(gpu) = gpu() else { return };
    let mesh = Mesh { corners: vec![Vec3::ZERO, Vec3::X, Vec3::Y], triangles: vec![[0, 1, 2]] };
    let tree = Bvh2::build(&mesh, &Settings::default());
    let walker = Walker::new(&gpu, &mesh, &tree).unwrap();
    let rays = anywhere(Vec3::splat(-1.0), Vec3::splat(1.0), 150_000);
    let right = tree.intersect_many(&rays);
    check("one triangle", &walker, &rays, &right);
    let (none, judged) = walker.nearest(&[]).unwrap();
    assert_eq!((none, judged), (Vec::new(), Judged::default()));
}

#[test]
fn a_lost_device_is_a_sentence() {
    let Some(gpu) = gpu() else { return };
    let mesh = Mesh { corners: vec![Vec3::ZERO, Vec3::X, Vec3::Y], triangles: vec![[0, 1, 2]] };
    let tree = Bvh2::build(&mesh, &Settings::default());
    let walker = Walker::new(&gpu, &mesh, &tree).unwrap();
    let rays = [Ray::new(Vec3::new(0.2, 0.2, 1.0), Vec3::NEG_Z).unwrap()];
    assert_eq!(walker.nearest(&rays).unwrap().0[0].map(|hit| hit.t), Some(1.0));
    gpu.lose();
    for lost in [walker.nearest(&rays).err(), walker.any(&rays).err(), Walker::new(&gpu, &mesh, &tree).err()] {
        let fault = lost.expect("a lost device answers nothing");
        assert!(matches!(fault, Fault::Lost(_)), "{fault:?}");
        assert_eq!(fault.to_string().lines().count(), 1, "{fault}");
    }
}
