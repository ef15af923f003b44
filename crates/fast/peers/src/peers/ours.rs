//! Raystep's own.

use glam::Vec3;
use raystep_accel::{Aabb, Hit, Mesh, Ray, Want};
use raystep_fast::{Any, AnyFast, Below, Fast, FastKind, Isa, Nearest, Settings};

use super::{Maker, Peer};
use crate::counts::{Expected, Met};

struct Ours(AnyFast);

impl Peer for Ours {
    fn nearest(&self, rays: &[Ray], hits: &mut [Option<Hit>]) {
        self.0.ask_some(rays, hits, Nearest);
    }

    fn any(&self, rays: &[Ray], hits: &mut [bool]) {
        self.0.ask_some(rays, hits, Any);
    }

    fn met(&self, rays: &[Ray], want: Want) -> Option<Met> {
        let mut met = Met::default();
        for ray in rays {
            self.0.walk(ray, want, &mut met);
        }
        Some(met)
    }

    fn expected(&self) -> Option<Expected> {
        let AnyFast::Bvh2(tree) = &self.0 else { return None };
        let half_area = |side: Vec3| f64::from(side.x * side.y + side.y * side.z + side.z * side.x);
        let counts: Vec<usize> = tree.leaves().map(|leaf| leaf.len()).collect();
        let (mut root, mut expected) = (Aabb::EMPTY, Expected::default());
        for (at, sides) in tree.nodes().enumerate() {
            for (bounds, below) in sides.into_iter().flatten() {
                if at == 0 {
                    root = root.union(bounds);
                }
                let area = half_area(bounds.extent());
                match below {
                    Below::Node(_) => expected.nodes += area,
                    Below::Leaf(leaf) => {
                        expected.leaves += area;
                        expected.triangles += area * counts[leaf] as f64;
                    }
                }
            }
        }
        let all = half_area(root.extent());
        let Expected { nodes, leaves, triangles } = expected;
        Some(Expected { nodes: 1.0 + nodes / all, leaves: leaves / all, triangles: triangles / all })
    }

    fn packets(&self, rays: &[Ray], want: Want) -> Option<(Met, usize)> {
        let AnyFast::Packets(packets) = &self.0 else { return None };
        let mut met = Met::default();
        // Only packets to the nearest hits walk together.
        let together = if want == Want::Nearest { packets.count(rays, &mut met) } else { 0 };
        (together > 0).then_some((met, together))
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
