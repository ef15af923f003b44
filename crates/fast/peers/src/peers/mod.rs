//! Who takes part.

pub mod bvh_crate;
pub mod embree;
pub mod obvhs_crate;
pub mod ours;
pub mod parry_crate;

use raystep_accel::{Hit, Mesh, PrimId, Ray, Triangle, Want};

use crate::counts::{Expected, Met};

/// A hit as Raystep tells it.
pub fn hit(t: f32, prim: u32) -> Option<Hit> {
    Some(Hit { t, prim: PrimId(prim), inner: None })
}

/// A structure over a mesh.
pub trait Peer {
    /// The nearest hits.
    fn nearest(&self, rays: &[Ray], hits: &mut [Option<Hit>]);
    /// Whether anything is hit.
    fn any(&self, rays: &[Ray], hits: &mut [bool]);
    /// What the rays meet on their ways, where it is counted.
    fn met(&self, _rays: &[Ray], _want: Want) -> Option<Met> {
        None
    }
    /// What a line is expected to meet, where the tree can be seen.
    fn expected(&self) -> Option<Expected> {
        None
    }
    /// What packets of rays meet, where any walk together, and how many those are.
    fn packets(&self, _rays: &[Ray], _want: Want) -> Option<(Met, usize)> {
        None
    }
    /// Its size in bytes, where it can be told.
    fn bytes(&self) -> Option<usize>;
}

/// A way to build one.
pub struct Maker {
    pub name: &'static str,
    pub build: fn(&Mesh) -> Box<dyn Peer>,
}

/// All of them; the first is what the others are compared with.
pub fn makers() -> Vec<Maker> {
    let mut makers = obvhs_crate::makers();
    makers.extend(ours::makers());
    makers.extend(bvh_crate::makers());
    makers.extend(parry_crate::makers());
    makers.extend(embree::makers());
    makers
}

/// Where a ray meets a triangle, for peers that leave that to others: Möller and Trumbore (1997), single precision.
fn moeller_trumbore(triangle: &Triangle, ray: &Ray) -> Option<f32> {
    let (ab, ac) = (triangle.b - triangle.a, triangle.c - triangle.a);
    let across = ray.d.cross(ac);
    let part = 1.0 / ab.dot(across);
    let from_a = ray.o - triangle.a;
    let u = from_a.dot(across) * part;
    let turned = from_a.cross(ab);
    let v = ray.d.dot(turned) * part;
    let t = ac.dot(turned) * part;
    (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && ray.t_min <= t && t <= ray.t_max).then_some(t)
}
