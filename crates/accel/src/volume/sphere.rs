//! The smallest sphere around a set, slide 49 (Welzl, "Smallest enclosing disks (balls and ellipsoids)", 1991).

use std::f32::consts::PI;

use glam::{DMat3, DVec3};

use super::{Outline, Volume, corners, slack};
use crate::slab::{earlier, later};
use crate::{
    Aabb, Axes, Corner, Each, Interval, Measure, Observer, Place, PrimId, Primitives, Probe, Ray, Sphere, Visit,
};

impl Volume for Sphere {
    type Draft = Sphere;

    fn fit<P: Primitives>(prims: &P, ids: impl Iterator<Item = PrimId>, bounds: &Aabb, _: Axes) -> Sphere {
        Sphere::around(&corners(prims, ids), bounds)
    }

    fn meet(&self, ray: &Ray, within: Interval, place: Place, watch: &mut impl Observer<Visit>) -> Interval {
        let Sphere { center, radius } = *self;
        let larger = Sphere { center, radius: radius + slack(ray.o - center, radius) };
        let Interval { near: mut t_near, far: mut t_far } = within;
        // Where the ray's line enters and leaves it.
        let mut equation = [0.0; 4];
        let roots = larger.meet(
            ray,
            &mut Each(|probe| {
                if let Probe::Quadratic { a, b, c, discriminant, .. } = probe {
                    equation = [a, b, c, discriminant];
                }
            }),
        );
        // From the first root to the second, rounded outward; nothing without a root.
        let [t1, t2] = roots.unwrap_or([f32::INFINITY, f32::NEG_INFINITY]);
        let part = Interval::new(earlier(t1), later(t2));
        if part.near > t_near {
            t_near = part.near;
        }
        if part.far < t_far {
            t_far = part.far;
        }
        let [a, b, c, discriminant] = equation;
        watch.on(Visit::Roots { place, a, b, c, discriminant, t1, t2, t_near, t_far, empty: t_near > t_far });
        Interval::new(t_near, t_far)
    }

    fn bounds(&self) -> Aabb {
        Sphere::bounds(self)
    }

    fn outline(&self) -> Outline {
        Outline::Sphere(*self)
    }

    fn measure(&self, measure: Measure) -> f32 {
        match measure {
            Measure::Area => 4.0 * PI * self.radius * self.radius,
            Measure::Perimeter => 2.0 * PI * self.radius,
        }
    }
}

/// How often the centre is moved to shrink a sphere around balls.
const SHRINK: usize = 64;

impl Sphere {
    /// A small sphere around balls: the smallest, if they are points.
    pub(crate) fn around(corners: &[Corner], bounds: &Aabb) -> Sphere {
        let base = bounds.center().as_dvec3();
        let mut points: Vec<DVec3> = corners.iter().map(|corner| corner.at.as_dvec3() - base).collect();
        let count = points.len();
        let mut center = smallest(&mut points, count, &mut Vec::new()).center;
        if corners.iter().any(|corner| corner.radius > 0.0) {
            center = shrunk(corners, base, center);
        }
        // What single precision makes of the centre, and as large as it then must be.
        let center = (base + center).as_vec3();
        let (radius, _) = reach(corners, center.as_dvec3());
        Sphere { center, radius: (radius as f32).next_up() }
    }

    /// The smallest sphere around two: it holds both, not only their centres.
    #[must_use]
    pub fn union(self, other: Sphere) -> Sphere {
        let (small, large) = if self.radius < other.radius { (self, other) } else { (other, self) };
        let apart = (small.center - large.center).length();
        // One lies in the other.
        if apart + small.radius <= large.radius {
            return large;
        }
        let radius = (apart + small.radius + large.radius) * 0.5;
        let center = large.center + (small.center - large.center) * ((radius - large.radius) / apart);
        Sphere { center, radius: radius * (1.0 + 4.0 * f32::EPSILON) }
    }
}

/// How far the balls reach from `center`, and which of them furthest.
fn reach(corners: &[Corner], center: DVec3) -> (f64, usize) {
    let far = |corner: &Corner| (corner.at.as_dvec3() - center).length() + f64::from(corner.radius);
    corners.iter().enumerate().fold((0.0, 0), |most, (i, corner)| {
        let far = far(corner);
        if far > most.0 { (far, i) } else { most }
    })
}

/// Moves the centre towards whatever is furthest, by ever smaller steps (Bădoiu and Clarkson, "Smaller core-sets
/// for balls", 2003); keeps the best.
fn shrunk(corners: &[Corner], base: DVec3, start: DVec3) -> DVec3 {
    let mut center = start;
    let (mut best, mut least) = (start, f64::INFINITY);
    for step in 0..SHRINK {
        let (radius, furthest) = reach(corners, base + center);
        if radius < least {
            (best, least) = (center, radius);
        }
        center += (corners[furthest].at.as_dvec3() - base - center) / (step + 2) as f64;
    }
    best
}

/// A sphere through some points.
struct Ball {
    center: DVec3,
    radius_squared: f64,
}

/// The smallest sphere around the first `count` points that has those of `edge`, at most four, on it.
fn smallest(points: &mut [DVec3], count: usize, edge: &mut Vec<DVec3>) -> Ball {
    let mut ball = through(edge);
    if edge.len() == 4 {
        return ball;
    }
    for i in 0..count {
        let p = points[i];
        if (p - ball.center).length_squared() > ball.radius_squared * (1.0 + 1e-12) {
            // It lies outside, so it lies on the sphere around itself and those before it.
            edge.push(p);
            ball = smallest(points, i, edge);
            edge.pop();
            // Points that mattered once are asked first.
            points[..=i].rotate_right(1);
        }
    }
    ball
}

/// The smallest sphere through at most four points; through fewer of them if they lie in a plane or on a line.
fn through(edge: &[DVec3]) -> Ball {
    let Some((&first, others)) = edge.split_first() else {
        return Ball { center: DVec3::ZERO, radius_squared: -1.0 };
    };
    let q = |i: usize| others.get(i).map_or(DVec3::ZERO, |&p| p - first);
    let (a, b, c) = (q(0), q(1), q(2));
    // The centre is first + Σ λᵢ·qᵢ, as far from each qᵢ as from zero.
    let off = match others.len() {
        0 => DVec3::ZERO,
        1 => a * 0.5,
        2 => {
            let normal = a.cross(b);
            let n2 = normal.length_squared();
            if n2 <= 1e-24 * a.length_squared() * b.length_squared() {
                return through(&edge[..2]);
            }
            (normal.cross(a) * b.length_squared() + b.cross(normal) * a.length_squared()) / (2.0 * n2)
        }
        _ => {
            let rows = DMat3::from_cols(a, b, c).transpose();
            let size = a.length() * b.length() * c.length();
            if rows.determinant().abs() <= 1e-12 * size {
                return through(&edge[..3]);
            }
            rows.inverse() * (DVec3::new(a.length_squared(), b.length_squared(), c.length_squared()) * 0.5)
        }
    };
    Ball { center: first + off, radius_squared: off.length_squared() }
}
