//! A ray and a triangle, without leaks: Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection" (JCGT 2013).

use glam::{DVec3, Vec3};

use super::{Part, Probe, largest};
use crate::{Axis, Observer, Ray, Triangle};

/// Thinner than this part of its distance, and a triangle counts as seen edge-on: the double precision
/// that is left would no longer say where along the ray it is met.
const EDGE_ON: f64 = 1e-10;

impl Triangle {
    /// The t at which the ray's line meets it, whatever the ray's range.
    ///
    /// A triangle seen edge-on, or one without area, is not met. The paper works in single precision and
    /// goes over to double on an edge; here all of it is double, so that the t of a slanted triangle is
    /// as good as that of any other.
    pub(crate) fn meet(&self, ray: &Ray, watch: &mut impl Observer<Probe>) -> Option<f32> {
        let (o, d) = (ray.o.as_dvec3(), ray.d.as_dvec3());
        // The ray runs along its largest component, z; the other two are sheared away.
        let z = largest(d);
        let (x, y) = ((z + 1) % 3, (z + 2) % 3);
        let (shear_x, shear_y) = (d[x] / d[z], d[y] / d[z]);
        watch.on(Probe::Shear { along: Axis::ALL[z], x: shear_x as f32, y: shear_y as f32 });
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
        let inside = !((u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0));
        watch.on(Probe::Areas { u: u as f32, v: v as f32, w: w as f32, inside });
        if !inside {
            return None;
        }
        let area = u + v + w;
        let most = a.abs().max(b.abs()).max(c.abs());
        let limit = EDGE_ON * most.z * most.x.max(most.y);
        if area.abs() <= limit {
            watch.on(Probe::Parallel { of: Part::Plane, slant: area as f32, limit: limit as f32 });
            return None;
        }
        // The corners' distances, weighed by the areas.
        let height = u * a.z + v * b.z + w * c.z;
        let t = height / area / d[z];
        let (height, slant) = (height as f32, (area * d[z]) as f32);
        watch.on(Probe::Cut { of: Part::Plane, height, slant, t: t as f32 });
        Some(t as f32)
    }
}
