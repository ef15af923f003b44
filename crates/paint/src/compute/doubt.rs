//! Looks for what the margins do not cover: the shader's own steps, each rounded as badly as WGSL allows, before `accel`.

use glam::Vec3;
use raystep_accel::{Mesh, PrimId, Primitives, Prims, Random, Ray, Shape, Triangle};
use raystep_fast::Shot;
use raystep_scene::trial::rays::Targets;
use raystep_scene::trial::scenes::cases;

use super::margins::{BOX, CONSTANTS};

/// Rounds as badly as allowed: up, down, or either, by lot.
struct Rough {
    random: Random,
    habit: u32,
}

impl Rough {
    fn round(&mut self, exact: f64) -> f32 {
        let nearest = exact as f32;
        let up = match self.habit {
            0 => true,
            1 => false,
            _ => self.random.below(2) == 0,
        };
        let there = f64::from(nearest);
        if nearest.abs() < f32::MIN_POSITIVE {
            0.0
        } else if up && there < exact {
            nearest.next_up()
        } else if !up && there > exact {
            nearest.next_down()
        } else {
            nearest
        }
    }

    fn mul(&mut self, a: f32, b: f32) -> f32 {
        self.round(f64::from(a) * f64::from(b))
    }

    fn add(&mut self, a: f32, b: f32) -> f32 {
        self.round(f64::from(a) + f64::from(b))
    }

    /// a·b + c, fused or not.
    fn mul_add(&mut self, a: f32, b: f32, c: f32) -> f32 {
        if self.random.below(2) == 0 {
            return self.round(f64::from(a) * f64::from(b) + f64::from(c));
        }
        let product = self.mul(a, b);
        self.add(product, c)
    }

    /// One over a, by 2.5 units in the last place at worst.
    fn over(&mut self, a: f32) -> f32 {
        let over = 1.0 / a;
        match self.random.below(3) {
            0 => over.next_up().next_up(),
            1 => over.next_down().next_down(),
            _ => over,
        }
    }

    /// What the slabs of a box leave of a ray, as the shader finds it.
    fn slabs(&mut self, low: Vec3, high: Vec3, shot: &Shot<'_>) -> [f32; 2] {
        let [mut near, mut far] = [-f32::MAX, f32::MAX];
        for axis in 0..3 {
            let (first, last) = if shot.down[axis] { (high, low) } else { (low, high) };
            near = near.max(self.mul_add(first[axis], shot.r[axis], shot.enter[axis]));
            far = far.min(self.mul_add(last[axis], shot.r[axis], shot.leave[axis]));
        }
        [near, far]
    }

    /// Meets a triangle as the shader does: whether it is left, between which t it is met, whether that is sure.
    fn meet(&mut self, triangle: &Triangle, shot: &Shot<'_>) -> (bool, Option<[f32; 2]>, bool) {
        let [area_part, far_part, least_area, depth_part] = CONSTANTS.map(|(_, value)| value as f32);
        let [a, b, c] = [triangle.a, triangle.b, triangle.c].map(|corner| {
            let [x, y, z] = [0, 1, 2].map(|i| self.add(corner[shot.axes[i]], -shot.o[i]));
            let [x, y] = [(x, 0), (y, 1)].map(|(x, i)| self.mul_add(-shot.shear[i], z, x));
            [x, y, z]
        });
        let mut difference = |a: f32, b: f32, c: f32, d: f32| {
            let product = self.mul(c, d);
            self.mul_add(a, b, -product)
        };
        let u = difference(c[0], b[1], c[1], b[0]);
        let v = difference(a[0], c[1], a[1], c[0]);
        let w = difference(b[0], a[1], b[1], a[0]);
        let size = triangle.bounds().extent().max_element().next_up();
        let away = self.mul_add(2.0, size, a[2].abs());
        let part = self.mul(far_part, away);
        let part = self.mul_add(area_part, size, part);
        let margin = self.mul_add(away, part, least_area);
        let (least, most) = (u.min(v).min(w), u.max(v).max(w));
        let left = !(least < -margin && margin < most);
        let area = self.add(u, v);
        let area = self.add(area, w);
        if !left || area.abs() < 8.0 * margin {
            return (left, None, false);
        }
        let over = self.over(area);
        let weighed = [(v, b), (w, c)].map(|(area, corner)| {
            let (weight, along) = (self.mul(area, over), self.add(corner[2], -a[2]));
            self.mul(weight, along)
        });
        let depth = self.add(weighed[0], weighed[1]);
        let depth = self.add(a[2], depth);
        let doubt = self.mul(margin, over.abs());
        let wide = self.mul(12.0, size);
        let deep = self.mul(depth_part, away);
        let slack = self.mul_add(wide, doubt, deep);
        let slack = self.mul(slack, shot.sorted_r[2].abs());
        let t = self.mul(depth, shot.sorted_r[2]);
        let [low, high] = [self.add(t, -slack), self.add(t, slack)];
        let inside = least > 2.0 * margin || most < -2.0 * margin;
        let furthest = [a, b, c].iter().flat_map(|corner| &corner[..2]).fold(0.0f32, |most, x| most.max(x.abs()));
        let is_near = furthest <= self.mul_add(2.0, size, deep);
        let counts = t.abs() >= 2.0 * slack && low >= shot.ray.t_min && high <= shot.ray.t_max;
        (left, Some([low, high]), inside && is_near && counts)
    }
}

/// How often it was looked at, how often there was a hit, and how often one was sure.
#[derive(Default, Debug)]
struct Looked {
    pairs: u64,
    hits: u64,
    sure: u64,
}

/// What is claimed of a ray and a triangle must hold.
fn check(rough: &mut Rough, triangle: Triangle, shot: &Shot<'_>, looked: &mut Looked) {
    let found = Shape::Triangle(triangle).intersect(shot.ray);
    let (left, range, sure) = rough.meet(&triangle, shot);
    let what = || format!("{triangle:?}\n{:?}\nfound {found:?}, left {left}, {range:?}, sure {sure}", shot.ray);
    looked.pairs += 1;
    looked.sure += u64::from(sure);
    assert!(!sure || found.is_some(), "sure of a miss: {}", what());
    let Some(t) = found else { return };
    looked.hits += 1;
    assert!(left, "a hit is ruled out: {}", what());
    if let Some([low, high]) = range {
        assert!(low <= t && t <= high, "a hit lies elsewhere: {}", what());
    }
    let bounds = triangle.bounds();
    let [near, far] = rough.slabs(bounds.min, bounds.max, shot);
    assert!(near <= t && t <= far, "a hit's box is missed, {near} to {far}: {}", what());
}

/// So many rays of each trial scene; `RAYSTEP_DOUBTS` asks for more.
fn many() -> u32 {
    std::env::var("RAYSTEP_DOUBTS").map_or(500, |many| many.parse().expect("RAYSTEP_DOUBTS is a number"))
}

#[test]
fn no_rounding_breaks_what_is_claimed() {
    let mut looked = Looked::default();
    for (case, seed) in cases().into_iter().filter(|case| !case.flat).zip(1..) {
        let Prims::Few(shapes) = &case.prims else { continue };
        let mut mesh = Mesh::default();
        for shape in shapes {
            if let Shape::Triangle(Triangle { a, b, c }) = shape {
                let first = mesh.corners.len() as u32;
                mesh.corners.extend([a, b, c]);
                mesh.triangles.push([first, first + 1, first + 2]);
            }
        }
        let reach = mesh.corners.iter().fold(0.0f32, |most, corner| most.max(corner.abs().max_element()));
        let prims = Prims::Mesh(mesh.clone());
        let targets = Targets::of(&prims, false, &[]);
        let mut random = Random::new(seed);
        for i in 0..many() {
            let Some(ray) = targets.ray(&prims, i, &mut random) else { continue };
            let Ok(shot) = Shot::with_margin(&ray, reach, BOX) else { continue };
            let mut rough = Rough { random: Random::new(u64::from(i) + 1), habit: i % 3 };
            (0..mesh.len() as u32).for_each(|id| check(&mut rough, mesh.triangle(PrimId(id)), &shot, &mut looked));
        }
    }
    println!("{looked:?}");
    assert!(looked.hits > looked.pairs / 200 && looked.sure > looked.hits / 10, "too little was looked at: {looked:?}");
}

#[test]
fn a_triangle_in_front_is_sure() {
    let triangle = Triangle { a: Vec3::ZERO, b: Vec3::X, c: Vec3::Y };
    let ray = Ray::new(Vec3::new(0.3, 0.3, 1.0), Vec3::NEG_Z).unwrap();
    let shot = Shot::with_margin(&ray, 1.0, BOX).unwrap();
    let (left, range, sure) = Rough { random: Random::new(1), habit: 2 }.meet(&triangle, &shot);
    let [low, high] = range.expect("it is met somewhere");
    assert!(left && sure && low < 1.0 && 1.0 < high && high - low < 1e-3, "{left} {sure} {low} {high}");
}
