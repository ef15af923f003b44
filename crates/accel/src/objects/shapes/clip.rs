//! Clipping a polygon to a box, one plane after the other (Sutherland and Hodgman 1974).

use std::mem::swap;

use glam::{DVec3, Vec3};

use crate::{Aabb, Axis};

/// A convex polygon of six corners cut by six planes has at most twelve.
const MOST: usize = 12;

/// A small box around the part of a convex polygon (at most 6 corners) that lies in `bounds`.
pub(super) fn clip_polygon(corners: &[Vec3], bounds: &Aabb) -> Aabb {
    let whole = Aabb::around(corners.iter().copied());
    if !whole.touches(bounds) || bounds.encloses(&whole) {
        return whole.intersection(*bounds);
    }
    let (mut polygon, mut spare) = (Corners::none(), Corners::none());
    // Cut corners may stick out by a rounding error.
    polygon.fill(corners).cut(&whole, bounds, &mut spare).bounds().intersection(*bounds)
}

/// The same for two parts at once: of what lies in `bounds`, that below `high` and that above `low`.
pub(super) fn clip_polygon_twice(corners: &[Vec3], bounds: &Aabb, axis: Axis, [high, low]: [f32; 2]) -> [Aabb; 2] {
    let whole = Aabb::around(corners.iter().copied());
    let (mut polygon, mut spare) = (Corners::none(), Corners::none());
    let polygon = polygon.fill(corners).cut(&whole, bounds, &mut spare);
    let along = |p: DVec3| p[axis.index()];
    let below = polygon.bounds_within(|p| f64::from(high) - along(p));
    let above = polygon.bounds_within(|p| along(p) - f64::from(low));
    [below.intersection(bounds.cut(axis, high).0), above.intersection(bounds.cut(axis, low).1)]
}

/// The corners of a convex polygon. In double precision, so that the corners of scenes far from the origin do
/// not wander while they are cut.
struct Corners {
    points: [DVec3; MOST],
    len: usize,
}

impl Corners {
    fn none() -> Corners {
        Corners { points: [DVec3::ZERO; MOST], len: 0 }
    }

    fn fill(&mut self, corners: &[Vec3]) -> &mut Corners {
        for p in corners {
            self.add(p.as_dvec3());
        }
        self
    }

    fn add(&mut self, p: DVec3) {
        if self.len < MOST {
            self.points[self.len] = p;
            self.len += 1;
        }
    }

    fn list(&self) -> &[DVec3] {
        &self.points[..self.len]
    }

    /// The part in `bounds`. A plane that `whole`, the box around the polygon, is inside of cuts nothing.
    fn cut<'a>(&'a mut self, whole: &Aabb, bounds: &Aabb, spare: &'a mut Corners) -> &'a Corners {
        let (mut polygon, mut kept) = (self, spare);
        for axis in 0..3 {
            let (min, max) = (bounds.min[axis], bounds.max[axis]);
            if whole.min[axis] < min {
                polygon.keep(|p| p[axis] - f64::from(min), kept);
                swap(&mut polygon, &mut kept);
            }
            if whole.max[axis] > max {
                polygon.keep(|p| f64::from(max) - p[axis], kept);
                swap(&mut polygon, &mut kept);
            }
        }
        polygon
    }

    /// The box around it.
    fn bounds(&self) -> Aabb {
        Aabb::around(self.list().iter().map(|p| p.as_vec3()))
    }

    /// The box around the part where `inside` is not negative.
    fn bounds_within(&self, inside: impl Fn(DVec3) -> f64) -> Aabb {
        let (mut min, mut max) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        clipped(self.list(), inside, |p| (min, max) = (min.min(p), max.max(p)));
        Aabb::new(min.as_vec3(), max.as_vec3())
    }

    /// Puts the part where `inside` is not negative into `kept`.
    fn keep(&self, inside: impl Fn(DVec3) -> f64, kept: &mut Corners) {
        kept.len = 0;
        clipped(self.list(), inside, |p| kept.add(p));
    }
}

/// Hands on the corners of the part of a polygon where `inside` is not negative.
#[inline]
pub(crate) fn clipped(corners: &[DVec3], inside: impl Fn(DVec3) -> f64, mut keep: impl FnMut(DVec3)) {
    let Some(first) = corners.first() else { return };
    let (mut p, mut a) = (*first, inside(*first));
    for next in 0..corners.len() {
        let q = *corners.get(next + 1).unwrap_or(first);
        let b = inside(q);
        if a >= 0.0 {
            keep(p);
        }
        // The edge crosses the border: keep the crossing.
        if (a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0) {
            keep(p + (q - p) * (a / (a - b)));
        }
        (p, a) = (q, b);
    }
}
