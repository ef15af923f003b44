//! A point and a triangle: the areas that it makes with the edges (Ericson, "Real-Time Collision Detection",
//! section 5.4.2).

use glam::Vec3;

use super::Probe;
use crate::{Observer, Triangle};

impl Triangle {
    /// Whether the point lies over the triangle, seen along the triangle's normal. In one without area
    /// no point does.
    pub fn holds(&self, p: Vec3, watch: &mut impl Observer<Probe>) -> bool {
        let p = p.as_dvec3();
        let [a, b, c] = [self.a, self.b, self.c].map(|corner| corner.as_dvec3() - p);
        let normal = (b - a).cross(c - a);
        // Along the normal, the area of the point with each edge.
        let (u, v, w) = (normal.dot(b.cross(c)), normal.dot(c.cross(a)), normal.dot(a.cross(b)));
        let inside = normal.length_squared() > 0.0 && u >= 0.0 && v >= 0.0 && w >= 0.0;
        watch.on(Probe::Areas { u: u as f32, v: v as f32, w: w as f32, inside });
        inside
    }
}
