//! Whether answers can be right, in double precision and by another formula.

use glam::DVec3;
use raystep_accel::{Hit, Mesh, PrimId, Ray};

/// How answers fare beside the truth.
#[derive(Default)]
pub struct Report {
    pub hits: usize,
    /// The triangle is not met there, or the truth is nearer by more than single precision explains, or a miss is none.
    pub wrong: usize,
}

/// Peers answer in single precision and not watertight: so much of the distance they may be off, and so many rays of a
/// thousand may slip through an edge.
const OFF: f64 = 2e-3;
pub const SLIPS: f64 = 0.004;

/// Compares answers with those of Raystep, which are exact, and those in turn with double precision.
pub fn report(mesh: &Mesh, rays: &[Ray], truth: &[Option<Hit>], found: &[Option<Hit>]) -> Report {
    let mut report = Report::default();
    for ((ray, truth), found) in rays.iter().zip(truth).zip(found) {
        report.hits += usize::from(found.is_some());
        let is_right = match (truth, found) {
            (None, None) => true,
            (Some(truth), Some(found)) => {
                let (t, t_true) = (f64::from(found.t), f64::from(truth.t));
                (t - t_true).abs() <= OFF * t_true.abs() + 1e-5 && lies_on(mesh, ray, t, found.prim)
            }
            _ => false,
        };
        report.wrong += usize::from(!is_right);
    }
    report
}

/// Whether the point at t lies on the triangle, but for rounding.
fn lies_on(mesh: &Mesh, ray: &Ray, t: f64, prim: PrimId) -> bool {
    let triangle = mesh.triangle(prim);
    let [a, b, c] = [triangle.a, triangle.b, triangle.c].map(|p| p.as_dvec3());
    let (o, d): (DVec3, DVec3) = (ray.o.as_dvec3(), ray.d.as_dvec3());
    let p = o + d * t;
    let n = (b - a).cross(c - a);
    let slack = 1e-4 * (p - o).length().max((b - a).length());
    let inside = [(a, b), (b, c), (c, a)].iter().all(|&(from, to)| {
        let edge = to - from;
        n.normalize_or_zero().dot(edge.cross(p - from)) >= -slack * edge.length()
    });
    inside && n.normalize_or_zero().dot(p - a).abs() <= slack
}
