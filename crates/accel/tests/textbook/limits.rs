//! At both ends of the numbers: the same scene and the same rays, scaled from the smallest coordinates there are
//! to the largest that a file may hold, are answered as brute force answers them.

use glam::Vec3;
use raystep_accel::*;

/// Eight triangles, each by its three corners: far apart, above and beside each other.
const TRIANGLES: [[[f32; 3]; 3]; 8] = [
    [[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [0.0, 3.0, 0.0]],
    [[5.0, 5.0, 5.0], [6.0, 5.0, 5.0], [5.0, 6.0, 6.0]],
    [[2.0, 2.0, 4.0], [4.0, 2.0, 4.0], [2.0, 4.0, 5.0]],
    [[1.0, 4.0, 2.0], [3.0, 4.0, 2.0], [1.0, 6.0, 3.0]],
    [[4.0, 1.0, 1.0], [6.0, 1.0, 2.0], [4.0, 3.0, 1.0]],
    [[0.0, 5.0, 5.0], [2.0, 5.0, 5.0], [0.0, 6.0, 6.0]],
    [[5.0, 0.0, 5.0], [6.0, 0.0, 5.0], [5.0, 2.0, 6.0]],
    [[3.0, 3.0, 0.0], [5.0, 3.0, 1.0], [3.0, 5.0, 0.0]],
];

/// Every kind, of hierarchies every volume and every builder.
fn rules() -> Vec<Rule> {
    let settings = BvhVolume::ALL.iter().map(|volume| ("volume", volume.word()));
    let settings = settings.chain(BvhBuilder::ALL.iter().map(|builder| ("builder", builder.word())));
    let hierarchies = settings.map(|(key, word)| {
        let mut rule = Rule::default_for("bvh").unwrap();
        rule.set("leaf_size", "1").unwrap();
        rule.set(key, word).unwrap();
        rule
    });
    Rule::KINDS.into_iter().map(|kind| Rule::default_for(kind).unwrap()).chain(hierarchies).collect()
}

/// Shoots rays down at the middle of each triangle, from `above`, and a few askew: the scene is `scale` large, the
/// directions are `speed` long. Returns how many of the rays shot down hit their triangle or one above it.
fn check(scale: f32, speed: f32, above: f32) -> usize {
    let corner = |[x, y, z]: [f32; 3]| Vec3::new(x, y, z) * scale;
    let shapes = TRIANGLES.map(|corners| {
        let [a, b, c] = corners.map(corner);
        Shape::Triangle(Triangle { a, b, c })
    });
    let prims = &shapes[..];
    let rays = TRIANGLES.iter().flat_map(|corners| {
        let middle = corners.map(|at| Vec3::from(at) / 3.0).into_iter().sum::<Vec3>() * scale;
        let from = middle.with_z(above * scale);
        let askew = [Vec3::new(0.3, -0.2, -1.0), Vec3::new(1.0, 0.1, 0.0), Vec3::new(-1e-3, 1.0, -0.5)];
        std::iter::once(Ray::new(from, -Vec3::Z * speed))
            .chain(askew.map(|d| Ray::new(middle - d * (scale * 4.0), d * speed)))
    });
    let rays: Vec<Ray> = rays.collect::<Result<_, _>>().unwrap();
    let right: Vec<Option<Hit>> = rays.iter().map(|ray| List.intersect(&prims, ray, &mut ())).collect();
    for rule in rules() {
        let structure = Structure::build(&prims, &rule, &mut ()).unwrap();
        for (ray, right) in rays.iter().zip(&right) {
            let what = format!("{scale:e}, {speed:e}, {rule:?}: {ray:?}");
            assert_eq!(structure.intersect(&prims, ray, &mut ()), *right, "{what}");
            assert_eq!(structure.occluded(&prims, ray, &mut ()), right.is_some(), "{what}");
        }
    }
    right.iter().step_by(4).flatten().count()
}

#[test]
fn scales_from_the_smallest_numbers_to_those_that_a_file_may_hold() {
    for exponent in -43..=17 {
        let scale = format!("1e{exponent}").parse().unwrap();
        assert_eq!(check(scale, 1.0, 9.0), 8, "{scale:e}");
    }
    assert_eq!(check(1e18 / 6.0, 1.0, 9.0), 8);
}

#[test]
fn directions_of_any_length() {
    // As short and as long as they can be for a t that is a number and not zero.
    for (scale, speed) in [
        (1e-9, 1e-43),
        (1e-15, 1e-44),
        (1e-30, 1e-43),
        (1e-43, 1e-43),
        (1.0, 1e-36),
        (1.0, 1e38),
        (1e-30, 1e9),
        (1e-38, 1e5),
        (1e17, 1e-19),
        (1e17, 1e38),
    ] {
        assert_eq!(check(scale, speed, 9.0), 8, "{scale:e}, {speed:e}");
    }
}

#[test]
fn origins_as_far_away_as_numbers_go() {
    // Triangles so far away are too small to be met; volumes and cells must not break on the way.
    for (scale, above) in [(1.0, 1e10), (1.0, 1e20), (1.0, 3e38), (1e17, 1e4), (1e17, 3e21), (1e-30, 1e30)] {
        check(scale, 1.0, above);
    }
    // A ball is met from anywhere, but only straight along an axis: at 10²⁰ times its size an f32 aims no better.
    for (size, away) in [(1.0, 1e6), (1e-30, 1e30), (1e17, 3e38), (1.0, 1e19), (1.0, 1e25), (1.0, 3e38)] {
        let balls = [1.0, 3.0].map(|x| Shape::Sphere(Sphere { center: Vec3::X * (x * size), radius: size }));
        let ray = Ray::new(Vec3::new(size, 0.0, away), -Vec3::Z).unwrap();
        let right = List.intersect(&&balls[..], &ray, &mut ());
        assert_eq!(right.map(|hit| hit.prim), Some(PrimId(0)), "{size:e}, {away:e}");
        for rule in rules() {
            let structure = Structure::build(&&balls[..], &rule, &mut ()).unwrap();
            assert_eq!(structure.intersect(&&balls[..], &ray, &mut ()), right, "{size:e}, {away:e}, {rule:?}");
        }
    }
}

#[test]
fn costs_are_numbers_at_every_scale() {
    // A tree over the same scene is the same tree, whatever its scale: a power of two, so that nothing is rounded.
    let splits = |kind: &str, exponent: i32| {
        let scale = 2f32.powi(exponent);
        let shapes = TRIANGLES.map(|corners| {
            let [a, b, c] = corners.map(|corner| Vec3::from(corner) * scale);
            Shape::Triangle(Triangle { a, b, c })
        });
        let mut events: Vec<Grow> = Vec::new();
        let mut rule = Rule::default_for(kind).unwrap();
        if kind == "bvh" {
            rule.set("leaf_size", "1").unwrap();
        }
        Structure::build(&&shapes[..], &rule, &mut events).unwrap();
        let costs = events.iter().filter_map(|event| match event {
            Grow::Weigh { cost, below, above, .. } => Some((*cost, *below, *above)),
            _ => None,
        });
        costs.collect::<Vec<_>>()
    };
    for kind in ["kd", "bsp", "bvh"] {
        let right = splits(kind, 0);
        assert!(right.iter().all(|(cost, ..)| cost.is_finite()));
        for exponent in [-110, -80, -45, -30, 20, 45, 55] {
            assert_eq!(splits(kind, exponent), right, "{kind}, 2^{exponent}");
        }
    }
}
