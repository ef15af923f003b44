//! Forest and meadow: the same from run to run, and exact.

use raystep_accel::{Accel, Prims, Random, Ray, Rule, Structure};
use raystep_scene::{MOST_TREES, Scene, tree};

fn instances(scene: &Scene) -> &raystep_accel::Instances {
    match &scene.prims {
        Prims::Instances(instances) => instances,
        _ => panic!("{} is a scene of instances", scene.name),
    }
}

#[test]
fn trees_grow_the_same_from_the_same_seed() {
    assert_eq!(tree(11), tree(11));
    assert_ne!(tree(11), tree(12));
}

#[test]
fn a_forest_has_its_trees_and_a_floor() {
    for (name, trees) in [("forest:1", 1), ("forest:10", 10), ("forest", 1000)] {
        let scene = Scene::named(name).unwrap();
        assert_eq!(instances(&scene).placed().len(), trees + 1);
        assert!(instances(&scene).triangles() > trees as u64 * 10_000);
    }
    for wrong in ["forest:0", "forest:x", &format!("forest:{}", MOST_TREES + 1)] {
        let error = Scene::named(wrong).unwrap_err().to_string();
        assert_eq!(error, format!("there is no scene `{wrong}`; write forest:N with N from 1 to {MOST_TREES}"));
    }
}

#[test]
fn meadow_and_forest_answer_as_brute_force_does() {
    for name in ["grass", "forest:10"] {
        let scene = Scene::named(name).unwrap();
        let structure = Structure::build(&scene.prims, &Rule::default_for("bvh").unwrap(), &mut ()).unwrap();
        let random = &mut Random::new(9);
        let half = structure.bounds().extent() * 0.5;
        let mut hits = 0;
        for _ in 0..12 {
            let [x, y] = [0; 2].map(|_| random.range(-1.0, 1.0));
            let target = structure.bounds().center() + half * glam::Vec3::new(x, y, 0.0);
            let ray = Ray::new(scene.view.eye, target - scene.view.eye).unwrap();
            let found = structure.intersect(&scene.prims, &ray, &mut ());
            assert_eq!(found, instances(&scene).brute_force(&ray), "{name}: {ray:?}");
            hits += u32::from(found.is_some());
        }
        assert!(hits > 3, "{name}: {hits} hits");
    }
}
