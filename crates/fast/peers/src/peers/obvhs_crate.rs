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
use raystep_accel::{Hit, Mesh, PrimId, Ray, Want};
use raystep_fast::Count;

use super::{Maker, Peer};
use crate::counts::{Expected, Met};

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

/// A tree that is walked here to be counted.
trait Walk {
    /// Counts what a ray meets, if that is known.
    fn walk(&self, _ray: obvhs::ray::Ray, _want: Want, _met: &mut Met) -> bool {
        false
    }

    fn expected(&self) -> Option<Expected> {
        None
    }
}

impl Walk for Eight {}

impl Walk for Two {
    fn expected(&self) -> Option<Expected> {
        let nodes = &self.tree.nodes;
        let mut expected = Expected::default();
        for node in nodes.iter() {
            let part = f64::from(node.aabb().half_area() / nodes[0].aabb().half_area());
            if node.is_leaf() {
                expected.leaves += part;
                expected.triangles += part * f64::from(node.prim_count);
            } else {
                expected.nodes += part;
            }
        }
        Some(expected)
    }

    /// As obvhs 0.4 does in `ray_traverse_dynamic`, line by line; a node is a pair of boxes.
    fn walk(&self, mut ray: obvhs::ray::Ray, want: Want, met: &mut Met) -> bool {
        let nodes = &self.tree.nodes;
        let mut waiting = Vec::new();
        let Some(root) = nodes.first().filter(|root| !root.is_leaf()) else { return true };
        if root.aabb().intersect_ray(&ray) >= ray.tmax {
            return true;
        }
        let mut here = root.first_index as usize;
        loop {
            met.node(2);
            let (mut near, mut far) = (&nodes[here], &nodes[here + 1]);
            let (mut near_t, mut far_t) = (near.aabb().intersect_ray(&ray), far.aabb().intersect_ray(&ray));
            if near_t > far_t {
                std::mem::swap(&mut near_t, &mut far_t);
                std::mem::swap(&mut near, &mut far);
            }
            let mut next = None;
            for (node, t) in [(near, near_t), (far, far_t)] {
                if t >= ray.tmax {
                    continue;
                }
                if !node.is_leaf() {
                    match next {
                        None => next = Some(node.first_index),
                        Some(_) => waiting.push(node.first_index),
                    }
                    continue;
                }
                met.triangles(node.prim_count);
                for triangle in &self.triangles[node.first_index as usize..][..node.prim_count as usize] {
                    let t = triangle.intersect(&ray);
                    if t < ray.tmax {
                        ray.tmax = t;
                        if want == Want::Any {
                            return true;
                        }
                    }
                }
            }
            let Some(next) = next.or_else(|| waiting.pop()) else { return true };
            here = next as usize;
        }
    }
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

            fn met(&self, rays: &[Ray], want: Want) -> Option<Met> {
                let mut met = Met::default();
                let counts = rays.iter().all(|own| self.walk(ray(own), want, &mut met));
                counts.then_some(met)
            }

            fn expected(&self) -> Option<Expected> {
                Walk::expected(self)
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
