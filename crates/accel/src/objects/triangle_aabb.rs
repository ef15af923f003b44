//! A triangle and a box (Akenine-Möller, "Fast 3D triangle-box overlap testing", 2001).

use glam::{DVec3, Vec3};

use super::{Part, Probe};
use crate::{Aabb, Observer, Triangle};

impl Triangle {
    /// Whether it touches the box. Two convex bodies are apart exactly if some axis separates their
    /// shadows; here thirteen axes are enough. In double precision: along a normal three coordinates are
    /// multiplied, which in single precision are no number from 10¹³ on.
    pub fn overlaps(&self, bounds: &Aabb, watch: &mut impl Observer<Probe>) -> bool {
        let [a, b, c] = [self.a, self.b, self.c].map(Vec3::as_dvec3);
        let (min, max) = (bounds.min.as_dvec3(), bounds.max.as_dvec3());
        // Seen from the middle of the box.
        let center = (min + max) * 0.5;
        let half = (max - min) * 0.5;
        let corners = [a - center, b - center, c - center];
        let edges = [b - a, c - b, a - c];

        // The three normals of the box.
        let box_axes_overlap = (0..3).all(|axis| {
            let shadow = corners.map(|corner| corner[axis]);
            shadows_overlap(Part::Second, DVec3::AXES[axis], shadow, half[axis], watch)
        });
        let mut overlap_along = |of: Part, along: DVec3| {
            let shadow = corners.map(|corner| along.dot(corner));
            shadows_overlap(of, along, shadow, along.abs().dot(half), watch)
        };
        box_axes_overlap
            // The triangle's normal.
            && overlap_along(Part::First, edges[0].cross(edges[1]))
            // The cross products of their edges.
            && edges.iter().all(|edge| DVec3::AXES.iter().all(|axis| overlap_along(Part::Edges, axis.cross(*edge))))
    }
}

/// Whether the shadows of the corners and of a box that reaches so far overlap on `along`. On no axis at
/// all, as of a triangle without area, they do.
#[inline]
fn shadows_overlap(of: Part, along: DVec3, [a, b, c]: [f64; 3], reach: f64, watch: &mut impl Observer<Probe>) -> bool {
    let (low, high) = (a.min(b).min(c), a.max(b).max(c));
    let overlap = low <= reach && high >= -reach;
    let Vec3 { x, y, z } = along.as_vec3();
    let [a_low, a_high, b_low, b_high] = [low, high, -reach, reach].map(|at| at as f32);
    watch.on(Probe::Shadow { of, x, y, z, a_low, a_high, b_low, b_high, apart: !overlap });
    overlap
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Random;

    #[test]
    fn finds_the_corners_that_boxes_alone_do_not() {
        let unit = Aabb::new(Vec3::ZERO, Vec3::ONE);
        // Its box meets the unit box; the triangle itself passes a corner.
        let beside = Triangle { a: Vec3::new(2.5, 0.0, 0.0), b: Vec3::new(0.0, 2.5, 0.0), c: Vec3::new(2.5, 2.5, 0.0) };
        assert!(beside.bounds().touches(&unit));
        assert!(!beside.overlaps(&unit, &mut ()));
        // It touches the corner (1, 1, 0) exactly.
        let touching =
            Triangle { a: Vec3::new(2.0, 0.0, 0.0), b: Vec3::new(0.0, 2.0, 0.0), c: Vec3::new(2.0, 2.0, 0.0) };
        assert!(touching.overlaps(&unit, &mut ()));
        // A needle and a point have no normal.
        let needle = Triangle { a: Vec3::splat(0.5), b: Vec3::splat(3.0), c: Vec3::splat(2.0) };
        let point = Triangle { a: Vec3::splat(0.5), b: Vec3::splat(0.5), c: Vec3::splat(0.5) };
        assert!(needle.overlaps(&unit, &mut ()) && point.overlaps(&unit, &mut ()));
    }

    #[test]
    fn agrees_with_clipping() {
        let mut random = Random::new(3);
        let mut point = || Vec3::new(random.range(-2.0, 2.0), random.range(-2.0, 2.0), random.range(-2.0, 2.0));
        let mut both = [0; 2];
        for _ in 0..20_000 {
            let triangle = Triangle { a: point(), b: point(), c: point() };
            let bounds = Aabb::around([point() * 0.5, point() * 0.5]);
            let apart = triangle.clip(&bounds).is_empty();
            both[usize::from(apart)] += 1;
            // Only a touch within rounding may be judged differently.
            let judged_apart = !triangle.overlaps(&bounds, &mut ());
            if judged_apart != apart {
                let (smaller, larger) = (bounds.padded(-1e-5), bounds.padded(1e-5));
                assert!(!triangle.overlaps(&smaller, &mut ()) && triangle.overlaps(&larger, &mut ()));
            }
        }
        assert!(both[0] > 1000 && both[1] > 1000);
    }
}
