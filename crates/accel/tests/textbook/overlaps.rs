//! Overlap tests, judged by walking from the nearest point of one object to the nearest of the other and
//! back, until the two stay where they are.

use glam::{DVec3, Quat, Vec2, Vec3};
use raystep_accel::*;

fn point(random: &mut Random, size: f32) -> Vec3 {
    Vec3::new(random.range(-size, size), random.range(-size, size), random.range(-size, size))
}

fn aabb(random: &mut Random) -> Aabb {
    Aabb::around([point(random, 2.0), point(random, 2.0)])
}

/// Every fourth one is aligned with the axes, or has no thickness.
fn obb(random: &mut Random) -> Obb {
    let turn = match random.below(4) {
        0 => Quat::IDENTITY,
        _ => Quat::from_axis_angle(point(random, 1.0).normalize_or(Vec3::X), random.range(0.0, 6.0)),
    };
    let thin = if random.below(4) == 0 { 0.0 } else { 1.0 };
    let half = Vec3::new(random.range(0.1, 1.5), random.range(0.1, 1.5), random.range(0.1, 1.0) * thin);
    Obb { center: point(random, 2.0), axes: Vec3::AXES.map(|axis| turn * axis), half }
}

/// The point of a body nearest to `p`.
fn nearest(shape: &Shape<'_>, p: DVec3) -> DVec3 {
    match shape {
        Shape::Sphere(s) => {
            let (center, r) = (s.center.as_dvec3(), f64::from(s.radius));
            center + (p - center).clamp_length_max(r)
        }
        Shape::Box(b) => p.clamp(b.min.as_dvec3(), b.max.as_dvec3()),
        Shape::Obb(o) => {
            let f = p - o.center.as_dvec3();
            (0..3).fold(o.center.as_dvec3(), |at, i| {
                let (axis, half) = (o.axes[i].as_dvec3(), f64::from(o.half[i]));
                at + axis * f.dot(axis).clamp(-half, half)
            })
        }
        Shape::Triangle(t) => {
            // Inside the three edges' planes, or on one of the edges.
            let [a, b, c] = [t.a, t.b, t.c].map(Vec3::as_dvec3);
            let n = (b - a).cross(c - a).normalize();
            let flat = p - n * n.dot(p - a);
            if Body::Point(flat.as_vec3()).meets(&Body::Shape(*shape), &mut ()) == Some(true) {
                return flat;
            }
            let on_edge = |from: DVec3, to: DVec3| {
                from + (to - from) * ((p - from).dot(to - from) / (to - from).length_squared()).clamp(0.0, 1.0)
            };
            let edges = [on_edge(a, b), on_edge(b, c), on_edge(c, a)];
            edges.into_iter().min_by(|x, y| x.distance_squared(p).total_cmp(&y.distance_squared(p))).unwrap()
        }
        _ => unreachable!("not a body of these tests"),
    }
}

/// How far two convex bodies are apart (alternating projections, von Neumann 1933).
fn gap(first: &Shape<'_>, second: &Shape<'_>) -> f64 {
    let mut p = DVec3::ZERO;
    let mut gap = 0.0;
    for _ in 0..3000 {
        let q = nearest(first, p);
        p = nearest(second, q);
        gap = p.distance(q);
        if gap < 1e-9 {
            break;
        }
    }
    gap
}

/// Holds the answers for two bodies against the referee; both answers must come up.
fn check(seed: u64, mut pair: impl FnMut(&mut Random) -> [Shape<'static>; 2]) {
    let random = &mut Random::new(seed);
    let mut both = [0; 2];
    for _ in 0..1500 {
        let [first, second] = pair(random);
        let touch = Body::Shape(first).meets(&Body::Shape(second), &mut ()).unwrap();
        let gap = gap(&first, &second);
        both[usize::from(touch)] += 1;
        // The walk comes near a touch slowly: in between it cannot tell.
        if touch {
            assert!(gap < 2e-2, "{first:?} {second:?} said to meet, {gap} apart");
        } else {
            assert!(gap > 1e-6, "{first:?} {second:?} said to be apart, but they meet");
        }
        // In the other order the answer is the same.
        if std::mem::discriminant(&first) == std::mem::discriminant(&second) {
            assert_eq!(Body::Shape(second).meets(&Body::Shape(first), &mut ()), Some(touch));
        }
        // What is apart has no point in common.
        let p = second.bounds().center();
        for _ in 0..if touch { 0 } else { 20 } {
            let q = (p + second.bounds().extent() * point(random, 0.5)).as_dvec3();
            let (a, b) = (nearest(&first, q), nearest(&second, q));
            assert!(a.distance(q) > 1e-7 || b.distance(q) > 1e-7, "{first:?} {second:?} share {q}");
        }
    }
    assert!(both.iter().all(|&count| count > 100), "{both:?}");
}

#[test]
fn a_ball_and_a_box() {
    let ball = |random: &mut Random| Sphere { center: point(random, 2.0), radius: random.range(0.0, 1.0) };
    check(1, |random| [Shape::Sphere(ball(random)), Shape::Box(aabb(random))]);
}

#[test]
fn two_boxes() {
    check(2, |random| [Shape::Box(aabb(random)), Shape::Box(aabb(random))]);
}

#[test]
fn two_oriented_boxes() {
    check(3, |random| [Shape::Obb(obb(random)), Shape::Obb(obb(random))]);
}

#[test]
fn a_triangle_and_a_box() {
    let triangle = |random: &mut Random| {
        let a = point(random, 2.0);
        Triangle { a, b: a + point(random, 1.5), c: a + point(random, 1.5) }
    };
    check(4, |random| [Shape::Triangle(triangle(random)), Shape::Box(aabb(random))]);
}

#[test]
fn oriented_boxes_along_the_axes_are_boxes() {
    let random = &mut Random::new(5);
    // On a lattice, so that many touch exactly.
    let mut corner = || (point(random, 2.0) * 2.0).round() / 2.0;
    for _ in 0..3000 {
        let (a, b) = (Aabb::around([corner(), corner()]), Aabb::around([corner(), corner()]));
        let turned = Obb::from_aabb(&a).overlaps(&Obb::from_aabb(&b), &mut ());
        assert_eq!(turned, a.touches(&b), "{a:?} {b:?}");
        assert_eq!(a.touches(&b), !a.intersection(b).is_empty());
    }
}

#[test]
fn a_shadow_between_two_that_are_apart_shows_the_gap() {
    let random = &mut Random::new(6);
    for _ in 0..2000 {
        let (a, b) = (obb(random), obb(random));
        let mut steps = Steps::default();
        let touch = a.overlaps(&b, &mut steps);
        for step in &steps.0 {
            let Step::Probe(Probe::Shadow { x, y, z, a_low, a_high, b_low, b_high, apart, .. }) = *step else {
                panic!("no shadow: {step:?}")
            };
            let along = Vec3::new(x, y, z);
            // The shadows are those of the corners, seen from the middle of the first.
            let shadow = |solid: &Obb| {
                let seen = solid.corners().map(|corner| along.dot(corner - a.center));
                (seen.into_iter().fold(f32::INFINITY, f32::min), seen.into_iter().fold(f32::NEG_INFINITY, f32::max))
            };
            let near = |(low, high): (f32, f32), l: f32, h: f32| (low - l).abs() < 1e-4 && (high - h).abs() < 1e-4;
            assert!(near(shadow(&a), a_low, a_high) && near(shadow(&b), b_low, b_high));
            assert_eq!(apart, a_high < b_low || b_high < a_low);
        }
        let last_apart = matches!(steps.0.last(), Some(Step::Probe(Probe::Shadow { apart: true, .. })));
        assert_eq!(last_apart, !touch);
    }
}

#[test]
fn a_plane_and_a_box_by_its_corners() {
    let random = &mut Random::new(7);
    for _ in 0..3000 {
        let (plane, bounds) = (Plane { point: point(random, 1.0), normal: point(random, 3.0) }, aabb(random));
        let corners = Obb::from_aabb(&bounds).corners();
        let inside = corners.iter().filter(|corner| plane.holds(**corner, &mut ())).count();
        let cover = plane.side(&bounds, &mut ());
        match inside {
            8 => assert_eq!(cover, Cover::Inside),
            0 => assert_eq!(cover, Cover::Outside),
            _ => assert_eq!(cover, Cover::Across),
        }
    }
}

#[test]
fn a_frustum_and_a_box_by_their_points() {
    let random = &mut Random::new(8);
    let mut covers = [0; 3];
    for _ in 0..1500 {
        let eye = point(random, 3.0);
        let slope = Vec2::new(random.range(0.2, 1.0), random.range(0.2, 1.0));
        let frustum = Frustum::new(eye, -eye.normalize_or(Vec3::X), Vec3::new(0.1, 1.0, 0.2), slope, [0.5, 6.0]);
        let middle = frustum.corners.iter().sum::<Vec3>() / 8.0;
        // Its own corners lie on its planes, its middle inside.
        for corner in frustum.corners {
            assert!(frustum.holds(corner.lerp(middle, 1e-4), &mut ()));
            assert!(!frustum.holds(corner.lerp(middle, -1e-3), &mut ()));
        }
        let size = point(random, 0.7).abs();
        let at = point(random, 3.0);
        let bounds = Aabb::new(at - size, at + size);
        let cover = frustum.sees(&bounds, &mut ());
        covers[cover as usize] += 1;
        for corner in Obb::from_aabb(&bounds).corners() {
            assert!(cover != Cover::Inside || frustum.holds(corner, &mut ()));
        }
        for _ in 0..50 {
            let p = at + size * point(random, 1.0);
            assert!(cover != Cover::Outside || !frustum.holds(p, &mut ()), "{frustum:?} {bounds:?} {p}");
        }
        for corner in frustum.corners {
            assert!(cover != Cover::Outside || !bounds.padded(-1e-5).contains(corner));
        }
    }
    assert!(covers.iter().all(|&count| count > 100), "{covers:?}");
}
