//! Every structure answers exactly as brute force does: the same t, bit for bit, and the same primitive.

use glam::{Vec2, Vec3};
use rayon::prelude::*;
use raystep_accel::{Accel, Hit, PrimId, Primitives, Prims, Random, Ray, Rule, Shape, Structure, Wall};
use raystep_scene::Scene;
use raystep_tests::rays::Targets;
use raystep_tests::rules::rules;
use raystep_tests::scenes::{Case, cases};

/// Which structures of a kind a ray asks.
#[derive(Clone, Copy)]
enum Asked {
    /// All of them.
    All,
    /// One, another one for the next ray.
    InTurn,
}

/// Shoots `rays` rays at every kind of structure over the scene; the answers must be those of the list.
/// Returns how many were shot (some make no ray, as their direction is zero), and how many of them hit something.
fn check(case: &Case, seed: u64, rays: u32, asked: Asked) -> [u32; 2] {
    let structures: Vec<(&str, Structure)> = rules()
        .map(|(line, rule)| {
            let rule = if case.flat { rule.flat() } else { rule };
            (line, Structure::build(&case.prims, &rule, &mut ()).unwrap())
        })
        .collect();
    let kind = |line: &str| line.split_whitespace().next().map(str::to_owned);
    let kinds: Vec<&[(&str, Structure)]> = structures.chunk_by(|(a, _), (b, _)| kind(a) == kind(b)).collect();
    assert_eq!(kinds.len(), Rule::KINDS.len() - 1, "every kind but the judge's, its rules side by side");
    let all: Vec<&Structure> = structures.iter().map(|(_, structure)| structure).collect();
    let targets = Targets::of(&case.prims, case.flat, &all);
    let (mut random, mut turns) = (Random::new(seed), Random::new(!seed));
    let (mut shot, mut hits) = (0, 0);
    for i in 0..rays {
        let Some(ray) = targets.ray(&case.prims, i, &mut random) else { continue };
        let right = case.prims.brute_force(&ray);
        shot += 1;
        hits += u32::from(right.is_some());
        let turn = turns.bits() as usize;
        for &kind in &kinds {
            let asked = match asked {
                Asked::All => kind,
                Asked::InTurn => &kind[turn % kind.len()..][..1],
            };
            for (line, structure) in asked {
                agrees(structure, &case.prims, &ray, right, &format_args!("{}, {line}, ray {i}", case.name));
            }
        }
    }
    [shot, hits]
}

fn agrees(structure: &Structure, prims: &Prims, ray: &Ray, right: Option<Hit>, what: &dyn std::fmt::Display) {
    let bits = |hit: Option<Hit>| hit.map(|hit| (hit.t.to_bits(), hit.prim, hit.inner));
    let found = structure.intersect(prims, ray, &mut ());
    assert!(bits(found) == bits(right), "{what}: {found:?} instead of {right:?}\n{ray:?}");
    let occluded = structure.occluded(prims, ray, &mut ());
    assert!(occluded == right.is_some(), "{what}: occluded = {occluded}, hit = {right:?}\n{ray:?}");
}

#[test]
fn a_million_rays_ask_every_kind_of_structure() {
    let cases = cases();
    let each = 1_050_000 / cases.len() as u32;
    let counts = cases.par_iter().enumerate().map(|(i, case)| check(case, i as u64 + 1, each, Asked::InTurn));
    let [shot, hits] = counts.reduce(|| [0, 0], |a, b| [a[0] + b[0], a[1] + b[1]]);
    assert!(shot >= 1_000_000, "too few rays: {shot}");
    assert!(hits > shot / 5, "too few rays hit anything: {hits}");
}

#[test]
fn the_teapot_too() {
    let scene = Scene::named("teapot-6321").unwrap();
    assert_eq!(scene.prims.len(), 6321);
    check(&Case { name: scene.name, prims: scene.prims, flat: false }, 1, 1000, Asked::All);
}

#[test]
fn a_ray_that_leaves_a_box_before_its_wall_misses_the_wall() {
    // It creeps out of the wall's box at y = 0 and passes the wall's end at y = 1, less beside it than a
    // double can tell. Moved back into the box, such a meeting would lie far from the wall.
    let wall = Wall { from: Vec2::X, to: Vec2::Y, z: [-1.0, 1.0] };
    let prims = Prims::Few(vec![Shape::Wall(wall)]);
    let ray = Ray::new(Vec3::new(7.497046e-22, -8.0, 0.0), Vec3::new(-9.371307e-32, 1e-9, 0.0)).unwrap();
    assert_eq!(prims.intersect(PrimId(0), &ray), None);
}
