//! obvhs: two children to a node, and eight in compressed nodes.

use std::time::Duration;

use glam::Vec3A;
use obvhs::BvhBuildParams;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::builder::build_bvh2_from_tris;
use obvhs::cwbvh::CwBvh;
use obvhs::cwbvh::builder::build_cwbvh_from_tris;
use obvhs::ray::RayHit;
use obvhs::rt_triangle::RtTriangle;
use obvhs::triangle::Triangle;
use raystep_accel::{Hit, Mesh, PrimId, Ray};

use super::{Maker, Peer};

struct Two {
    tree: Bvh2,
    triangles: Vec<RtTriangle>,
}

struct Eight {
    tree: CwBvh,
    triangles: Vec<RtTriangle>,
}

fn triangles(mesh: &Mesh) -> Vec<Triangle> {
    let triangle = |prim| {
        let triangle = mesh.triangle(PrimId(prim));
        Triangle { v0: triangle.a.into(), v1: triangle.b.into(), v2: triangle.c.into() }
    };
    (0..mesh.triangles.len() as u32).map(triangle).collect()
}

/// In the order in which the tree wants them.
fn in_order(triangles: &[Triangle], order: &[u32]) -> Vec<RtTriangle> {
    order.iter().map(|&prim| RtTriangle::from(&triangles[prim as usize])).collect()
}

fn two(mesh: &Mesh, settings: BvhBuildParams) -> Box<dyn Peer> {
    let triangles = triangles(mesh);
    let tree = build_bvh2_from_tris(&triangles, settings, &mut Duration::default());
    let triangles = in_order(&triangles, &tree.primitive_indices);
    Box::new(Two { tree, triangles })
}

fn eight(mesh: &Mesh, settings: BvhBuildParams) -> Box<dyn Peer> {
    let triangles = triangles(mesh);
    let tree = build_cwbvh_from_tris(&triangles, settings, &mut Duration::default());
    let triangles = in_order(&triangles, &tree.primitive_indices);
    Box::new(Eight { tree, triangles })
}

fn ray(ray: &Ray) -> obvhs::ray::Ray {
    obvhs::ray::Ray::new(Vec3A::from(ray.o), Vec3A::from(ray.d), ray.t_min, ray.t_max)
}

macro_rules! peer {
    ($kind:ident) => {
        impl Peer for $kind {
            fn nearest(&self, rays: &[Ray], hits: &mut [Option<Hit>]) {
                for (own, found) in rays.iter().zip(hits) {
                    let mut hit = RayHit::none();
                    self.tree.ray_traverse(ray(own), &mut hit, |ray, id| self.triangles[id].intersect(ray));
                    *found = (hit.primitive_id != u32::MAX)
                        .then(|| super::hit(hit.t, self.tree.primitive_indices[hit.primitive_id as usize]))
                        .flatten();
                }
            }

            fn any(&self, rays: &[Ray], hits: &mut [bool]) {
                for (own, found) in rays.iter().zip(hits) {
                    *found = !self.tree.ray_traverse_miss(ray(own), |ray, id| self.triangles[id].intersect(ray));
                }
            }

            fn bytes(&self) -> Option<usize> {
                let tree = size_of_val(&*self.tree.nodes) + size_of_val(&*self.tree.primitive_indices);
                Some(tree + size_of_val(&*self.triangles))
            }
        }
    };
}

peer!(Two);
peer!(Eight);

pub fn makers() -> Vec<Maker> {
    vec![
        Maker { name: "obvhs-bvh2-medium", build: |mesh| two(mesh, BvhBuildParams::medium_build()) },
        Maker { name: "obvhs-bvh2-very-slow", build: |mesh| two(mesh, BvhBuildParams::very_slow_build()) },
        Maker { name: "obvhs-cwbvh-medium", build: |mesh| eight(mesh, BvhBuildParams::medium_build()) },
        Maker { name: "obvhs-cwbvh-very-slow", build: |mesh| eight(mesh, BvhBuildParams::very_slow_build()) },
    ]
}
