//! Grids and hierarchies of boxes answer as brute force does, bit for bit.

use glam::Vec3;
use raystep_accel::*;

fn point(random: &mut Random, size: f32) -> Vec3 {
    Vec3::new(random.range(-size, size), random.range(-size, size), random.range(-size, size))
}

/// Small triangles, some spheres, some discs, and one triangle across everything.
fn mixture(seed: u64, count: usize) -> Vec<Shape<'static>> {
    let mut random = Random::new(seed);
    let mut shapes = vec![Shape::Triangle(Triangle {
        a: Vec3::new(-9.0, -9.0, -4.0),
        b: Vec3::new(9.0, -9.0, -4.0),
        c: Vec3::new(0.0, 9.0, -4.0),
    })];
    for i in 1..count {
        let center = point(&mut random, 4.0);
        shapes.push(match i % 4 {
            0 => Shape::Sphere(Sphere { center, radius: random.range(0.0, 0.5) }),
            1 => Shape::Disc(Disc { center, normal: Vec3::Y, radius: random.range(0.0, 0.5) }),
            _ => {
                let mut corner = || (center + point(&mut random, 0.5)).round_to(8.0);
                Shape::Triangle(Triangle { a: corner(), b: corner(), c: corner() })
            }
        });
    }
    shapes
}

trait RoundTo {
    fn round_to(self, parts: f32) -> Self;
}

impl RoundTo for Vec3 {
    /// To multiples of `1 / parts`: many corners fall together, many rays run through them.
    fn round_to(self, parts: f32) -> Vec3 {
        (self * parts).round() / parts
    }
}

/// Rays from anywhere to anywhere, a third of them between lattice points, a third along an axis.
fn rays(seed: u64, count: usize) -> impl Iterator<Item = Ray> {
    let mut random = Random::new(seed);
    (0..count).filter_map(move |i| {
        let (mut o, mut to) = (point(&mut random, 6.0), point(&mut random, 5.0));
        if i % 3 > 0 {
            (o, to) = (o.round_to(2.0), to.round_to(2.0));
        }
        let mut d = to - o;
        if i % 3 == 2 {
            d[random.below(3) as usize] = 0.0;
            d[random.below(3) as usize] *= -0.0;
        }
        Ray::new(o, d).ok()
    })
}

fn rules() -> Vec<Rule> {
    let mut rules = Vec::new();
    for (kind, settings) in [
        ("grid", ["resolution=3n", "resolution=longest", "resolution=density", "prune=false", "mailbox=false"]),
        ("nested-grid", ["levels=1", "levels=2", "levels=4", "more_than=1", "prune=false"]),
        ("hashed-grid", ["resolution=3n", "resolution=longest", "resolution=density", "prune=false", "mailbox=false"]),
        ("bvh", ["split=middle", "split=median", "split=binned", "split=sweep", "order=printed"]),
    ] {
        for setting in settings {
            let (key, value) = setting.split_once('=').unwrap();
            let mut rule = Rule::default_for(kind).unwrap();
            rule.set(key, value).unwrap();
            rules.push(rule);
        }
    }
    rules
}

fn agrees(structure: &impl Accel, prims: &[Shape<'static>], what: &str) {
    for ray in rays(7, 6000) {
        let right = List.intersect(&prims, &ray, &mut ());
        assert_eq!(structure.intersect(&prims, &ray, &mut ()), right, "{what}: {ray:?}");
        assert_eq!(structure.occluded(&prims, &ray, &mut ()), right.is_some(), "{what}: {ray:?}");
    }
}

#[test]
fn every_rule_answers_as_brute_force() {
    for count in [0, 1, 2, 9, 150] {
        let shapes = mixture(count as u64, count);
        let prims = &shapes[..shapes.len().min(count)];
        for rule in rules() {
            let what = format!("{count} {rule:?}");
            agrees(&Structure::build(&prims, &rule, &mut ()).unwrap(), prims, &what);
        }
    }
}
