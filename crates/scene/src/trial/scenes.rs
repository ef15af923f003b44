//! Scenes to disagree about: random ones, and ones that leave an algorithm nothing to stand on.

use glam::{Vec2, Vec3};
use raystep_accel::{Aabb, Cone, Cylinder, Disc, Obb, Polygon, Prims, Prism, Random, Shape, Sphere, Triangle, Wall};

/// A scene with a name to find it by.
pub struct Case {
    /// The name by which [`Scene::named`](crate::Scene::named) gives the same scene.
    pub name: String,
    /// What rays meet.
    pub prims: Prims,
    /// Whether it lives in the plane.
    pub flat: bool,
}

type Shapes = Vec<Shape<'static>>;

/// Scenes of everything, scaled and then moved on every axis, up to what a file may hold: coordinates of
/// 10¹⁸, and the smallest numbers that there are.
const SCALES: [(&str, f32, f32); 14] = [
    ("far away", 1.0, 1.5e5),
    ("further away", 20.0, 1e7),
    ("huge and as far away as can be", 1e13, 4e17),
    ("tiny and off", 1e-3, 1.0),
    ("huge", 1e9, 0.0),
    ("scaled by 1e13", 1e13, 0.0),
    ("scaled by 1e15", 1e15, 0.0),
    ("as large as can be", 4e17, 0.0),
    ("tiny", 1e-9, 0.0),
    ("scaled by 1e-15", 1e-15, 0.0),
    ("scaled by 1e-18", 1e-18, 0.0),
    ("scaled by 1e-30", 1e-30, 0.0),
    ("scaled by 1e-38", 1e-38, 0.0),
    ("as small as can be", 1e-44, 0.0),
];

/// All of them, as tests use them.
pub fn cases() -> Vec<Case> {
    cases_of(0)
}

/// All of them, the random ones drawn anew for each seed.
pub fn cases_of(seed: u64) -> Vec<Case> {
    let mut cases = Vec::new();
    let mut add = |name: &str, flat: bool, shapes: Shapes| {
        let name = format!("trial:{}:{seed}", name.replace(' ', "-"));
        cases.push(Case { name, prims: Prims::Few(shapes), flat });
    };
    // Each scene has a generator of its own.
    let seeded = |own: u64| own + 1000 * seed;
    let half = Vec3::splat(0.5);

    add("empty", false, Vec::new());
    add("one triangle", false, soup(seeded(1), 1, 1.0));
    add("one axis-aligned triangle", false, vec![triangle(Vec3::ZERO, Vec3::X, Vec3::Y)]);
    add("small triangles", false, soup(seeded(2), 150, 0.15));
    add("large triangles", false, soup(seeded(3), 40, 1.5));
    add("identical", false, vec![triangle(Vec3::ZERO, Vec3::new(1.0, 0.3, 0.2), Vec3::new(0.2, 1.0, 0.7)); 40]);
    add("each three times", false, soup(seeded(4), 30, 0.4).into_iter().flat_map(|shape| [shape; 3]).collect());
    add("in one plane", false, sheet(6, |u, v| Vec3::new(u, v, 0.25)));
    add("in one slanted plane", false, sheet(6, |u, v| Vec3::new(u, v, u + v * 0.5)));
    add("on a lattice", false, lattice(seeded(5), 60));
    add("cubes side by side", false, cubes());
    add("closed surface", false, ball(10));
    add("slivers", false, slivers(seeded(6), 60));
    add("needles through a point", false, needles(seeded(7), 50));
    add("needles of a million to one", false, fine_needles(seeded(22), 60));
    add("without area", false, without_area(seeded(8)));
    add("spheres", false, spheres(seeded(9), 40));
    add("discs", false, discs(seeded(10), 40));
    add("solids", false, solids(seeded(20), 40));
    add("one of each", false, one_of_each());
    add(
        "everything",
        false,
        [soup(seeded(11), 40, 0.4), spheres(seeded(12), 15), discs(seeded(13), 15), slivers(seeded(14), 10)].concat(),
    );
    add("from grains to worlds", false, of_all_sizes(seeded(23), 74));
    for (name, scale, offset) in SCALES {
        let shapes = [
            lattice(seeded(15), 20),
            ball(6),
            soup(seeded(16), 20, 0.4),
            spheres(seeded(17), 8),
            discs(seeded(18), 8),
            solids(seeded(21), 10),
        ]
        .concat();
        add(name, false, shapes.iter().map(|shape| moved(shape, scale, Vec3::splat(offset) + half * scale)).collect());
    }
    add("flat mixture", true, flat(seeded(19), 24));
    add("flat walls on a lattice", true, flat_walls());
    add("flat discs in a row", true, (0..12).map(|i| sphere(Vec3::new(i as f32, 0.5, 0.0), 0.5)).collect());
    cases
}

fn point(random: &mut Random, size: f32) -> Vec3 {
    Vec3::new(random.range(-size, size), random.range(-size, size), random.range(-size, size))
}

fn triangle(a: Vec3, b: Vec3, c: Vec3) -> Shape<'static> {
    Shape::Triangle(Triangle { a, b, c })
}

fn sphere(center: Vec3, radius: f32) -> Shape<'static> {
    Shape::Sphere(Sphere { center, radius })
}

fn disc(center: Vec3, normal: Vec3, radius: f32) -> Shape<'static> {
    Shape::Disc(Disc { center, normal: normal.try_normalize().unwrap_or(Vec3::Z), radius })
}

fn soup(seed: u64, n: usize, size: f32) -> Shapes {
    let random = &mut Random::new(seed);
    (0..n)
        .map(|_| {
            let at = point(random, 1.0);
            triangle(at, at + point(random, size), at + point(random, size))
        })
        .collect()
}

/// A sheet of n × n quads.
fn sheet(n: u32, at: impl Fn(f32, f32) -> Vec3) -> Shapes {
    let corner = |i: u32, j: u32| at(i as f32 / n as f32, j as f32 / n as f32);
    let quads = (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
    quads
        .flat_map(|(i, j)| {
            let [a, b, c, d] = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
            [triangle(a, b, c), triangle(a, c, d)]
        })
        .collect()
}

/// A closed surface: neighbours share corners bit for bit, so no ray may slip through.
fn ball(n: u32) -> Shapes {
    // The six faces of a cube, blown up.
    Vec3::AXES
        .into_iter()
        .flat_map(|axis| [axis, -axis])
        .flat_map(|out| {
            let (u_axis, v_axis) = (Vec3::new(out.y, out.z, out.x), Vec3::new(out.z, out.x, out.y));
            sheet(n, move |u, v| (out + u_axis * (2.0 * u - 1.0) + v_axis * (2.0 * v - 1.0)).normalize())
        })
        .collect()
}

/// Corners at multiples of a quarter: many fall together, many lie in the same planes.
fn lattice(seed: u64, n: usize) -> Shapes {
    let random = &mut Random::new(seed);
    let mut corner = || (point(random, 1.0) * 4.0).round() / 4.0;
    (0..n).map(|_| triangle(corner(), corner(), corner())).collect()
}

/// The faces of 2 × 2 × 2 cubes, shared faces twice.
fn cubes() -> Shapes {
    (0..8)
        .flat_map(|i| {
            let at = Vec3::new((i & 1) as f32, (i >> 1 & 1) as f32, (i >> 2) as f32);
            Vec3::AXES.into_iter().flat_map(move |axis| {
                let (u_axis, v_axis) = (Vec3::new(axis.y, axis.z, axis.x), Vec3::new(axis.z, axis.x, axis.y));
                [at, at + axis].into_iter().flat_map(move |at| sheet(1, move |u, v| at + u_axis * u + v_axis * v))
            })
        })
        .collect()
}

/// Long and thin, down to a few units in the last place.
fn slivers(seed: u64, n: usize) -> Shapes {
    let random = &mut Random::new(seed);
    (0..n)
        .map(|i| {
            let (a, along) = (point(random, 1.0), point(random, 1.0));
            triangle(a, a + along, a + along * random.unit() + point(random, 10f32.powi(-(i as i32 % 8))))
        })
        .collect()
}

/// Needles through one point: every box around it holds them all, so no structure can part them there.
pub fn needles(seed: u64, n: usize) -> Vec<Shape<'static>> {
    let random = &mut Random::new(seed);
    (0..n)
        .map(|_| {
            let along = point(random, 1.0).normalize();
            triangle(-along, along, along + point(random, 0.01))
        })
        .collect()
}

/// A million times as long as wide, lying anywhere.
fn fine_needles(seed: u64, n: usize) -> Shapes {
    let random = &mut Random::new(seed);
    (0..n)
        .map(|_| {
            let (from, along) = (point(random, 1.0), point(random, 1.0).normalize());
            let across = along.any_orthogonal_vector().normalize() * 1e-6;
            triangle(from, from + along, from + along * random.unit() + across)
        })
        .collect()
}

/// Triangles and balls of 10⁻¹⁸ to 10¹⁸, each about as far from the origin as it is large.
fn of_all_sizes(seed: u64, n: usize) -> Shapes {
    let random = &mut Random::new(seed);
    (0..n)
        .map(|i| {
            let size = 10f32.powi(i as i32 / 2 % 37 - 18) * 0.4;
            let at = point(random, size);
            if i % 2 == 0 {
                triangle(at, at + point(random, size), at + point(random, size))
            } else {
                sphere(at, size * random.range(0.0, 0.5))
            }
        })
        .collect()
}

/// Points, segments, spheres of radius zero, and one triangle with an area.
fn without_area(seed: u64) -> Shapes {
    let random = &mut Random::new(seed);
    let mut shapes = soup(seed, 1, 1.0);
    for _ in 0..10 {
        let (a, b) = (point(random, 1.0), point(random, 1.0));
        shapes.extend([triangle(a, a, a), triangle(a, b, a), triangle(a, b, a * 0.5 + b * 0.5)]);
        shapes.extend([sphere(b, 0.0), disc(a, b, 0.0)]);
    }
    shapes
}

fn spheres(seed: u64, n: usize) -> Shapes {
    let random = &mut Random::new(seed);
    (0..n).map(|_| sphere(point(random, 1.0), random.range(0.01, 0.4))).collect()
}

/// A third of them across an axis.
fn discs(seed: u64, n: usize) -> Shapes {
    let random = &mut Random::new(seed);
    (0..n)
        .map(|i| {
            let normal = if i % 3 == 0 { Vec3::AXES[i / 3 % 3] } else { point(random, 1.0) };
            disc(point(random, 1.0), normal, random.range(0.01, 0.4))
        })
        .collect()
}

fn cylinder(from: Vec3, to: Vec3, radius: f32) -> Shape<'static> {
    Shape::Cylinder(Cylinder { from, to, radius })
}

fn cone(apex: Vec3, base: Vec3, radius: f32) -> Shape<'static> {
    Shape::Cone(Cone { apex, base, radius })
}

fn polygon(corners: &[Vec3]) -> Shape<'static> {
    Shape::Polygon(Polygon { corners: corners.to_vec().leak() })
}

fn turned_box(center: Vec3, along: Vec3, half: Vec3) -> Shape<'static> {
    let u = along.try_normalize().unwrap_or(Vec3::X);
    let (v, w) = u.any_orthonormal_pair();
    Shape::Obb(Obb { center, axes: [u, v, w], half })
}

/// Cylinders, cones, boxes and polygons; a third of them along an axis, some without thickness.
fn solids(seed: u64, n: usize) -> Shapes {
    let random = &mut Random::new(seed);
    (0..n)
        .map(|i| {
            let at = point(random, 1.0);
            let along = if i % 3 == 0 { Vec3::AXES[i / 3 % 3] } else { point(random, 1.0) } * 0.4;
            let half = point(random, 0.3).abs() * if i % 4 == 0 { Vec3::new(1.0, 0.0, 1.0) } else { Vec3::ONE };
            match i % 5 {
                0 => cylinder(at, at + along, random.range(0.0, 0.3)),
                1 => cone(at, at + along, random.range(0.0, 0.3)),
                2 => Shape::Box(Aabb::new(at - half, at + half)),
                3 => turned_box(at, along, half),
                _ => {
                    let (u, v) = (along, along.any_orthogonal_vector() * 1.3);
                    polygon(&[at - u - v, at + u - v, at + u + v, at - v * 0.3, at - u + v])
                }
            }
        })
        .collect()
}

fn one_of_each() -> Shapes {
    vec![
        cylinder(Vec3::new(0.0, 0.0, 2.0), Vec3::new(1.0, 0.0, 2.0), 0.5),
        cone(Vec3::new(0.0, 2.0, 2.0), Vec3::new(0.0, 3.0, 2.0), 0.5),
        polygon(&[Vec3::new(2.0, 0.0, 2.0), Vec3::new(3.0, 0.0, 2.0), Vec3::new(2.5, 1.0, 2.5)]),
        Shape::Box(Aabb::new(Vec3::new(-2.0, 0.0, 0.0), Vec3::new(-1.0, 1.0, 1.0))),
        turned_box(Vec3::new(-2.0, 2.0, 0.0), Vec3::new(1.0, 1.0, 0.0), Vec3::splat(0.5)),
        triangle(Vec3::ZERO, Vec3::X, Vec3::Y),
        sphere(Vec3::new(2.0, 0.0, 0.0), 0.5),
        disc(Vec3::new(0.0, 2.0, 0.0), Vec3::new(1.0, 1.0, 0.0), 0.5),
        wall([0.0, -1.0], [1.0, -2.0]),
        prism(&[[2.0, 2.0], [3.0, 2.0], [2.5, 3.0]]),
    ]
}

/// Shapes of the plane stand this high above and below it.
const HIGH: f32 = 0.05;

fn wall(from: [f32; 2], to: [f32; 2]) -> Shape<'static> {
    Shape::Wall(Wall { from: from.into(), to: to.into(), z: [-HIGH, HIGH] })
}

fn prism(outline: &[[f32; 2]]) -> Shape<'static> {
    let outline: Vec<Vec2> = outline.iter().map(|&p| p.into()).collect();
    Shape::Prism(Prism { outline: outline.leak(), z: [-HIGH, HIGH] })
}

fn flat(seed: u64, n: usize) -> Shapes {
    let random = &mut Random::new(seed);
    (0..n)
        .map(|i| {
            let [x, y] = [random.range(0.0, 8.0), random.range(0.0, 6.0)];
            let mut near = || [x + random.range(-1.0, 1.0), y + random.range(-1.0, 1.0)];
            match i % 3 {
                0 => sphere(Vec3::new(x, y, 0.0), 0.1 + 0.05 * (i % 7) as f32),
                1 => wall(near(), near()),
                _ => prism(&[near(), near(), near(), near()]),
            }
        })
        .collect()
}

fn flat_walls() -> Shapes {
    (0..5)
        .flat_map(|i| {
            let at = i as f32;
            [wall([at, 0.0], [at, 4.0]), wall([0.0, at], [4.0, at]), wall([at, 0.0], [0.0, at])]
        })
        .collect()
}

/// Scaled about the origin, then moved.
fn moved(shape: &Shape<'static>, scale: f32, by: Vec3) -> Shape<'static> {
    let at = |p: Vec3| p * scale + by;
    match *shape {
        Shape::Triangle(Triangle { a, b, c }) => triangle(at(a), at(b), at(c)),
        Shape::Sphere(Sphere { center, radius }) => sphere(at(center), radius * scale),
        Shape::Disc(Disc { center, normal, radius }) => disc(at(center), normal, radius * scale),
        Shape::Cylinder(Cylinder { from, to, radius }) => cylinder(at(from), at(to), radius * scale),
        Shape::Cone(Cone { apex, base, radius }) => cone(at(apex), at(base), radius * scale),
        Shape::Polygon(Polygon { corners }) => polygon(&corners.iter().map(|&p| at(p)).collect::<Vec<_>>()),
        Shape::Box(Aabb { min, max }) => Shape::Box(Aabb::new(at(min), at(max))),
        Shape::Obb(Obb { center, axes, half }) => Shape::Obb(Obb { center: at(center), axes, half: half * scale }),
        Shape::Wall(_) | Shape::Prism(_) => *shape,
    }
}
