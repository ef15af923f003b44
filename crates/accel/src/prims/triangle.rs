//! The triangle, met without leaks: Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection" (JCGT 2013).

use glam::{DVec3, Vec3};

use super::clip::clip_polygon;
use crate::{Aabb, Ray};

/// Three corners; both sides are met.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle {
    /// First corner.
    pub a: Vec3,
    /// Second corner.
    pub b: Vec3,
    /// Third corner.
    pub c: Vec3,
}

/// Thinner than this part of its distance, and a triangle counts as seen edge-on: the double precision
/// that is left would no longer say where along the ray it is met.
const EDGE_ON: f64 = 1e-10;

impl Triangle {
    /// The smallest box around it.
    pub fn bounds(&self) -> Aabb {
        Aabb { min: self.a.min(self.b).min(self.c), max: self.a.max(self.b).max(self.c) }
    }

    /// A small box around the part of it that lies in `bounds`.
    pub fn clip(&self, bounds: &Aabb) -> Aabb {
        clip_polygon(&[self.a, self.b, self.c], bounds)
    }

    /// The t at which the ray's line meets it, whatever the ray's range.
    ///
    /// A triangle seen edge-on, or one without area, is not met. The paper works in single precision and
    /// goes over to double on an edge; here all of it is double, so that the t of a slanted triangle is
    /// as good as that of any other.
    pub(super) fn meet(&self, ray: &Ray) -> Option<f32> {
        let (o, d) = (ray.o.as_dvec3(), ray.d.as_dvec3());
        // The ray runs along its largest component, z; the other two are sheared away.
        let z = largest(d);
        let (x, y) = ((z + 1) % 3, (z + 2) % 3);
        let (shear_x, shear_y) = (d[x] / d[z], d[y] / d[z]);
        let sheared = |p: Vec3| {
            let p = p.as_dvec3() - o;
            DVec3::new(p[x] - shear_x * p[z], p[y] - shear_y * p[z], p[z])
        };
        let (a, b, c) = (sheared(self.a), sheared(self.b), sheared(self.c));

        // Twice the signed areas that the ray makes with each edge. A neighbour that shares the edge gets
        // exactly the negative, so no ray slips through between the two.
        let u = c.x * b.y - c.y * b.x;
        let v = a.x * c.y - a.y * c.x;
        let w = b.x * a.y - b.y * a.x;
        if (u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0) {
            return None;
        }
        let area = u + v + w;
        let most = a.abs().max(b.abs()).max(c.abs());
        if area.abs() <= EDGE_ON * most.z * most.x.max(most.y) {
            return None;
        }
        // The corners' distances, weighed by the areas.
        Some(((u * a.z + v * b.z + w * c.z) / area / d[z]) as f32)
    }
}

/// The index of the component with the largest absolute value.
fn largest(d: DVec3) -> usize {
    let d = d.abs();
    if d.x >= d.y && d.x >= d.z {
        0
    } else if d.y >= d.z {
        1
    } else {
        2
    }
}
