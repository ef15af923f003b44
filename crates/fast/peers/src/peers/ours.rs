//! Raystep's own.

use raystep_accel::{Mesh, Ray, Want};
use raystep_fast::{Fast, FastKind, Settings, Work};

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

    fn work(&self, rays: &[Ray], want: Want) -> Option<Work> {
        let mut work = Work::default();
        for ray in rays {
            self.0.walk(ray, want, &mut work);
        }
        Some(work)
    }

    fn bytes(&self) -> Option<usize> {
        Some(self.0.bytes())
    }
}

pub fn makers() -> Vec<Maker> {
    fn build(kind: FastKind, mesh: &Mesh, settings: &Settings) -> Box<dyn Peer> {
        match kind.build(mesh, settings) {
            raystep_fast::AnyFast::Bvh2(tree) => Box::new(Ours(tree)),
            raystep_fast::AnyFast::Bvh8(tree) => Box::new(Ours(tree)),
        }
    }
    vec![
        Maker { name: "fast-bvh2", build: |mesh| build(FastKind::Bvh2, mesh, &Settings::QUICK) },
        Maker { name: "fast-bvh2-dear", build: |mesh| build(FastKind::Bvh2, mesh, &Settings::DEAR) },
        Maker { name: "fast-bvh8", build: |mesh| build(FastKind::Bvh8, mesh, &Settings::QUICK) },
        Maker { name: "fast-bvh8-dear", build: |mesh| build(FastKind::Bvh8, mesh, &Settings::DEAR) },
    ]
}
