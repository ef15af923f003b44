//! Every fast structure answers exactly as brute force does, with every set of instructions.

use rayon::prelude::*;
use raystep_accel::{Accel, Hit, List, Mesh, Primitives, Prims, Random, Ray, Shape};
use raystep_fast::{AnyFast, Fast, FastKind, Isa, Settings};
use raystep_scene::trial::rays::Targets;
use raystep_scene::trial::scenes::cases;
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

/// Shoots rays at every fast structure over the triangles of a scene; the answers must be those of the list.
/// How many were shot, and how many of them hit something.
fn check(name: &str, mesh: &Mesh, seed: u64, rays: u32) -> [u32; 2] {
    let structures: Vec<(String, AnyFast)> = FastKind::ALL
        .into_iter()
        .flat_map(|kind| Isa::all().into_iter().map(move |isa| (kind, isa)))
        .map(|(kind, isa)| (format!("{}, {isa}", kind.name()), kind.build(mesh, &Settings::default()).with(isa)))
        .collect();
    let prims = Prims::Mesh(mesh.clone());
    let targets = Targets::of(&prims, false, &[]);
    let mut random = Random::new(seed);
    let (mut shot, mut hits) = (Vec::new(), 0);
    for i in 0..rays {
        let Some(ray) = targets.ray(&prims, i, &mut random) else { continue };
        let right = List.intersect(&prims, &ray, &mut ());
        shot.push((ray, right));
        hits += u32::from(right.is_some());
        for (own, structure) in &structures {
            agrees(structure, &ray, right, &format_args!("{name}, {own}, ray {i}"));
        }
    }
    // The same rays together.
    let all: Vec<Ray> = shot.iter().map(|(ray, _)| *ray).collect();
    for (own, structure) in &structures {
        let found = structure.intersect_many(&all);
        for (i, ((ray, right), found)) in shot.iter().zip(found).enumerate() {
            assert!(
                bits(found) == bits(*right),
                "{name}, {own} together, ray {i}: {found:?} instead of {right:?}\n{ray:?}"
            );
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

#[test]
fn a_million_rays_agree() {
    let cases: Vec<_> = cases().into_iter().filter(|case| !case.flat).collect();
    let each = 1_050_000 / cases.len() as u32;
    let counts =
        cases.par_iter().enumerate().map(|(i, case)| check(&case.name, &mesh(&case.prims), i as u64 + 1, each));
    let [shot, hits] = counts.reduce(|| [0, 0], |a, b| [a[0] + b[0], a[1] + b[1]]);
    assert!(shot >= 1_000_000, "too few rays: {shot}");
    assert!(hits > shot / 5, "too few rays hit anything: {hits}");
}

#[test]
fn the_teapots_agree() {
    for (name, rays) in [("teapot-6321", 3000), ("stadium", 3000)] {
        let scene = Scene::named(name).unwrap();
        let [_, hits] = check(name, &mesh(&scene.prims), 1, rays);
        assert!(hits > rays / 5, "{name}: {hits}");
    }
}

#[test]
fn a_crowd_is_parted() {
    let case = trial::named(trial::crowd::NAME).unwrap();
    let mesh = mesh(&case.prims);
    assert_eq!(mesh.len(), 100_000);
    check(&case.name, &mesh, 1, 19);
}
