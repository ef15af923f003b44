//! Instances answer as brute force over all of them does, however they are turned, scaled, mirrored and sheared.

use std::sync::Arc;

use glam::{Mat3, Vec3};
use raystep_accel::{Hit, Instances, Mesh, Model, Prims, Random, Ray, Rule, Transform};
use raystep_fast::{Fast, Settings, TwoLevels};
use raystep_scene::{Scene, teapot, trial::rays::Targets};

fn model(mesh: Mesh) -> Arc<Model> {
    Arc::new(Model::build(mesh, &Rule::List, &mut ()).unwrap())
}

fn bits(hit: Option<Hit>) -> Option<(u32, u32, Option<u32>)> {
    hit.map(|hit| (hit.t.to_bits(), hit.prim.0, hit.inner.map(|inner| inner.0)))
}

/// Shoots rays at instances; how many hit something.
fn check(name: &str, instances: &Instances, rays: u32) -> u32 {
    let fast = TwoLevels::build(instances, &Settings::default());
    let prims = Prims::Instances(instances.clone());
    let targets = Targets::of(&prims, false, &[]);
    let (mut random, mut hits) = (Random::new(7), 0);
    let mut shot = Vec::new();
    for i in 0..rays {
        let Some(mut ray) = targets.ray(&prims, i, &mut random) else { continue };
        // Every third from further away: from where t comes in steps of next to nothing to where they are longer than all.
        let back = ray.d.normalize() * 10f32.powf(random.range(2.0, 12.0));
        if i % 3 == 0 {
            ray = Ray::new(ray.o - back, ray.d).unwrap_or(ray);
        }
        let right = instances.brute_force(&ray);
        hits += u32::from(right.is_some());
        assert_eq!(bits(fast.intersect(&ray)), bits(right), "{name}, ray {i}: {ray:?}");
        assert_eq!(fast.occluded(&ray), right.is_some(), "{name}, any, ray {i}: {ray:?}");
        shot.push((ray, right));
    }
    let together: Vec<Ray> = shot.iter().map(|(ray, _)| *ray).collect();
    for ((_, right), found) in shot.iter().zip(fast.intersect_many(&together)) {
        assert_eq!(bits(found), bits(*right), "{name}, together");
    }
    hits
}

/// Two models, placed in every way that a matrix has.
fn every_way(seed: u64) -> Instances {
    let mut random = Random::new(seed);
    let mut number = |far: f32| random.range(-far, far);
    let mut placed = Vec::new();
    for n in 0..24 {
        let mut vector = |far: f32| Vec3::new(number(far), number(far), number(far));
        let matrix = match n % 4 {
            // Scaled, mirrored, sheared, anything.
            0 => Mat3::from_diagonal(vector(2.0).abs() + 0.2),
            1 => Mat3::from_diagonal(Vec3::new(-1.0, 1.0, 0.5)),
            2 => Mat3::from_cols(Vec3::X, Vec3::new(vector(1.0).x, 1.0, 0.0), Vec3::new(0.3, vector(1.0).y, 1.0)),
            _ => Mat3::from_cols(vector(1.0), vector(1.0), vector(1.0)),
        };
        let way = Transform { matrix, shift: vector(6.0) };
        if way.inverse().is_ok() {
            placed.push((n % 3, way));
        }
    }
    // Two that lie in the same place: the one with the smaller id is met.
    placed.extend([placed[0], placed[1]]);
    Instances::new(vec![model(teapot(2)), model(teapot(1)), model(Mesh::default())], &placed).unwrap()
}

#[test]
fn placed_in_every_way() {
    for seed in 1..5 {
        let hits = check(&format!("seed {seed}"), &every_way(seed), 700);
        assert!(hits > 100, "seed {seed}: {hits}");
    }
}

#[test]
fn a_few_trees_on_a_floor() {
    let Prims::Instances(forest) = Scene::named("forest:9").unwrap().prims else { panic!("a forest has instances") };
    let hits = check("forest:9", &forest, 400);
    assert!(hits > 80, "{hits}");
}

#[test]
fn nothing_is_met_by_no_ray() {
    let ray = Ray::new(Vec3::ZERO, Vec3::X).unwrap();
    for placed in [vec![], vec![(0, Transform::IDENTITY)]] {
        let nothing = Instances::new(vec![model(Mesh::default())], &placed).unwrap();
        let fast = TwoLevels::build(&nothing, &Settings::default());
        assert_eq!((fast.intersect(&ray), fast.occluded(&ray)), (None, false));
    }
}
