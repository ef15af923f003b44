//! The primitives of any scene.

use super::Instances;
use crate::{Accel, Best, Hit, List, Mesh, Observer, PrimId, Primitives, Ray, Shape, Visit};

/// The primitives of a scene: triangles in bulk, or a few of any kind.
#[derive(Clone, Debug)]
pub enum Prims {
    /// Triangles only, in plain arrays.
    Mesh(Mesh),
    /// A mixture, for flat scenes and small examples.
    Few(Vec<Shape<'static>>),
    /// Models, each stored once and placed many times.
    Instances(Instances),
}

impl Prims {
    /// The judge of every structure: the nearest hit by testing everything, the triangles of instances as well.
    pub fn brute_force(&self, ray: &Ray) -> Option<Hit> {
        match self {
            Prims::Instances(instances) => instances.brute_force(ray),
            Prims::Mesh(_) | Prims::Few(_) => List.intersect(self, ray, &mut ()),
        }
    }

    /// The shape that a hit met, world space: for pictures.
    pub fn met(&self, hit: &Hit) -> Shape<'_> {
        match (self, hit.inner) {
            (Prims::Instances(instances), Some(inner)) => Shape::Triangle(instances.triangle(hit.prim, inner)),
            _ => self.shape(hit.prim),
        }
    }
}

impl Primitives for Prims {
    #[inline]
    fn len(&self) -> usize {
        match self {
            Prims::Mesh(mesh) => mesh.len(),
            Prims::Few(shapes) => shapes.len(),
            Prims::Instances(instances) => instances.len(),
        }
    }

    #[inline]
    fn shape(&self, prim: PrimId) -> Shape<'_> {
        match self {
            Prims::Mesh(mesh) => mesh.shape(prim),
            Prims::Few(shapes) => shapes[prim.index()],
            Prims::Instances(instances) => instances.shape(prim),
        }
    }

    #[inline]
    fn intersect(&self, prim: PrimId, ray: &Ray) -> Option<f32> {
        match self {
            Prims::Mesh(mesh) => mesh.intersect(prim, ray),
            Prims::Few(shapes) => shapes.as_slice().intersect(prim, ray),
            Prims::Instances(instances) => instances.intersect(prim, ray),
        }
    }

    #[inline]
    fn test(&self, prim: PrimId, ray: &Ray, best: &mut Best, watch: &mut impl Observer<Visit>) {
        match self {
            Prims::Mesh(mesh) => mesh.test(prim, ray, best, watch),
            Prims::Few(shapes) => shapes.as_slice().test(prim, ray, best, watch),
            Prims::Instances(instances) => instances.test(prim, ray, best, watch),
        }
    }
}
