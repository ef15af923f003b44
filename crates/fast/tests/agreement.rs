//! Every fast structure answers exactly as brute force does, with every set of instructions.

use glam::{Vec2, Vec3};
use rayon::prelude::*;
use raystep_accel::{Aabb, Accel, Hit, List, Mesh, PrimId, Primitives, Prims, Random, Ray, Shape, pinhole};
use raystep_fast::{AnyFast, Fast, FastKind, Isa, Settings};
use raystep_scene::trial::rays::Targets;
use raystep_scene::trial::scenes::{cases, cases_of};
use raystep_scene::{Scene, trial};

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

/// Shoots rays at every fast structure over the triangles of a scene, with one set of instructions after the other; the
/// answers must be those of the list. How many were shot, and how many of them hit something.
fn check(name: &str, mesh: &Mesh, seed: u64, rays: u32) -> [u32; 2] {
    let built = |kind: FastKind, settings| {
        let one = kind.build(mesh, &settings);
        let isas = Isa::all().into_iter();
        isas.map(|isa| (format!("{}, {isa}", kind.name()), one.clone().with(isa))).collect::<Vec<_>>()
    };
    let quick = FastKind::ALL.into_iter().map(|kind| built(kind, Settings::QUICK));
    let dear = [FastKind::Bvh2, FastKind::Bvh8].into_iter().map(|kind| built(kind, Settings::DEAR));
    let structures: Vec<Vec<(String, AnyFast)>> = quick.chain(dear).collect();
    let prims = Prims::Mesh(mesh.clone());
    let targets = Targets::of(&prims, false, &[]);
    let mut random = Random::new(seed);
    let (mut shot, mut hits) = (Vec::new(), 0);
    for i in 0..rays {
        let Some(ray) = targets.ray(&prims, i, &mut random) else { continue };
        let right = List.intersect(&prims, &ray, &mut ());
        shot.push((ray, right));
        hits += u32::from(right.is_some());
        // Alone every fourth structure in turn; together, below, all of them.
        for alike in structures.iter().skip(shot.len() % 4).step_by(4) {
            let (own, structure) = &alike[shot.len() / 4 % alike.len()];
            agrees(structure, &ray, right, &format_args!("{name}, {own}, ray {i}"));
        }
    }
    // The same rays together.
    let all: Vec<Ray> = shot.iter().map(|(ray, _)| *ray).collect();
    for (i, alike) in structures.iter().enumerate() {
        let (own, structure) = &alike[(seed as usize + i) % alike.len()];
        let found = structure.intersect_many(&all);
        for (i, ((ray, right), found)) in shot.iter().zip(found).enumerate() {
            assert!(bits(found) == bits(*right), "{name}, {own} together, ray {i}: {found:?} not {right:?}\n{ray:?}");
        }
        let occluded = structure.occluded_many(&all);
        assert!(shot.iter().zip(occluded).all(|((_, right), any)| right.is_some() == any), "{name}, {own} together");
    }
    [shot.len() as u32, hits]
}

fn bits(hit: Option<Hit>) -> Option<(u32, u32)> {
    hit.map(|hit| (hit.t.to_bits(), hit.prim.0))
}

fn agrees(structure: &AnyFast, ray: &Ray, right: Option<Hit>, what: &dyn std::fmt::Display) {
    let found = structure.intersect(ray);
    assert!(bits(found) == bits(right), "{what}: {found:?} instead of {right:?}\n{ray:?}");
    let occluded = structure.occluded(ray);
    assert!(occluded == right.is_some(), "{what}: occluded = {occluded}, hit = {right:?}\n{ray:?}");
}

/// Rays of small pictures of a scene, seen from a few sides: packets walk together there.
fn check_pictures(name: &str, mesh: &Mesh, side: u32) {
    let prims = Prims::Mesh(mesh.clone());
    let bounds = (0..mesh.len() as u32).map(PrimId).fold(Aabb::EMPTY, |all, prim| all.union(mesh.bounds(prim)));
    let structures: Vec<AnyFast> = FastKind::ALL.into_iter().map(|kind| kind.build(mesh, &Settings::QUICK)).collect();
    let mut hits = 0;
    for from in [Vec3::new(1.0, -2.0, 0.7), Vec3::new(-0.3, 0.2, 0.9), Vec3::X, Vec3::new(0.0, -0.4, 0.0)] {
        let eye = bounds.center() + from * bounds.extent().length();
        // Tiles of 4 × 4.
        let pixel = |i: u32| {
            let (tile, i) = (i / 16, i % 16);
            let at = Vec2::new((tile % (side / 4) * 4 + i % 4) as f32, (tile / (side / 4) * 4 + i / 4) as f32);
            let at = (at + 0.5) / side as f32 * 2.0 - 1.0;
            pinhole(eye, bounds.center(), Vec3::new(0.1, 0.0, 1.0), 30.0, at, 1.0).unwrap()
        };
        let rays: Vec<Ray> = (0..side * side).map(pixel).collect();
        let right: Vec<_> = rays.par_iter().map(|ray| List.intersect(&prims, ray, &mut ())).collect();
        hits += right.iter().flatten().count();
        for (kind, structure) in FastKind::ALL.into_iter().zip(&structures) {
            for isa in Isa::all() {
                let found = structure.clone().with(isa).intersect_many(&rays);
                for ((ray, right), found) in rays.iter().zip(&right).zip(found) {
                    assert!(
                        bits(found) == bits(*right),
                        "{name}, {}, {isa}: {found:?} not {right:?}\n{ray:?}",
                        kind.name()
                    );
                }
            }
        }
    }
    assert!(hits > side as usize * side as usize / 4, "{name}: {hits}");
}

#[test]
fn a_million_rays_agree() {
    let cases: Vec<_> = cases().into_iter().filter(|case| !case.flat).collect();
    let meshes: Vec<(String, Mesh)> = cases.into_iter().map(|case| (case.name, mesh(&case.prims))).collect();
    // Brute force takes about the same time in each scene.
    let weight = |mesh: &Mesh| 1.0 / (mesh.len() as f64 + 40.0);
    let all: f64 = meshes.iter().map(|(_, mesh)| weight(mesh)).sum();
    let counts = meshes
        .par_iter()
        .enumerate()
        .map(|(i, (name, mesh))| check(name, mesh, i as u64 + 1, (1_050_000.0 * weight(mesh) / all) as u32));
    let [shot, hits] = counts.reduce(|| [0, 0], |a, b| [a[0] + b[0], a[1] + b[1]]);
    assert!(shot >= 1_000_000, "too few rays: {shot}");
    assert!(hits > shot / 5, "too few rays hit anything: {hits}");
}

/// `cargo test --release -p raystep-fast --test agreement -- --ignored --nocapture` with `RAYSTEP_RAYS=100000000` shoots
/// that many, at ever other scenes.
#[test]
#[ignore = "a campaign: as many rays as RAYSTEP_RAYS says"]
fn as_many_rays_as_you_like_agree() {
    let rays: u64 = std::env::var("RAYSTEP_RAYS").ok().and_then(|rays| rays.parse().ok()).unwrap_or(10_000_000);
    let (mut shot, mut hits) = (0u64, 0u64);
    for seed in 1.. {
        if shot >= rays {
            break;
        }
        let cases: Vec<_> = cases_of(seed).into_iter().filter(|case| !case.flat).collect();
        let counts = cases.par_iter().enumerate().map(|(i, case)| {
            let mesh = mesh(&case.prims);
            // Brute force takes about the same time in each.
            check(&case.name, &mesh, seed * 1000 + i as u64, 4_000_000 / (mesh.len() as u32 + 40))
        });
        let [more, hit] = counts.reduce(|| [0, 0], |a, b| [a[0] + b[0], a[1] + b[1]]);
        (shot, hits) = (shot + u64::from(more), hits + u64::from(hit));
        println!("{shot} rays, {hits} hits: all alike");
    }
}

#[test]
fn the_teapots_agree() {
    for (name, rays) in [("teapot-6321", 2000), ("stadium", 2000)] {
        let scene = Scene::named(name).unwrap();
        let [_, hits] = check(name, &mesh(&scene.prims), 1, rays);
        assert!(hits > rays / 5, "{name}: {hits}");
        check_pictures(name, &mesh(&scene.prims), 32);
    }
}

#[test]
fn threads_change_nothing() {
    let scene = Scene::named("teapot-6321").unwrap();
    let mesh = mesh(&scene.prims);
    let targets = Targets::of(&scene.prims, false, &[]);
    let mut random = Random::new(5);
    let rays: Vec<Ray> = (1..9000).step_by(3).filter_map(|i| targets.ray(&scene.prims, i, &mut random)).collect();
    for kind in FastKind::ALL {
        let answers = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| {
                let structure = kind.build(&mesh, &Settings::default());
                (structure.bytes(), structure.intersect_many(&rays), structure.occluded_many(&rays))
            })
        };
        assert_eq!(answers(1), answers(3), "{}", kind.name());
    }
}

#[test]
fn a_crowd_is_parted() {
    let case = trial::named(trial::crowd::NAME).unwrap();
    let mesh = mesh(&case.prims);
    assert_eq!(mesh.len(), 100_000);
    check(&case.name, &mesh, 1, 7);
}
