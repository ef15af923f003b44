//! A search for counterexamples: rays and triangles for which single precision rules out what the judge accepts.
//!
//! `cargo test --release -p raystep-fast search -- --ignored --nocapture` with `RAYSTEP_PAIRS=1000000000` tries that many.

use glam::Vec3;
use raystep_accel::{Interval, Mesh, PrimId, Primitives, Random, Ray};

use super::{Four, meet};
use crate::judge::{Nearest, Shot};
use crate::lanes::{Isa, dispatch};

/// Of any size, anywhere near the origin or far from it.
fn triangle(random: &mut Random, corners: &mut Vec<Vec3>) {
    let far = 10f32.powi(random.below(9) as i32 - 3);
    let size = far * 10f32.powi(-(random.below(8) as i32));
    let mut point =
        |size: f32| Vec3::new(random.range(-size, size), random.range(-size, size), random.range(-size, size));
    let (at, along) = (point(far), point(size));
    let mut b = at + along;
    // A third of them slivers, a third across an axis.
    let mut c = at + point(size);
    match corners.len() / 3 % 3 {
        1 => c = at + along * point(1.0).x + point(size * 1e-4),
        2 => (b.z, c.z) = (at.z, at.z),
        _ => {}
    }
    corners.extend([at, b, c]);
}

/// A ray that passes a triangle close to its edges and corners, or along its plane, or somewhere else.
fn ray(random: &mut Random, mesh: &Mesh, number: u32) -> Option<Ray> {
    let triangle = mesh.triangle(PrimId(random.below(mesh.triangles.len() as u32)));
    let (a, b, c) = (triangle.a, triangle.b, triangle.c);
    let size = (b - a).abs().max((c - a).abs()).max_element();
    let mut point =
        |size: f32| Vec3::new(random.range(-size, size), random.range(-size, size), random.range(-size, size));
    let weights = point(1.0).abs();
    let at = match number % 8 {
        0 => a,
        1 => a + (b - a) * weights.x,
        2 => b + (c - b) * weights.x,
        3 => a + (b - a) * weights.x + point(size * 1e-6),
        _ => a + ((b - a) * weights.x + (c - a) * (1.0 - weights.x)) * weights.y,
    };
    let away = size * 10f32.powf(point(1.0).x * 5.0);
    let mut d = match number / 8 % 6 {
        0 => (b - a) * weights.z + (c - a) * weights.x,
        1 => Vec3::AXES[(number % 3) as usize],
        2 => (b - a) * weights.z + (c - a) * weights.x + point(size * 1e-5),
        _ => point(1.0),
    };
    d *= away / d.abs().max_element();
    let o = at - d;
    // Of any length.
    d *= 10f32.powi(number as i32 % 7 - 3);
    if number.is_multiple_of(11) {
        d.x *= 1e-12;
    }
    Ray::new(o, d).ok()
}

fn search(pairs: u64, seed: u64) -> [u64; 3] {
    let random = &mut Random::new(seed);
    let [mut tried, mut hits, mut passed] = [0; 3];
    while tried < pairs {
        let mut corners = Vec::new();
        for _ in 0..4 {
            triangle(random, &mut corners);
        }
        let mesh = Mesh { corners, triangles: (0..4).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect() };
        let reach = mesh.corners.iter().map(|corner| corner.abs().max_element()).fold(0.0, f32::max);
        let four = Four::of(&mesh, &[0, 1, 2, 3]);
        for number in 0..96 {
            let Some(ray) = ray(random, &mesh, number) else { continue };
            let Ok(shot) = Shot::new(&ray, reach) else { continue };
            for isa in Isa::all() {
                let left = dispatch!(isa, meet::left(&four, &shot, ray.t_max));
                let mut nearest = Nearest::before(ray.t_max);
                dispatch!(isa, meet::judge(&four, &shot, 15, &mut nearest));
                let mut right = Nearest::before(ray.t_max);
                for prim in 0..4 {
                    let found = mesh.intersect(PrimId(prim), &ray);
                    if let Some(t) = found {
                        right.offer(t, prim);
                        assert!(left >> prim & 1 == 1, "ruled out in {isa}: {ray:?} {:?}", mesh.triangle(PrimId(prim)));
                        // Nor where the ray ends there, or begins.
                        let ends = dispatch!(isa, meet::left(&four, &shot, t));
                        let from = ray.within(t, ray.t_max).expect("a range");
                        let shot_from = Shot::new(&from, reach).expect("as ordinary as before");
                        let begins = dispatch!(isa, meet::left(&four, &shot_from, ray.t_max));
                        assert!(
                            (ends & begins) >> prim & 1 == 1,
                            "{isa}: {t} {ray:?} {:?}",
                            mesh.triangle(PrimId(prim))
                        );
                        enclosed(&shot, &mesh, PrimId(prim), t);
                        hits += 1;
                    }
                }
                let bits = |nearest: Nearest| nearest.hit().map(|hit| (hit.t.to_bits(), hit.prim));
                assert_eq!(bits(nearest), bits(right), "judged otherwise in {isa}: {ray:?} {mesh:?}");
                tried += 4;
                passed += u64::from(left.count_ones());
            }
        }
    }
    [tried, hits, passed]
}

/// A hit lies in its own box as lanes see it, with products that are fused and that are not.
fn enclosed(shot: &Shot<'_>, mesh: &Mesh, prim: PrimId, t: f32) {
    let bounds = mesh.bounds(prim);
    for axis in 0..3 {
        let (low, high) = (bounds.min[axis], bounds.max[axis]);
        let (near, far) = if shot.down[axis] { (high, low) } else { (low, high) };
        let (r, enter, leave) = (shot.r[axis], shot.enter[axis], shot.leave[axis]);
        for within in [
            Interval::new(near.mul_add(r, enter), far.mul_add(r, leave)),
            Interval::new(near * r + enter, far * r + leave),
        ] {
            assert!(within.contains(t), "{t} is outside {within:?}: {:?} {bounds:?}", shot.ray);
        }
    }
}

#[test]
fn single_precision_rules_out_nothing_that_counts() {
    let [tried, hits, passed] = search(400_000, 1);
    assert!(hits > tried / 12 && passed < tried * 9 / 10, "{tried} pairs, {hits} hits, {passed} before the judge");
}

#[test]
#[ignore = "a search: as many pairs as RAYSTEP_PAIRS says"]
fn search_for_counterexamples() {
    let pairs = std::env::var("RAYSTEP_PAIRS").ok().and_then(|pairs| pairs.parse().ok()).unwrap_or(10_000_000u64);
    let pieces = pairs.div_ceil(1_000_000);
    let mut all = [0; 3];
    for piece in 0..pieces {
        let found = search(pairs / pieces, 1000 + piece);
        (0..3).for_each(|i| all[i] += found[i]);
        if piece % 10 == 9 || piece + 1 == pieces {
            println!("{} pairs, {} hits, {} before the judge: no counterexample", all[0], all[1], all[2]);
        }
    }
}
