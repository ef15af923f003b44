//! Raystep's own.

use raystep_accel::{Hit, Mesh, Ray, Want};
use raystep_fast::{Any, Fast, FastKind, Isa, Nearest, Settings, Work};

use super::{Maker, Peer};

struct Ours<F>(F);

impl<F: Fast> Peer for Ours<F> {
    fn nearest(&self, rays: &[Ray], hits: &mut [Option<Hit>]) {
        self.0.ask_some(rays, hits, Nearest);
    }

    fn any(&self, rays: &[Ray], hits: &mut [bool]) {
        self.0.ask_some(rays, hits, Any);
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
        let built = kind.build(mesh, settings);
        // For those who want to know what other instructions make of it.
        let asked = std::env::var("RAYSTEP_ISA");
        let isa = Isa::all().into_iter().find(|isa| asked.as_deref() == Ok(isa.name()));
        Box::new(Ours(built.with(isa.unwrap_or(Isa::best()))))
    }
    vec![
        Maker { name: "fast-grid", build: |mesh| build(FastKind::Grid, mesh, &Settings::QUICK) },
        Maker { name: "fast-kd", build: |mesh| build(FastKind::Kd, mesh, &Settings::QUICK) },
        Maker { name: "fast-bvh2", build: |mesh| build(FastKind::Bvh2, mesh, &Settings::QUICK) },
        Maker { name: "fast-bvh2-dear", build: |mesh| build(FastKind::Bvh2, mesh, &Settings::DEAR) },
        Maker { name: "fast-bvh8", build: |mesh| build(FastKind::Bvh8, mesh, &Settings::QUICK) },
        Maker { name: "fast-bvh8-dear", build: |mesh| build(FastKind::Bvh8, mesh, &Settings::DEAR) },
        Maker { name: "fast-packets8", build: |mesh| build(FastKind::Packets8, mesh, &Settings::QUICK) },
        Maker { name: "fast-packets16", build: |mesh| build(FastKind::Packets16, mesh, &Settings::QUICK) },
    ]
}
