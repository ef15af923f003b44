//! A segment of the plane, standing upright: what a flat scene calls a line.

use glam::{DVec2, Vec2, Vec3};

use super::clip::clip_polygon;
use crate::{Aabb, Ray};

/// The upright rectangle over the segment from `from` to `to`, between `z[0]` and `z[1]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wall {
    /// One end, x and y.
    pub from: Vec2,
    /// The other end.
    pub to: Vec2,
    /// Its foot and its head.
    pub z: [f32; 2],
}

/// The sine of the angle below which a ray counts as parallel to a wall.
const PARALLEL: f64 = 1e-10;

impl Wall {
    /// The smallest box around it.
    pub fn bounds(&self) -> Aabb {
        Aabb { min: self.from.min(self.to).extend(self.z[0]), max: self.from.max(self.to).extend(self.z[1]) }
    }

    /// A small box around the part of it that lies in `bounds`.
    pub fn clip(&self, bounds: &Aabb) -> Aabb {
        let corner = |p: Vec2, z: f32| -> Vec3 { p.extend(z) };
        let [foot, head] = self.z;
        clip_polygon(
            &[corner(self.from, foot), corner(self.to, foot), corner(self.to, head), corner(self.from, head)],
            bounds,
        )
    }

    /// The t at which the ray's line meets it; a ray in the wall's own plane does not.
    pub(super) fn meet(&self, ray: &Ray) -> Option<f32> {
        let (o, d) = (ray.o.as_dvec3(), ray.d.as_dvec3());
        let along = self.to.as_dvec2() - self.from.as_dvec2();
        let f = self.from.as_dvec2() - DVec2::new(o.x, o.y);
        let slant = DVec2::new(d.x, d.y).perp_dot(along);
        // Parallel, or so nearly that double precision would not say where they meet.
        if slant.abs() <= PARALLEL * DVec2::new(d.x, d.y).length() * along.length() {
            return None;
        }
        let t = f.perp_dot(along) / slant;
        let s = f.perp_dot(DVec2::new(d.x, d.y)) / slant;
        let z = o.z + d.z * t;
        let inside = (0.0..=1.0).contains(&s) && f64::from(self.z[0]) <= z && z <= f64::from(self.z[1]);
        inside.then_some(t as f32)
    }
}
