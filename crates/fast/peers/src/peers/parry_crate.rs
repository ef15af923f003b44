//! parry3d: the mesh of a physics engine.

use parry3d::math::Vector;
use parry3d::query::RayCast;
use parry3d::shape::{CompositeShapeRef, TriMesh};
use raystep_accel::{Hit, Mesh, Ray};

use super::{Maker, Peer, hit};

struct Parry(TriMesh);

fn ray(ray: &Ray) -> parry3d::query::Ray {
    parry3d::query::Ray::new(Vector::from(ray.o.to_array()), Vector::from(ray.d.to_array()))
}

impl Peer for Parry {
    fn nearest(&self, rays: &[Ray], hits: &mut [Option<Hit>]) {
        for (own, found) in rays.iter().zip(hits) {
            let nearest = CompositeShapeRef(&self.0).cast_local_ray(&ray(own), own.t_max.min(f32::MAX), false);
            *found = nearest.and_then(|(part, t)| hit(t, part));
        }
    }

    fn any(&self, rays: &[Ray], hits: &mut [bool]) {
        for (own, found) in rays.iter().zip(hits) {
            *found = self.0.intersects_local_ray(&ray(own), own.t_max.min(f32::MAX));
        }
    }

    fn bytes(&self) -> Option<usize> {
        None
    }
}

pub fn makers() -> Vec<Maker> {
    fn build(mesh: &Mesh) -> Box<dyn Peer> {
        let corners = mesh.corners.iter().map(|corner| Vector::from(corner.to_array())).collect();
        Box::new(Parry(TriMesh::new(corners, mesh.triangles.clone()).expect("a mesh of triangles")))
    }
    vec![Maker { name: "parry3d", build }]
}
