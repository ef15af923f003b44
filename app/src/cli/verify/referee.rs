//! The referee: the nearest hit in double precision, by other formulas than those of the structures.
//!
//! It knows no boxes and no rounding rules, so it says how good brute force itself is.

use glam::{DVec2, DVec3};
use raystep_accel::{Cone, Cylinder, Obb, Polygon, PrimId, Primitives, Ray, Shape, Sphere, Triangle, Wall};

/// The nearest hit and its t.
pub(super) fn nearest(prims: &impl Primitives, ray: &Ray) -> Option<(f64, PrimId)> {
    nearest_moved(prims, ray, DVec3::ZERO)
}

/// The same for the ray that begins so far from where this one does.
pub(super) fn nearest_moved(prims: &impl Primitives, ray: &Ray, by: DVec3) -> Option<(f64, PrimId)> {
    let line = Line { o: ray.o.as_dvec3() + by, d: ray.d.as_dvec3() };
    // Further away t is no number of single precision.
    let in_range = |t: &f64| f64::from(ray.t_min) <= *t && *t <= f64::from(ray.t_max.min(f32::MAX));
    let mut best: Option<(f64, PrimId)> = None;
    for prim in (0..prims.len() as u32).map(PrimId) {
        for t in line.meets(&prims.shape(prim)).into_iter().filter(in_range) {
            if best.is_none_or(|(nearest, _)| t < nearest) {
                best = Some((t, prim));
            }
        }
    }
    best
}

/// Two t further apart than this part of them are different places.
const APART: f64 = 1e-4;

/// By how much of itself t differs, beyond `slack`.
pub(super) fn error(ray: &Ray, found: f64, t: f64, slack: f64) -> f64 {
    // A hit at the origin itself has no relative error but that of the origin's own coordinates.
    let (o, d) = (ray.o.as_dvec3(), ray.d.as_dvec3());
    let least = o.length() * f64::from(f32::EPSILON) / d.length();
    ((found - t).abs() - slack).max(0.0) / t.abs().max(least).max(f64::from(f32::MIN_POSITIVE))
}

/// Whether two answers are hits at the same place, or none.
pub(super) fn is_same(ray: &Ray, a: Option<(f64, PrimId)>, b: Option<(f64, PrimId)>, slack: f64) -> bool {
    match (a, b) {
        (None, None) => true,
        (Some((a, _)), Some((b, _))) => error(ray, a, b, slack) <= APART,
        _ => false,
    }
}

struct Line {
    o: DVec3,
    d: DVec3,
}

impl Line {
    fn meets(&self, shape: &Shape<'_>) -> Vec<f64> {
        match shape {
            Shape::Triangle(triangle) => self.triangle(triangle).into_iter().collect(),
            Shape::Sphere(sphere) => self.sphere(sphere),
            Shape::Disc(disc) => {
                self.disc(disc.center.as_dvec3(), disc.normal.as_dvec3(), f64::from(disc.radius)).into_iter().collect()
            }
            Shape::Wall(wall) => self.wall(wall).into_iter().collect(),
            Shape::Prism(prism) => prism.walls().filter_map(|wall| self.wall(&wall)).collect(),
            Shape::Cylinder(cylinder) => self.cylinder(cylinder),
            Shape::Cone(cone) => self.cone(cone),
            Shape::Polygon(polygon) => self.polygon(polygon).into_iter().collect(),
            Shape::Box(bounds) => self.turned_box(&Obb::from_aabb(bounds)),
            Shape::Obb(turned) => self.turned_box(turned),
        }
    }

    /// Cramer's rule (Möller and Trumbore 1997).
    fn triangle(&self, triangle: &Triangle) -> Option<f64> {
        let a = triangle.a.as_dvec3();
        let (ab, ac) = (triangle.b.as_dvec3() - a, triangle.c.as_dvec3() - a);
        let across = self.d.cross(ac);
        let volume = ab.dot(across);
        if volume == 0.0 {
            return None;
        }
        let from_a = self.o - a;
        let u = from_a.dot(across) / volume;
        let turned = from_a.cross(ab);
        let v = self.d.dot(turned) / volume;
        (u >= 0.0 && v >= 0.0 && u + v <= 1.0).then(|| ac.dot(turned) / volume)
    }

    /// Half a chord before and behind the point nearest to the centre.
    fn sphere(&self, sphere: &Sphere) -> Vec<f64> {
        let along = self.d.normalize();
        let to_center = sphere.center.as_dvec3() - self.o;
        let middle = to_center.dot(along);
        let off = to_center.cross(along).length();
        let r = f64::from(sphere.radius);
        if off > r {
            return Vec::new();
        }
        let half = ((r - off) * (r + off)).sqrt();
        [middle - half, middle + half].map(|s| s / self.d.length()).to_vec()
    }

    fn disc(&self, center: DVec3, n: DVec3, radius: f64) -> Option<f64> {
        let t = (center - self.o).dot(n) / self.d.dot(n);
        let at = self.o + self.d * t;
        (t.is_finite() && at.distance(center) <= radius).then_some(t)
    }

    /// Both ends, and the side: at `radius` from the axis, between the ends.
    fn cylinder(&self, cylinder: &Cylinder) -> Vec<f64> {
        let (from, to, r) = (cylinder.from.as_dvec3(), cylinder.to.as_dvec3(), f64::from(cylinder.radius));
        let axis = (to - from).normalize_or(DVec3::X);
        let away = |v: DVec3| v - axis * v.dot(axis);
        let (o, d) = (away(self.o - from), away(self.d));
        let side = roots(d.length_squared(), o.dot(d), o.length_squared() - r * r);
        let height = (to - from).dot(axis);
        let side = side.filter(|t| (0.0..=height).contains(&(self.o + self.d * t - from).dot(axis)));
        side.chain(self.disc(from, axis, r)).chain(self.disc(to, axis, r)).collect()
    }

    /// The base, and the side: as far from the axis as the depth below the apex says.
    fn cone(&self, cone: &Cone) -> Vec<f64> {
        let (apex, base, r) = (cone.apex.as_dvec3(), cone.base.as_dvec3(), f64::from(cone.radius));
        let axis = (base - apex).normalize_or(DVec3::X);
        let height = (base - apex).dot(axis);
        let spread = r / height;
        let parts = |v: DVec3| (v - axis * v.dot(axis), v.dot(axis) * spread);
        let ((o, o_depth), (d, d_depth)) = (parts(self.o - apex), parts(self.d));
        let a = d.length_squared() - d_depth * d_depth;
        let side = roots(a, o.dot(d) - o_depth * d_depth, o.length_squared() - o_depth * o_depth);
        let side = side.filter(|t| (0.0..=height).contains(&(self.o + self.d * t - apex).dot(axis)));
        side.chain(self.disc(base, axis, r)).collect()
    }

    /// The plane of the outline, then how often a line from the point crosses the outline.
    fn polygon(&self, polygon: &Polygon<'_>) -> Option<f64> {
        let corners: Vec<DVec3> = polygon.corners.iter().map(|corner| corner.as_dvec3()).collect();
        let from = *corners.first()?;
        let n: DVec3 = corners.windows(2).map(|edge| (edge[0] - from).cross(edge[1] - from)).sum();
        let t = (from - self.o).dot(n) / self.d.dot(n);
        let at = self.o + self.d * t;
        let across = n.any_orthogonal_vector().normalize();
        let up = n.cross(across).normalize();
        let on_page = |p: DVec3| DVec2::new((p - at).dot(across), (p - at).dot(up));
        let next = corners.iter().cycle().skip(1);
        let crossings = corners.iter().zip(next).filter(|&(&p, &q)| {
            let (p, q) = (on_page(p), on_page(q));
            (p.y > 0.0) != (q.y > 0.0) && p.x - p.y * (q.x - p.x) / (q.y - p.y) > 0.0
        });
        (t.is_finite() && crossings.count() % 2 == 1).then_some(t)
    }

    /// Where the line enters and leaves a box, in the box's own directions.
    fn turned_box(&self, turned: &Obb) -> Vec<f64> {
        let (mut enter, mut leave) = (f64::NEG_INFINITY, f64::INFINITY);
        for (i, axis) in turned.axes.iter().enumerate() {
            let axis = axis.as_dvec3();
            let (o, d) = ((self.o - turned.center.as_dvec3()).dot(axis), self.d.dot(axis));
            let half = f64::from(turned.half[i]);
            if d == 0.0 {
                if o.abs() > half {
                    return Vec::new();
                }
                continue;
            }
            let faces = [(-half - o) / d, (half - o) / d];
            enter = enter.max(faces[0].min(faces[1]));
            leave = leave.min(faces[0].max(faces[1]));
        }
        if enter <= leave { vec![enter, leave] } else { Vec::new() }
    }

    /// An upright rectangle: its plane, then how far along and how high.
    fn wall(&self, wall: &Wall) -> Option<f64> {
        let (from, to) = (wall.from.as_dvec2(), wall.to.as_dvec2());
        let along = to - from;
        let n = along.perp();
        let t = (from - DVec2::new(self.o.x, self.o.y)).dot(n) / DVec2::new(self.d.x, self.d.y).dot(n);
        if !t.is_finite() {
            return None;
        }
        let at = self.o + self.d * t;
        let part = (DVec2::new(at.x, at.y) - from).dot(along) / along.length_squared();
        let [foot, head] = wall.z.map(f64::from);
        ((0.0..=1.0).contains(&part) && (foot..=head).contains(&at.z)).then_some(t)
    }
}

/// The t for which a·t² + 2·b·t + c = 0.
fn roots(a: f64, b: f64, c: f64) -> impl Iterator<Item = f64> {
    let root = (b * b - a * c).sqrt();
    // The root that adds, so that nothing cancels; the other follows from their product.
    let sum = -(b + root.copysign(b));
    [sum / a, c / sum].into_iter().filter(|t| t.is_finite())
}

#[cfg(test)]
mod tests {
    use glam::Vec3;
    use raystep_accel::{Prims, Random};

    use super::*;
    use crate::cli::verify::tally::Sample;

    #[test]
    fn it_meets_every_shape() {
        let Some(one_of_each) = raystep_scene::trial::named("trial:one-of-each:0") else { panic!("no such scene") };
        let Prims::Few(shapes) = &one_of_each.prims else { panic!("a few shapes") };
        let mut random = Random::new(1);
        for (i, shape) in shapes.iter().enumerate() {
            let prims = &Prims::Few(vec![*shape]);
            let (bounds, mut hits, mut sample) = (shape.bounds(), 0, Sample::default());
            for _ in 0..2000 {
                let mut anywhere = || Vec3::new(random.unit(), random.unit(), random.unit());
                let inside = bounds.min + bounds.extent() * anywhere();
                let outside = bounds.center() + (anywhere() - 0.5) * 9.0;
                let ray = Ray::new(outside, inside - outside).unwrap();
                let right = nearest(prims, &ray);
                hits += u32::from(right.is_some());
                let found = raystep_accel::Accel::intersect(&raystep_accel::List, prims, &ray, &mut ());
                sample += Sample::of(prims, &ray, found, right);
            }
            assert!(hits > 300, "shape {i}: {hits}");
            assert!(sample.to_string().contains(": 0 (0.0 %) differ"), "shape {i}: {sample}");
        }
    }
}
