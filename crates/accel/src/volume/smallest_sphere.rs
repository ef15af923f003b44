//! The smallest sphere around a set, slide 49 (Welzl, "Smallest enclosing disks (balls and ellipsoids)", 1991).

use std::f32::consts::PI;

use glam::{DMat3, DVec3, Vec3};

use super::{Outline, Volume, corners, slack, told};
use crate::common::bars_origin;
use crate::events::patiently;
use crate::geometry::digits::length;
use crate::slab::{earlier, later};
use crate::{
    Aabb, Axes, Cancelled, Corner, Each, Fit, Interval, Measure, Observer, Place, PrimId, Primitives, Probe, Ray,
    Sphere, Visit,
};

impl Volume for Sphere {
    type Draft = Sphere;

    #[inline]
    fn bars(ray: &Ray) -> Option<Visit> {
        bars_origin(ray)
    }

    fn fit<P: Primitives>(
        prims: &P,
        ids: impl Iterator<Item = PrimId>,
        bounds: &Aabb,
        _: Axes,
        watch: &mut impl Observer<Fit>,
    ) -> Result<Sphere, Cancelled> {
        let corners = corners(prims, ids, watch)?;
        Sphere::around(&corners, bounds, watch)
    }

    fn meet(&self, ray: &Ray, within: Interval, place: Place, watch: &mut impl Observer<Visit>) -> Interval {
        let Sphere { center, radius } = *self;
        let larger = Sphere { center, radius: radius + slack(ray, ray.o - center, radius) };
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

    fn planes(&self) -> u32 {
        0
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
/// How many points at most decide where the centre lies; four would do if the right ones were known.
const FEW: usize = 64;
/// A point so little outside, as a part of the squared radius, lies on the sphere but for rounding.
const ROUNDING: f64 = 1e-12;

impl Sphere {
    /// A small sphere around balls: the smallest, if they are points.
    pub(crate) fn around(
        corners: &[Corner],
        bounds: &Aabb,
        watch: &mut impl Observer<Fit>,
    ) -> Result<Sphere, Cancelled> {
        let base = bounds.center().as_dvec3();
        let seen = |corner: &Corner| corner.at.as_dvec3() - base;
        // The smallest sphere around a few points: whatever lies furthest outside becomes one of them, until
        // nothing does (Gärtner, "Fast and robust smallest enclosing balls", 1999).
        let (mut few, mut ball) = (Vec::new(), through(&[]));
        while few.len() < FEW {
            let from_center = |corner: &Corner| (seen(corner) - ball.center).length_squared();
            let (far, furthest) = reach(corners, from_center, watch)?;
            let outside = !ball.holds(far);
            tell_far(corners, furthest, far.sqrt(), ball.radius(), outside, watch);
            if !outside {
                break;
            }
            few.push(seen(&corners[furthest]));
            let count = few.len();
            ball = smallest(&mut few, count, &mut Vec::new(), base, watch);
            let Vec3 { x, y, z } = told(base + ball.center, ball.radius());
            watch.on(Fit::Ball { x, y, z, radius: ball.radius() as f32, few: count as u32 });
        }
        let mut center = ball.center;
        if corners.iter().any(|corner| corner.radius > 0.0) {
            center = shrunk(corners, base, center, watch)?;
        }
        // What single precision makes of the centre, and as large as it then must be.
        let center = (base + center).as_vec3();
        let (radius, _) = reach(corners, |corner| far_side(corner, center.as_dvec3()), watch)?;
        let radius = (radius as f32).next_up();
        let Vec3 { x, y, z } = told(center.as_dvec3(), radius.into());
        watch.on(Fit::Sphere { x, y, z, radius });
        Ok(Sphere { center, radius })
    }

    /// The smallest sphere around two: it holds both, not only their centres.
    #[must_use]
    pub fn union(self, other: Sphere) -> Sphere {
        let (small, large) = if self.radius < other.radius { (self, other) } else { (other, self) };
        let apart = length(small.center - large.center);
        // One lies in the other.
        if apart + small.radius <= large.radius {
            return large;
        }
        let radius = (apart + small.radius + large.radius) * 0.5;
        let center = large.center + (small.center - large.center) * ((radius - large.radius) / apart);
        Sphere { center, radius: radius * (1.0 + 4.0 * f32::EPSILON) }
    }
}

/// Tells which corner is the furthest, so far away from the centre.
fn tell_far(corners: &[Corner], furthest: usize, far: f64, radius: f64, outside: bool, watch: &mut impl Observer<Fit>) {
    if let Some(corner) = corners.get(furthest) {
        let Vec3 { x, y, z } = corner.at;
        watch.on(Fit::Far { point: furthest as u32, x, y, z, far: far as f32, radius: radius as f32, outside });
    }
}

/// How far away the far side of a ball is.
fn far_side(corner: &Corner, from: DVec3) -> f64 {
    (corner.at.as_dvec3() - from).length() + f64::from(corner.radius)
}

/// How far away the furthest corner is, and which it is.
fn reach(
    corners: &[Corner],
    far: impl Fn(&Corner) -> f64,
    watch: &mut impl Observer<Fit>,
) -> Result<(f64, usize), Cancelled> {
    patiently(corners.iter().enumerate(), watch).try_fold((0.0, 0), |most, corner| {
        let (i, corner) = corner?;
        let far = far(corner);
        Ok(if far > most.0 { (far, i) } else { most })
    })
}

/// Moves the centre towards whatever is furthest, by ever smaller steps (Bădoiu and Clarkson, "Smaller core-sets
/// for balls", 2003); keeps the best.
fn shrunk(corners: &[Corner], base: DVec3, start: DVec3, watch: &mut impl Observer<Fit>) -> Result<DVec3, Cancelled> {
    let mut center = start;
    let (mut best, mut least) = (start, f64::INFINITY);
    for step in 0..SHRINK {
        let (radius, furthest) = reach(corners, |corner| far_side(corner, base + center), watch)?;
        if radius < least {
            (best, least) = (center, radius);
        }
        center += (corners[furthest].at.as_dvec3() - base - center) / (step + 2) as f64;
        let Vec3 { x, y, z } = told(base + center, radius);
        watch.on(Fit::Shift { x, y, z, radius: radius as f32, part: ((step + 2) as f32).recip() });
    }
    Ok(best)
}

/// A sphere through some points.
struct Ball {
    center: DVec3,
    radius_squared: f64,
}

impl Ball {
    /// Its radius; 0 of none.
    fn radius(&self) -> f64 {
        self.radius_squared.max(0.0).sqrt()
    }

    /// Whether a point so far from the centre, squared, lies in it.
    fn holds(&self, far_squared: f64) -> bool {
        far_squared <= self.radius_squared * (1.0 + ROUNDING)
    }
}

/// The smallest sphere around the first `count` points that has those of `edge`, at most four, on it. `base` is where
/// the points are seen from.
fn smallest(
    points: &mut [DVec3],
    count: usize,
    edge: &mut Vec<DVec3>,
    base: DVec3,
    watch: &mut impl Observer<Fit>,
) -> Ball {
    let mut ball = through(edge);
    if !edge.is_empty() {
        let Vec3 { x, y, z } = told(base + ball.center, ball.radius());
        watch.on(Fit::Try { x, y, z, radius: ball.radius() as f32, on: edge.len() as u32 });
    }
    if edge.len() == 4 {
        return ball;
    }
    for i in 0..count {
        let p = points[i];
        if !ball.holds((p - ball.center).length_squared()) {
            // It lies outside, so it lies on the sphere around itself and those before it.
            edge.push(p);
            ball = smallest(points, i, edge, base, watch);
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
