//! Clipping a polygon to a box, one plane after the other (Sutherland and Hodgman 1974).

use glam::Vec3;

use crate::{Aabb, Axis};

/// A convex polygon cut by six planes has at most its own corners plus six.
const MOST: usize = 12;

/// A small box around the part of a convex polygon (at most 6 corners) that lies in `bounds`.
pub(super) fn clip_polygon(corners: &[Vec3], bounds: &Aabb) -> Aabb {
    let mut polygon = Corners::new(corners);
    for axis in Axis::ALL {
        polygon = polygon.keep(|p| p[axis] - bounds.min[axis]);
        polygon = polygon.keep(|p| bounds.max[axis] - p[axis]);
    }
    // Interpolated corners may stick out by a rounding error.
    Aabb::around(polygon.list().iter().copied()).intersection(*bounds)
}

struct Corners {
    points: [Vec3; MOST],
    len: usize,
}

impl Corners {
    fn new(corners: &[Vec3]) -> Corners {
        let mut polygon = Corners { points: [Vec3::ZERO; MOST], len: 0 };
        for &corner in corners {
            polygon.add(corner);
        }
        polygon
    }

    fn add(&mut self, p: Vec3) {
        if self.len < MOST {
            self.points[self.len] = p;
            self.len += 1;
        }
    }

    fn list(&self) -> &[Vec3] {
        &self.points[..self.len]
    }

    /// The part where `inside` is not negative.
    fn keep(&self, inside: impl Fn(Vec3) -> f32) -> Corners {
        let mut kept = Corners::new(&[]);
        for (i, &p) in self.list().iter().enumerate() {
            let q = self.points[(i + 1) % self.len];
            let (a, b) = (inside(p), inside(q));
            if a >= 0.0 {
                kept.add(p);
            }
            // The edge crosses the plane: keep the crossing.
            if (a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0) {
                kept.add(p + (q - p) * (a / (a - b)));
            }
        }
        kept
    }
}
