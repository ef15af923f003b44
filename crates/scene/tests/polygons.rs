//! Polygons of OBJ files become triangles that cover exactly what the outline winds around.

use std::fmt::Write;

use glam::{DVec2, DVec3, Vec3};
use raystep_accel::Random;
use raystep_scene::{Loaded, ObjError, read_obj};

/// A file with one polygon over these corners, which may come several times.
fn file(corners: &[Vec3], polygon: &[usize]) -> String {
    let mut text = String::new();
    for p in corners {
        let _ = writeln!(text, "v {} {} {}", p.x, p.y, p.z);
    }
    text.push('f');
    for corner in polygon {
        let _ = write!(text, " {}", corner + 1);
    }
    text.push('\n');
    text
}

/// How often an outline winds around a point, and how near to the point it passes.
fn winding(outline: &[DVec2], p: DVec2) -> (i32, f64) {
    let (mut winding, mut near) = (0, f64::INFINITY);
    for (a, b) in outline.iter().zip(outline.iter().cycle().skip(1)) {
        let (a, b) = (*a - p, *b - p);
        let left = (b - a).perp_dot(-a) > 0.0;
        if a.y <= 0.0 && b.y > 0.0 && left {
            winding += 1;
        } else if a.y > 0.0 && b.y <= 0.0 && !left {
            winding -= 1;
        }
        let along = (b - a).length_squared();
        let nearest = if along > 0.0 { a + (b - a) * ((b - a).dot(-a) / along).clamp(0.0, 1.0) } else { a };
        near = near.min(nearest.length());
    }
    (winding, near)
}

/// Reads a polygon of the plane `z = 0`, put into space by `place`, and looks at points of it: one triangle covers each
/// that the outline winds around, and none the others. The number of triangles.
fn check(about: &str, outline: &[DVec2], place: impl Fn(DVec2) -> Vec3, random: &mut Random) -> usize {
    let corners: Vec<Vec3> = outline.iter().map(|p| place(*p)).collect();
    let polygon: Vec<usize> = (0..corners.len()).collect();
    let Loaded { mesh, .. } = match read_obj(file(&corners, &polygon).as_bytes(), "a.obj", &mut |_| true) {
        Ok(loaded) => loaded,
        Err(wrong) => {
            assert_eq!(wrong.to_string(), "a.obj:1:1: no face has any area, so there is nothing to hit");
            Loaded { mesh: Default::default(), origin: DVec3::ZERO, notes: Vec::new() }
        }
    };
    // Back into the plane by the three points that `place` makes of the unit corners.
    let o = place(DVec2::ZERO).as_dvec3();
    let (x, y) = (place(DVec2::X).as_dvec3() - o, place(DVec2::Y).as_dvec3() - o);
    let seen = |corner: u32| {
        let p = mesh.corners[corner as usize].as_dvec3() - o;
        let (xx, xy, yy) = (x.dot(x), x.dot(y), y.dot(y));
        let (px, py) = (p.dot(x), p.dot(y));
        DVec2::new(px * yy - py * xy, py * xx - px * xy) / (xx * yy - xy * xy)
    };
    let triangles: Vec<[DVec2; 3]> = mesh.triangles.iter().map(|triangle| triangle.map(seen)).collect();
    let low = outline.iter().copied().fold(DVec2::INFINITY, DVec2::min);
    let high = outline.iter().copied().fold(DVec2::NEG_INFINITY, DVec2::max);
    let size = (high - low).max_element();
    for _ in 0..200 {
        let part = DVec2::new(f64::from(random.range(-0.05, 1.05)), f64::from(random.range(-0.05, 1.05)));
        let p = low + (high - low) * part;
        let (times, near) = winding(outline, p);
        if near < size * 1e-5 {
            continue;
        }
        let covered = triangles.iter().filter(|triangle| winding(&triangle[..], p).0 != 0).count();
        assert_eq!(covered, usize::from(times != 0), "{about}: {p} of {outline:?}\n{:?}", mesh.triangles);
    }
    triangles.len()
}

fn flat(p: DVec2) -> Vec3 {
    p.as_vec2().extend(0.0)
}

/// In a plane that no axis lies in.
fn slanted(p: DVec2) -> Vec3 {
    (DVec3::new(0.6, 0.48, 0.64) * p.x + DVec3::new(-0.8, 0.36, 0.48) * p.y + DVec3::new(3.0, -2.0, 1.0)).as_vec3()
}

#[test]
fn triangles_cover_what_the_outline_winds_around() {
    let mut random = Random::new(7);
    let points = |list: &[[i32; 2]]| list.iter().map(|p| DVec2::new(f64::from(p[0]), f64::from(p[1]))).collect();
    let named: [(&str, Vec<DVec2>); 12] = [
        ("bow tie", points(&[[0, 0], [2, 0], [0, 2], [2, 2]])),
        ("uneven bow tie", points(&[[0, 0], [4, 0], [0, 2], [1, 2]])),
        ("pentagram", points(&[[0, 30], [18, -24], [-29, 9], [29, 9], [-18, -24]])),
        ("hole on a bridge", points(&[[0, 0], [9, 0], [9, 9], [0, 9], [0, 0], [3, 3], [3, 6], [6, 6], [6, 3], [3, 3]])),
        ("spike", points(&[[0, 0], [4, 0], [8, 0], [4, 0], [4, 4]])),
        ("touches a corner", points(&[[0, 0], [4, 0], [2, 2], [4, 4], [0, 4], [2, 2]])),
        ("touches an edge", points(&[[0, 0], [8, 0], [8, 8], [4, 0], [0, 8]])),
        ("twice around", points(&[[0, 0], [4, 0], [0, 4], [0, 0], [4, 0], [0, 4]])),
        ("there and back", points(&[[0, 0], [4, 0], [0, 4], [0, 0], [0, 4], [4, 0]])),
        ("edges that overlap", points(&[[0, 0], [6, 0], [6, 2], [2, 2], [2, 0], [8, 0], [8, 4], [0, 4]])),
        ("a corner on every edge", points(&[[0, 0], [2, 0], [4, 0], [4, 2], [4, 4], [2, 4], [0, 4], [0, 2]])),
        ("on a line", points(&[[0, 0], [2, 2], [1, 1], [5, 5]])),
    ];
    for (name, outline) in &named {
        check(name, outline, flat, &mut random);
        check(name, outline, slanted, &mut random);
    }
    // Few places, so that corners meet, edges overlap and many cross in one point; and many.
    for n in 4..40 {
        for side in [3, 5, 9, 1 << 20] {
            for _ in 0..6 {
                let mut place = || f64::from(random.below(side));
                let outline: Vec<DVec2> = (0..n).map(|_| DVec2::new(place(), place())).collect();
                check("random", &outline, flat, &mut random);
            }
        }
    }
    // A star of a thousand corners does not cross itself; one of 61 corners crosses itself 61 · 29 times.
    let ring = |n: usize, step: usize, radius: &dyn Fn(usize) -> f64| -> Vec<DVec2> {
        let angle = |i: usize| (i * step % n) as f64 / n as f64 * std::f64::consts::TAU;
        (0..n).map(|i| DVec2::new(libm::cos(angle(i)), libm::sin(angle(i))) * radius(i)).collect()
    };
    assert_eq!(check("star", &ring(1000, 1, &|i| 1.0 + (i % 2) as f64), flat, &mut random), 998);
    assert_eq!(check("large star", &ring(3000, 1, &|i| 1.0 + (i % 2) as f64), slanted, &mut random), 2998);
    check("crossing star", &ring(61, 30, &|_| 1.0), flat, &mut random);
    check("crossing star", &ring(61, 30, &|_| 1.0), slanted, &mut random);
}

/// However an outline is made, cutting it takes hardly more than n log n steps. The reader asks whether to go on once in
/// 4096 of them; clipping ears would take millions.
#[test]
fn large_polygons_are_cut_in_few_steps() {
    let n = 30_000;
    let around = |i: usize| i as f64 / n as f64 * std::f64::consts::TAU;
    let circle: Vec<Vec3> = (0..n).map(|i| flat(DVec2::new(libm::cos(around(i)), libm::sin(around(i))))).collect();
    let teeth = (0..n).map(|i| slanted(DVec2::new(i as f64 / n as f64, (i % 2) as f64)));
    let comb: Vec<Vec3> = teeth.chain([slanted(DVec2::new(1.0, -1.0)), slanted(DVec2::new(0.0, -1.0))]).collect();
    let in_order = |corners: &[Vec3]| file(corners, &(0..corners.len()).collect::<Vec<usize>>());
    let again: Vec<usize> = (0..n).map(|i| i % 3).collect();
    let again = file(&[Vec3::ZERO, Vec3::X, Vec3::Y], &again);
    for (name, text, triangles) in [
        ("circle", in_order(&circle), n - 2),
        ("comb", in_order(&comb), n),
        ("corners that repeat", again.clone(), 1),
        ("corners that repeat, a line each", again.replace(' ', " \\\n "), 1),
    ] {
        let mut looks = 0;
        let read = read_obj(text.as_bytes(), "a.obj", &mut |_| {
            looks += 1;
            true
        });
        assert_eq!(read.unwrap().mesh.triangles.len(), triangles, "{name}");
        assert!(looks < 100, "{name}: {looks}");
    }
}

/// A polygon can be given up while it is cut, and one that crosses itself without end is left out.
#[test]
fn a_tangle_is_left_out_or_given_up() {
    let mut random = Random::new(1);
    let corners: Vec<Vec3> =
        (0..20_000).map(|_| Vec3::new(random.range(0.0, 1.0), random.range(0.0, 1.0), 0.0)).collect();
    let polygon: Vec<usize> = (0..corners.len()).collect();
    let tangle = file(&corners, &polygon);
    let mut looks = 0;
    let stopped = read_obj(tangle.as_bytes(), "a.obj", &mut |part| {
        looks += usize::from(part >= 0.8);
        looks < 20
    });
    assert_eq!((stopped.err(), looks), (Some(ObjError::Cancelled), 20));
    let read = read_obj(format!("{tangle}f 1 2 3\n").as_bytes(), "a.obj", &mut |_| true).unwrap();
    assert_eq!(read.mesh.triangles.len(), 1);
    assert_eq!(
        read.notes,
        [
            "1 polygon left out: edges of one touch or cross more than 250,000 times, or those of this file 1,000,000 times"
        ]
    );
    let alone = read_obj(tangle.as_bytes(), "a.obj", &mut |_| true);
    let says = "a.obj:1:1: edges of its polygons touch or cross more than 250,000 times, so there is nothing to hit";
    assert_eq!(alone.err().unwrap().to_string(), says);
    assert_eq!(read.mesh.corners.len(), corners.len());
}
