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
    /// A triangle seen edge-on, or one without area, is not met.
    pub(super) fn meet(&self, ray: &Ray) -> Option<f32> {
        // The ray runs along its largest component; the other two are sheared away.
        let z = largest(ray.d);
        let (x, y) = ((z + 1) % 3, (z + 2) % 3);
        let (shear_x, shear_y) = (ray.d[x] / ray.d[z], ray.d[y] / ray.d[z]);
        let sheared = |p: Vec3| {
            let p = p - ray.o;
            (p[x] - shear_x * p[z], p[y] - shear_y * p[z], p[z])
        };
        let (a, b, c) = (sheared(self.a), sheared(self.b), sheared(self.c));

        // Twice the signed areas that the ray makes with each edge.
        let u = [c.0 * b.1, c.1 * b.0];
        let v = [a.0 * c.1, a.1 * c.0];
        let w = [b.0 * a.1, b.1 * a.0];
        let (area_u, area_v, area_w) = (u[0] - u[1], v[0] - v[1], w[0] - w[1]);
        if (area_u < 0.0 || area_v < 0.0 || area_w < 0.0) && (area_u > 0.0 || area_v > 0.0 || area_w > 0.0) {
            return None;
        }

        // Exactly on an edge, or so slanted that cancellation ate the digits: again in double precision.
        let det = area_u + area_v + area_w;
        let size = [u, v, w].iter().flatten().fold(0.0_f32, |sum, product| sum + product.abs());
        if area_u == 0.0 || area_v == 0.0 || area_w == 0.0 || det.abs() * 16.0 < size {
            return self.meet_in_double(ray, x, y, z);
        }
        // The corners' distances, weighed by the areas.
        Some((area_u * a.2 + area_v * b.2 + area_w * c.2) / det / ray.d[z])
    }

    fn meet_in_double(&self, ray: &Ray, x: usize, y: usize, z: usize) -> Option<f32> {
        let (o, d) = (ray.o.as_dvec3(), ray.d.as_dvec3());
        let sheared = |p: Vec3| {
            let p: DVec3 = p.as_dvec3() - o;
            (p[x] - d[x] / d[z] * p[z], p[y] - d[y] / d[z] * p[z], p[z])
        };
        let (a, b, c) = (sheared(self.a), sheared(self.b), sheared(self.c));
        let u = c.0 * b.1 - c.1 * b.0;
        let v = a.0 * c.1 - a.1 * c.0;
        let w = b.0 * a.1 - b.1 * a.0;
        if (u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0) {
            return None;
        }
        let det = u + v + w;
        if det == 0.0 {
            return None;
        }
        Some(((u * a.2 + v * b.2 + w * c.2) / det / d[z]) as f32)
    }
}

/// The index of the component with the largest absolute value.
fn largest(d: Vec3) -> usize {
    let d = d.abs();
    if d.x >= d.y && d.x >= d.z {
        0
    } else if d.y >= d.z {
        1
    } else {
        2
    }
}
