//! What every fast structure can do.

use rayon::prelude::*;
use raystep_accel::{Hit, Ray, Want};

use crate::Count;

/// A structure over a mesh that answers as brute force does, quickly. It holds what it needs of the mesh.
pub trait Fast: Sync {
    /// The nearest hit, or any, counted by `count`: `()` counts nothing and costs nothing.
    fn walk(&self, ray: &Ray, want: Want, count: &mut impl Count) -> Option<Hit>;

    /// How much memory it takes, in bytes.
    fn bytes(&self) -> usize;

    /// The nearest hit in the ray's range: smallest t, then smallest id.
    #[inline]
    fn intersect(&self, ray: &Ray) -> Option<Hit> {
        self.walk(ray, Want::Nearest, &mut ())
    }

    /// Whether anything is hit in the ray's range.
    #[inline]
    fn occluded(&self, ray: &Ray) -> bool {
        self.walk(ray, Want::Any, &mut ()).is_some()
    }

    /// The answers to rays side by side; rays that run alike should stand together.
    fn intersect_some(&self, rays: &[Ray], hits: &mut [Option<Hit>]) {
        for (ray, hit) in rays.iter().zip(hits) {
            *hit = self.intersect(ray);
        }
    }

    /// The nearest hits of many rays, in their order, on the threads of the current pool. The same on any number of them.
    fn intersect_many(&self, rays: &[Ray]) -> Vec<Option<Hit>> {
        let mut hits = vec![None; rays.len()];
        let pieces = rays.par_chunks(TILE).zip(hits.par_chunks_mut(TILE));
        pieces.for_each(|(rays, hits)| self.intersect_some(rays, hits));
        hits
    }

    /// Whether each of many rays hits anything, in their order.
    fn occluded_many(&self, rays: &[Ray]) -> Vec<bool> {
        rays.par_iter().with_min_len(TILE).map(|ray| self.occluded(ray)).collect()
    }
}

/// So many rays are a piece of work for a thread.
const TILE: usize = 1024;
