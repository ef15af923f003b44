//! bvh: boxes along the ray, the nearest first.

use bvh::aabb::{Aabb, Bounded};
use bvh::bounding_hierarchy::BHShape;
use bvh::bvh::Bvh;
use nalgebra::{Point3, Vector3};
use raystep_accel::{Hit, Mesh, PrimId, Ray, Triangle};

use super::{Maker, Peer, hit, moeller_trumbore};

struct Own {
    triangle: Triangle,
    prim: u32,
    node: usize,
}

impl Bounded<f32, 3> for Own {
    fn aabb(&self) -> Aabb<f32, 3> {
        let bounds = self.triangle.bounds();
        Aabb::with_bounds(bounds.min.to_array().into(), bounds.max.to_array().into())
    }
}

impl BHShape<f32, 3> for Own {
    fn set_bh_node_index(&mut self, node: usize) {
        self.node = node;
    }

    fn bh_node_index(&self) -> usize {
        self.node
    }
}

struct Boxes {
    tree: Bvh<f32, 3>,
    shapes: Vec<Own>,
}

fn ray(ray: &Ray) -> bvh::ray::Ray<f32, 3> {
    bvh::ray::Ray::new(Point3::from(ray.o.to_array()), Vector3::from(ray.d.to_array()))
}

impl Peer for Boxes {
    fn nearest(&self, rays: &[Ray], hits: &mut [Option<Hit>]) {
        for (own, found) in rays.iter().zip(hits) {
            let ray = ray(own);
            let (mut t_best, mut best) = (own.t_max, None);
            for shape in self.tree.nearest_traverse_iterator(&ray, &self.shapes) {
                // The boxes come in order: what begins behind the best hit is of no use.
                if ray.intersection_slice_for_aabb(&shape.aabb()).is_some_and(|(near, _)| near > t_best) {
                    break;
                }
                if let Some(t) = moeller_trumbore(&shape.triangle, own).filter(|t| *t < t_best) {
                    (t_best, best) = (t, hit(t, shape.prim));
                }
            }
            *found = best;
        }
    }

    fn any(&self, rays: &[Ray], hits: &mut [bool]) {
        for (own, found) in rays.iter().zip(hits) {
            let ray = ray(own);
            let mut shapes = self.tree.traverse_iterator(&ray, &self.shapes);
            *found = shapes.any(|shape| moeller_trumbore(&shape.triangle, own).is_some());
        }
    }

    fn bytes(&self) -> Option<usize> {
        Some(size_of_val(&*self.tree.nodes) + size_of_val(&*self.shapes))
    }
}

pub fn makers() -> Vec<Maker> {
    fn build(mesh: &Mesh) -> Box<dyn Peer> {
        let own = |prim| Own { triangle: mesh.triangle(PrimId(prim)), prim, node: 0 };
        let mut shapes: Vec<Own> = (0..mesh.triangles.len() as u32).map(own).collect();
        let tree = Bvh::build(&mut shapes);
        Box::new(Boxes { tree, shapes })
    }
    vec![Maker { name: "bvh", build }]
}
