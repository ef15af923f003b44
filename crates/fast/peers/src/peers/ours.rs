//! Raystep's own.

use raystep_accel::{Mesh, Ray};
use raystep_fast::{Fast, FastKind, Settings};

use super::{Maker, NOTHING, Peer};

struct Ours<F>(F);

impl<F: Fast> Peer for Ours<F> {
    fn nearest(&self, rays: &[Ray], hits: &mut [(f32, u32)]) {
        for (ray, hit) in rays.iter().zip(hits) {
            *hit = self.0.intersect(ray).map_or(NOTHING, |hit| (hit.t, hit.prim.0));
        }
    }

    fn any(&self, rays: &[Ray], hits: &mut [bool]) {
        for (ray, hit) in rays.iter().zip(hits) {
            *hit = self.0.occluded(ray);
        }
    }

    fn bytes(&self) -> Option<usize> {
        Some(self.0.bytes())
    }
}

pub fn makers() -> Vec<Maker> {
    fn build(kind: FastKind, mesh: &Mesh) -> Box<dyn Peer> {
        match kind.build(mesh, &Settings::default()) {
            raystep_fast::AnyFast::Bvh2(tree) => Box::new(Ours(tree)),
            raystep_fast::AnyFast::Bvh8(tree) => Box::new(Ours(tree)),
        }
    }
    vec![
        Maker { name: "fast-bvh2", build: |mesh| build(FastKind::Bvh2, mesh) },
        Maker { name: "fast-bvh8", build: |mesh| build(FastKind::Bvh8, mesh) },
    ]
}
