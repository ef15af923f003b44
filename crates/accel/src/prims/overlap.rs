//! Whether a triangle and a box share a point (Akenine-Möller, "Fast 3D triangle-box overlap testing", 2001).

use glam::Vec3;

use super::Triangle;
use crate::{Aabb, Axis};

impl Triangle {
    /// Whether it touches the box. Two convex bodies are apart exactly if some axis separates their
    /// shadows; here thirteen axes are enough.
    pub fn overlaps(&self, bounds: &Aabb) -> bool {
        // Seen from the middle of the box.
        let center = bounds.center();
        let half = bounds.extent() * 0.5;
        let corners = [self.a - center, self.b - center, self.c - center];
        let edges = [self.b - self.a, self.c - self.b, self.a - self.c];
        let axes = [Vec3::X, Vec3::Y, Vec3::Z];

        // The three normals of the box.
        let box_axes_overlap = Axis::ALL.iter().all(|&axis| {
            let [a, b, c] = corners.map(|corner| corner[axis]);
            a.min(b).min(c) <= half[axis] && a.max(b).max(c) >= -half[axis]
        });
        box_axes_overlap
            // The triangle's normal.
            && shadows_overlap(edges[0].cross(edges[1]), &corners, half)
            // The cross products of their edges.
            && edges.iter().all(|edge| axes.iter().all(|axis| shadows_overlap(axis.cross(*edge), &corners, half)))
    }
}

/// Whether the shadows of corners and box on `along` overlap. On no axis at all, as of a triangle
/// without area, they do.
fn shadows_overlap(along: Vec3, corners: &[Vec3; 3], half: Vec3) -> bool {
    let [a, b, c] = corners.map(|corner| along.dot(corner));
    let reach = along.abs().dot(half);
    a.min(b).min(c) <= reach && a.max(b).max(c) >= -reach
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
        assert!(!beside.overlaps(&unit));
        // It touches the corner (1, 1, 0) exactly.
        let touching =
            Triangle { a: Vec3::new(2.0, 0.0, 0.0), b: Vec3::new(0.0, 2.0, 0.0), c: Vec3::new(2.0, 2.0, 0.0) };
        assert!(touching.overlaps(&unit));
        // A needle and a point have no normal.
        let needle = Triangle { a: Vec3::splat(0.5), b: Vec3::splat(3.0), c: Vec3::splat(2.0) };
        let point = Triangle { a: Vec3::splat(0.5), b: Vec3::splat(0.5), c: Vec3::splat(0.5) };
        assert!(needle.overlaps(&unit) && point.overlaps(&unit));
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
            let judged_apart = !triangle.overlaps(&bounds);
            if judged_apart != apart {
                assert!(!triangle.overlaps(&bounds.padded(-1e-5)) && triangle.overlaps(&bounds.padded(1e-5)));
            }
        }
        assert!(both[0] > 1000 && both[1] > 1000);
    }
}
