//! Rays and points against shapes, judged by slow double precision: how deep a point lies, and sampling.

use glam::{DVec3, Quat, Vec3};
use raystep_accel::*;

fn point(random: &mut Random, size: f32) -> Vec3 {
    Vec3::new(random.range(-size, size), random.range(-size, size), random.range(-size, size))
}

fn turned(random: &mut Random) -> [Vec3; 3] {
    let turn = Quat::from_axis_angle(point(random, 1.0).normalize_or(Vec3::X), random.range(0.0, 6.0));
    Vec3::AXES.map(|axis| turn * axis)
}

/// A shape of each kind that has an inside, somewhere near the origin.
fn solids(random: &mut Random) -> [Shape<'static>; 5] {
    let half = Vec3::new(random.range(0.2, 1.5), random.range(0.2, 1.5), random.range(0.2, 1.5));
    let (center, along) = (point(random, 1.0), point(random, 1.0).normalize_or(Vec3::Y) * random.range(0.5, 3.0));
    let radius = random.range(0.2, 1.5);
    [
        Shape::Sphere(Sphere { center, radius }),
        Shape::Cylinder(Cylinder { from: center - along * 0.5, to: center + along * 0.5, radius }),
        Shape::Cone(Cone { apex: center + along * 0.5, base: center - along * 0.5, radius }),
        Shape::Box(Aabb::new(center - half, center + half)),
        Shape::Obb(Obb { center, axes: turned(random), half }),
    ]
}

/// How deep a point lies inside, negative outside; near the surface about the distance from it.
fn depth(shape: &Shape<'_>, p: DVec3) -> f64 {
    let round = |from: Vec3, to: Vec3, radius: &dyn Fn(f64) -> f64| {
        let (from, axis) = (from.as_dvec3(), to.as_dvec3() - from.as_dvec3());
        let (length, along) = (axis.length(), axis.normalize());
        let height = (p - from).dot(along);
        let out = (p - from).cross(along).length();
        (radius(height / length) - out).min(height).min(length - height)
    };
    match shape {
        Shape::Sphere(s) => f64::from(s.radius) - p.distance(s.center.as_dvec3()),
        Shape::Cylinder(c) => round(c.from, c.to, &|_| f64::from(c.radius)),
        Shape::Cone(c) => round(c.apex, c.base, &|height| f64::from(c.radius) * height),
        Shape::Box(b) => (p - b.min.as_dvec3()).min(b.max.as_dvec3() - p).min_element(),
        Shape::Obb(o) => {
            let f = p - o.center.as_dvec3();
            (0..3).map(|i| f64::from(o.half[i]) - f.dot(o.axes[i].as_dvec3()).abs()).fold(f64::INFINITY, f64::min)
        }
        _ => unreachable!("no solid"),
    }
}

fn holds(shape: &Shape<'_>, p: Vec3) -> bool {
    Body::Point(p).meets(&Body::Shape(*shape), &mut ()).unwrap()
}

#[test]
fn a_point_is_inside_where_it_has_depth() {
    let random = &mut Random::new(1);
    let mut inside = 0;
    for _ in 0..4000 {
        for shape in solids(random) {
            let p = point(random, 2.0);
            let depth = depth(&shape, p.as_dvec3());
            inside += u32::from(depth > 0.0);
            assert!(depth.abs() < 1e-5 || holds(&shape, p) == (depth > 0.0), "{shape:?} {p} {depth}");
        }
    }
    assert!(inside > 500, "{inside}");
}

#[test]
fn a_ray_meets_a_solid_where_it_first_has_depth() {
    let random = &mut Random::new(2);
    let mut hits = 0;
    for _ in 0..3000 {
        for shape in solids(random) {
            let (o, to) = (point(random, 4.0), point(random, 2.0));
            let Ok(ray) = Ray::new(o, to - o) else { continue };
            let at = |t: f64| ray.o.as_dvec3() + ray.d.as_dvec3() * t;
            let starts_inside = depth(&shape, o.as_dvec3()) > 0.0;
            let hit = shape.intersect(&ray);
            let end = f64::from(hit.unwrap_or(6.0));
            hits += u32::from(hit.is_some());
            if let Some(t) = hit {
                assert!(depth(&shape, at(t.into())).abs() < 1e-5 * (1.0 + f64::from(t)), "{shape:?} {ray:?} {t}");
            }
            for i in 0..300 {
                let deep = depth(&shape, at(end * f64::from(i) / 300.0));
                // Until the hit it stays on the side on which it starts.
                assert!(if starts_inside { deep > -1e-5 } else { deep < 1e-5 }, "{shape:?} {ray:?} {hit:?} {deep}");
            }
        }
    }
    assert!(hits > 1500, "{hits}");
}

#[test]
fn a_ray_from_inside_leaves_a_solid_once_more_than_it_enters() {
    let random = &mut Random::new(3);
    for _ in 0..3000 {
        for shape in solids(random) {
            let p = point(random, 2.0);
            let Ok(ray) = Ray::new(p, point(random, 1.0)) else { continue };
            if depth(&shape, p.as_dvec3()).abs() < 1e-4 {
                continue;
            }
            let mut met = Vec::new();
            let mut rest = Some(ray);
            while let Some(t) = rest.and_then(|rest| shape.intersect(&rest)) {
                met.push(t);
                rest = ray.within(t.next_up(), f32::INFINITY).ok();
            }
            // Where it only grazes, rounding may merge the two meetings.
            if met.len() == 1 && !holds(&shape, p) {
                assert!(depth(&shape, ray.at(met[0]).as_dvec3()).abs() < 1e-4);
                continue;
            }
            assert!(met.len() <= 2);
            assert_eq!(met.len() % 2 == 1, holds(&shape, p), "{shape:?} {ray:?} {met:?}");
        }
    }
}

#[test]
fn a_ray_that_starts_close_to_a_pole_meets_the_ball_there() {
    let random = &mut Random::new(5);
    for _ in 0..4000 {
        let (center, radius) = (point(random, 10.0), random.range(0.01, 5.0));
        let ball = Shape::Sphere(Sphere { center, radius });
        for out in Vec3::AXES.into_iter().flat_map(|axis| [axis, -axis]) {
            let off = random.range(1.0, 22.0).exp2().recip();
            for o in [1.0 - off, 1.0 + off].map(|part| center + out * (radius * part)) {
                // From inside outward, from outside inward: the pole is as far away as the origin is deep or high.
                let deep = depth(&ball, o.as_dvec3());
                let d = if deep > 0.0 { out } else { -out };
                let t = ball.intersect(&Ray::new(o, d).unwrap());
                let t = t.unwrap_or_else(|| panic!("{ball:?} is not met from {o} along {d}"));
                assert!(
                    (f64::from(t) - deep.abs()).abs() <= f64::from(8.0 * f32::EPSILON * t),
                    "{ball:?} from {o}: {t}"
                );
            }
        }
    }
}

#[test]
fn a_box_around_a_solid_holds_all_of_it_and_a_clip_all_of_the_part() {
    let random = &mut Random::new(4);
    let mut kept = 0;
    for _ in 0..2000 {
        for shape in solids(random) {
            let bounds = Aabb::around([point(random, 2.0), point(random, 2.0)]);
            let (own, part) = (shape.bounds(), shape.clip(&bounds));
            assert!(part.is_empty() || (own.encloses(&part) && bounds.encloses(&part)));
            // Cut in two, it is what it is when each side is clipped by itself.
            let (axis, middle) = (Axis::ALL[kept as usize % 3], bounds.center());
            let sides = [bounds.cut(axis, middle[axis]).0, bounds.cut(axis, middle[axis]).1];
            for (half, side) in shape.clip_twice(&bounds, axis, [middle[axis]; 2]).iter().zip(sides) {
                let alone = shape.clip(&side);
                assert_eq!(half.is_empty(), alone.is_empty());
                assert!(half.is_empty() || half.padded(1e-6).encloses(&alone) && alone.padded(1e-6).encloses(half));
            }
            for _ in 0..20 {
                let p = own.center() + own.extent() * point(random, 0.6);
                if holds(&shape, p) {
                    assert!(own.padded(1e-6).contains(p));
                    assert!(!bounds.contains(p) || part.padded(1e-6).contains(p), "{shape:?} {bounds:?} {p}");
                    kept += u32::from(bounds.contains(p));
                }
            }
        }
    }
    assert!(kept > 1000);
}

/// How often an outline winds around a point of its plane, by summed angles: another way than the code's.
fn winds(corners: &[Vec3], normal: DVec3, p: DVec3) -> f64 {
    let angles = corners.iter().zip(corners.iter().cycle().skip(1)).map(|(a, b)| {
        let (a, b) = (a.as_dvec3() - p, b.as_dvec3() - p);
        normal.dot(a.cross(b)).atan2(a.dot(b))
    });
    angles.sum::<f64>() / std::f64::consts::TAU
}

#[test]
fn a_ray_meets_what_is_flat_where_the_outline_winds_around() {
    let random = &mut Random::new(5);
    let mut hits = [0; 3];
    for _ in 0..5000 {
        // A star-shaped outline in a plane of its own; its first three corners are the triangle.
        let [u, v, normal] = turned(random);
        let middle = point(random, 1.0);
        let corners: Vec<Vec3> = (0..7)
            .map(|i| {
                let angle = i as f32 * 0.897;
                middle + (u * angle.cos() + v * angle.sin()) * random.range(0.3, 2.0)
            })
            .collect();
        let [a, b, c] = [corners[0], corners[2], corners[5]];
        let o = point(random, 3.0);
        let Ok(ray) = Ray::new(o, middle + (u * random.range(-1.5, 1.5)) + v * random.range(-1.5, 1.5) - o) else {
            continue;
        };
        let corners: &'static [Vec3] = corners.leak();
        for (i, (shape, outline)) in
            [(Shape::Triangle(Triangle { a, b, c }), &[a, b, c][..]), (Shape::Polygon(Polygon { corners }), corners)]
                .into_iter()
                .enumerate()
        {
            let n = normal.as_dvec3();
            let t = n.dot(middle.as_dvec3() - o.as_dvec3()) / n.dot(ray.d.as_dvec3());
            let p = o.as_dvec3() + ray.d.as_dvec3() * t;
            let wound = winds(outline, n, p).abs();
            let hit = shape.intersect(&ray);
            // Within rounding of an edge either answer is right.
            if wound.fract() > 0.01 && wound.fract() < 0.99 || t.abs() < 1e-4 {
                continue;
            }
            assert_eq!(hit.is_some(), wound > 0.5 && t > 0.0, "{shape:?} {ray:?} {wound} {t}");
            assert_eq!(holds(&shape, p.as_vec3()), wound > 0.5, "{shape:?} {p}");
            if let Some(hit) = hit {
                hits[i] += 1;
                assert!((f64::from(hit) - t).abs() <= 1e-5 * t.max(1.0));
            }
        }
        // The plane itself is met wherever the ray does not run along it.
        let plane = Body::Plane(Plane { point: middle, normal });
        hits[2] += u32::from(Body::Ray(ray).meets(&plane, &mut ()).unwrap());
    }
    assert!(hits.iter().all(|&hits| hits > 500), "{hits:?}");
}
