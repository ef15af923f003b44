//! Two levels: instances of models answer as brute force over the same instances does.

use std::sync::Arc;

use glam::{Mat3, Vec3};
use raystep_accel::*;

fn point(random: &mut Random, size: f32) -> Vec3 {
    Vec3::new(random.range(-size, size), random.range(-size, size), random.range(-size, size))
}

fn soup(random: &mut Random, n: u32) -> Mesh {
    let mut mesh = Mesh::default();
    for i in 0..n {
        let at = point(random, 1.0);
        mesh.corners.extend([at, at + point(random, 0.4), at + point(random, 0.4)]);
        mesh.triangles.push([3 * i, 3 * i + 1, 3 * i + 2]);
    }
    mesh
}

/// A box of twelve triangles with corners at whole numbers: exact under whole transforms.
fn cube() -> Mesh {
    let corners = (0..8).map(|i| Vec3::new((i & 1) as f32, (i >> 1 & 1) as f32, (i >> 2) as f32)).collect();
    let faces = [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]];
    let triangles = faces.into_iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    Mesh { corners, triangles }
}

fn kinds() -> impl Iterator<Item = Rule> {
    Rule::KINDS.into_iter().map(|kind| Rule::default_for(kind).unwrap())
}

/// Turned, stretched, mirrored and moved.
fn anyhow(random: &mut Random) -> Transform {
    loop {
        let matrix = Mat3::from_cols(point(random, 1.0), point(random, 1.0), point(random, 1.0));
        let transform = Transform { matrix, shift: point(random, 8.0) };
        if transform.condition() < 20.0 {
            return transform;
        }
    }
}

/// Turned by a quarter and moved by whole numbers.
fn exactly(random: &mut Random) -> Transform {
    let [x, y, z] = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| if random.below(2) == 0 { axis } else { -axis });
    let matrix = match random.below(3) {
        0 => Mat3::from_cols(x, y, z),
        1 => Mat3::from_cols(y, z, x),
        _ => Mat3::from_cols(z * 2.0, x * 2.0, y * 2.0),
    };
    Transform { matrix, shift: (point(random, 6.0)).round() }
}

fn ray(random: &mut Random, scene: &Instances) -> Ray {
    let (o, kind) = (point(random, 12.0), random.below(4));
    // At a corner of some model, along an axis, or anywhere.
    let instance = PrimId(random.below(scene.len() as u32));
    let corners = &scene.model(instance).mesh.corners;
    let local = corners[random.below(corners.len() as u32) as usize];
    let target = scene.placed()[instance.index()].world_from_local.point(local);
    let d = match kind {
        0 => [Vec3::X, Vec3::NEG_Y, Vec3::Z][random.below(3) as usize],
        1 => point(random, 1.0),
        _ => target - o,
    };
    let o = if kind == 0 { target - d * 3.0 } else { o };
    Ray::new(o, d).unwrap_or(Ray::new(o, Vec3::X).unwrap())
}

/// The hit that the judge would find if it knew no boxes.
fn without_boxes(scene: &Instances, ray: &Ray) -> Option<Hit> {
    let mut best = Best::new(Want::Nearest);
    for (prim, instance) in (0..).map(PrimId).zip(scene.placed()) {
        let (mesh, local) = (&scene.model(prim).mesh, instance.local_from_world.ray(ray).unwrap());
        for inner in (0..mesh.len() as u32).map(PrimId) {
            if let Some(t) = mesh.intersect(inner, &local) {
                best.offer(Hit { t, prim, inner: Some(inner) }, &mut ());
            }
        }
    }
    best.hit
}

fn check(scene: &Instances, seed: u64, rays: u32) {
    for rule in kinds() {
        let structure = Structure::build(scene, &rule, &mut ()).unwrap();
        let random = &mut Random::new(seed);
        let mut hits = 0;
        for number in 0..rays {
            let ray = ray(random, scene);
            let expected = scene.brute_force(&ray);
            assert_eq!(
                expected,
                without_boxes(scene, &ray),
                "the boxes of instances, ray {number} of seed {seed}: {ray:?}"
            );
            let found = structure.intersect(scene, &ray, &mut ());
            assert_eq!(found, expected, "{} of instances, ray {number} of seed {seed}: {ray:?}", rule.kind());
            assert_eq!(structure.occluded(scene, &ray, &mut ()), expected.is_some());
            hits += u32::from(found.is_some());
        }
        assert!(hits > rays / 20, "{hits} of {rays} rays hit");
    }
}

#[test]
fn instances_answer_as_brute_force_over_them_does() {
    for seed in 0..6 {
        let random = &mut Random::new(seed);
        for below in kinds() {
            let models = [soup(random, 30), cube()].map(|mesh| Arc::new(Model::build(mesh, &below, &mut ()).unwrap()));
            let placed: Vec<_> = (0..24).map(|i| (i % 2, anyhow(random))).collect();
            check(&Instances::new(models.to_vec(), &placed).unwrap(), seed + 100, 400);
        }
    }
}

#[test]
fn instances_far_from_the_middle_answer_the_same() {
    let random = &mut Random::new(7);
    let model = Arc::new(Model::build(soup(random, 40), &Rule::default_for("bvh").unwrap(), &mut ()).unwrap());
    let far = Vec3::splat(1.5e5);
    let placed: Vec<_> =
        (0..10).map(|_| anyhow(random)).map(|t| (0, Transform { shift: t.shift + far, ..t })).collect();
    let scene = Instances::new(vec![model], &placed).unwrap();
    let grid = Structure::build(&scene, &Rule::default_for("grid").unwrap(), &mut ()).unwrap();
    for _ in 0..4000 {
        let target = far + point(random, 8.0);
        let o = far + point(random, 20.0);
        let ray = Ray::new(o, target - o).unwrap();
        assert_eq!(grid.intersect(&scene, &ray, &mut ()), scene.brute_force(&ray), "{ray:?}");
    }
}

#[test]
fn rays_from_far_away_answer_as_brute_force_does() {
    let random = &mut Random::new(11);
    let models = [soup(random, 30), cube()]
        .map(|mesh| Arc::new(Model::build(mesh, &Rule::default_for("bvh").unwrap(), &mut ()).unwrap()));
    let placed: Vec<_> = (0..24).map(|i| (i % 2, anyhow(random))).collect();
    let scene = Instances::new(models.to_vec(), &placed).unwrap();
    let structures: Vec<_> = kinds().map(|rule| (rule, Structure::build(&scene, &rule, &mut ()).unwrap())).collect();
    let (mut hits, mut beside) = (0, 0);
    for number in 0..6000 {
        // From where t comes in steps of next to nothing to where they are longer than the scene.
        let near = ray(random, &scene);
        let away = near.d.normalize() * 10f32.powf(random.range(2.0, 12.0));
        let ray = Ray::new(near.at(1.0) - away, near.d).unwrap();
        let expected = scene.brute_force(&ray);
        for (rule, structure) in &structures {
            let found = structure.intersect(&scene, &ray, &mut ());
            assert_eq!(found, expected, "{} of instances, ray {number}: {ray:?}", rule.kind());
            assert_eq!(structure.occluded(&scene, &ray, &mut ()), expected.is_some(), "{ray:?}");
        }
        hits += u32::from(expected.is_some());
        beside += u32::from(expected != without_boxes(&scene, &ray));
    }
    assert!(hits > 1000 && beside > 0, "{hits} hits, {beside} rays seem to meet what lies beside its box");
}

#[test]
fn exact_transforms_answer_as_the_flattened_scene_does() {
    for seed in 0..20 {
        let random = &mut Random::new(seed);
        let model = Arc::new(Model::build(cube(), &Rule::default_for("kd").unwrap(), &mut ()).unwrap());
        let placed: Vec<_> = (0..12).map(|_| (0, exactly(random))).collect();
        let scene = Instances::new(vec![model], &placed).unwrap();
        let structure = Structure::build(&scene, &Rule::default_for("bvh").unwrap(), &mut ()).unwrap();
        let flat = scene.flattened();
        assert_eq!(scene.triangles(), flat.len() as u64);
        for _ in 0..500 {
            // Whole numbers and halves: no rounding on the way.
            let (o, target) = ((point(random, 12.0)).round(), (point(random, 12.0) * 2.0).round() / 2.0);
            let Ok(ray) = Ray::new(o, target - o) else { continue };
            let found = structure.intersect(&scene, &ray, &mut ()).map(|hit| {
                let model = hit.inner.expect("an instance says which primitive was met");
                (hit.t, hit.prim.0 * 12 + model.0)
            });
            let expected = List.intersect(&flat, &ray, &mut ()).map(|hit| (hit.t, hit.prim.0));
            assert_eq!(found, expected, "seed {seed}: {ray:?}");
        }
    }
}

#[test]
fn the_same_answer_whoever_watches() {
    let random = &mut Random::new(3);
    let model = Arc::new(Model::build(soup(random, 30), &Rule::default_for("bvh").unwrap(), &mut ()).unwrap());
    let placed: Vec<_> = (0..12).map(|_| (0, anyhow(random))).collect();
    let scene = Instances::new(vec![model], &placed).unwrap();
    let structure = Structure::build(&scene, &Rule::default_for("bvh").unwrap(), &mut ()).unwrap();
    for _ in 0..500 {
        let ray = ray(random, &scene);
        let (mut cost, mut events): (Cost, Vec<Visit>) = Default::default();
        let hit = structure.intersect(&scene, &ray, &mut (&mut cost, &mut events));
        assert_eq!(hit, structure.intersect(&scene, &ray, &mut ()));
        let mut folded = Cost::default();
        for event in &events {
            folded.on(*event);
        }
        assert_eq!(folded, cost);
        // Each way in has its way back, and the last better hit is the answer.
        let mut inside = None;
        let mut last = None;
        for event in events {
            match event {
                Visit::Local { instance, .. } => assert_eq!(inside.replace(instance), None),
                Visit::World { instance, .. } => assert_eq!(inside.take(), Some(instance)),
                Visit::Better { prim, t, .. } => last = Some((prim, t)),
                _ => {}
            }
        }
        assert_eq!((inside, last), (None, hit.map(|hit| (hit.prim, hit.t))));
    }
}

#[test]
fn a_transform_that_flattens_is_refused() {
    let model = Arc::new(Model::build(cube(), &Rule::List, &mut ()).unwrap());
    let flat = Transform { matrix: Mat3::from_diagonal(Vec3::new(1.0, 0.0, 1.0)), shift: Vec3::ZERO };
    let nan = Transform::moved(Vec3::new(f32::NAN, 0.0, 0.0));
    let tries = [(0, Transform::IDENTITY), (0, flat), (0, nan), (3, Transform::IDENTITY)];
    let refused = |one: usize| Instances::new(vec![model.clone()], &tries[one..=one]).err().map(|(_, error)| error);
    assert_eq!(refused(0), None);
    assert_eq!(refused(1), Some(TransformError::Flat));
    assert_eq!(refused(2), Some(TransformError::NotFinite));
    assert_eq!(refused(3), Some(TransformError::Model { model: 3 }));
}

/// The way of a ray through two levels, told as text: into one instance and out again, past the one behind.
#[test]
fn a_ray_enters_instances() {
    let model = Arc::new(Model::build(cube(), &Rule::List, &mut ()).unwrap());
    let half = Transform { matrix: Mat3::from_diagonal(Vec3::splat(0.5)), shift: Vec3::new(4.0, 0.0, 0.0) };
    let turned = Transform {
        matrix: Mat3::from_cols(Vec3::new(1.0, 1.0, 0.0), Vec3::new(-1.0, 1.0, 0.0), Vec3::Z),
        shift: Vec3::ZERO,
    };
    let scene = Instances::new(vec![model], &[(0, turned), (0, half)]).unwrap();
    let structure = Structure::build(&scene, &Rule::default_for("bvh").unwrap(), &mut ()).unwrap();
    let mut events: Vec<Visit> = Vec::new();
    let ray = Ray::new(Vec3::new(-2.0, 0.25, 0.25), Vec3::new(2.0, 0.0, 0.0)).unwrap();
    structure.intersect(&scene, &ray, &mut events);
    let coarse = events.iter().filter(|event| event.grain() != Grain::Arithmetic);
    let story: String = coarse
        .map(|event| crate::spell::line(event.name(), event.fields(), |field| event.field(field)) + "\n")
        .collect();
    insta::assert_snapshot!(story);
}
