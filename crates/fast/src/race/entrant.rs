//! What runs on a rung.

use rayon::prelude::*;
use raystep_accel::{Accel, Cost, Hit, Mesh, Ray, Structure, Want};

use crate::{AnyFast, Fast, Work};

/// Something that answers rays.
pub(super) enum Entrant {
    /// A structure of the textbook, one ray after the other.
    Textbook(Structure),
    /// A fast structure on this thread.
    Alone(AnyFast),
    /// A fast structure on the threads of the current pool.
    Together(AnyFast),
}

impl Entrant {
    /// Answers rays, in their order.
    pub(super) fn ask(&self, mesh: &Mesh, rays: &[Ray], answers: &mut Vec<Option<Hit>>) {
        answers.clear();
        match self {
            Entrant::Textbook(structure) => {
                answers.extend(rays.iter().map(|ray| structure.intersect(mesh, ray, &mut ())));
            }
            Entrant::Alone(fast) => {
                answers.resize(rays.len(), None);
                fast.ask_some(rays, answers, crate::Nearest);
            }
            Entrant::Together(fast) => *answers = fast.intersect_many(rays),
        }
    }

    /// Tests of triangles, a ray; of rays in packets, as many as each makes alone.
    pub(super) fn tests_per_ray(&self, mesh: &Mesh, rays: &[Ray]) -> f64 {
        let one = |ray: &Ray| match self {
            Entrant::Textbook(structure) => {
                let mut cost = Cost::default();
                structure.intersect(mesh, ray, &mut cost);
                cost.prim_tests
            }
            Entrant::Alone(fast) | Entrant::Together(fast) => {
                let mut work = Work::default();
                fast.walk(ray, Want::Nearest, &mut work);
                work.triangles
            }
        };
        rays.par_iter().map(one).sum::<u64>() as f64 / rays.len().max(1) as f64
    }

    /// What it takes in memory beside the mesh, in bytes; a fast structure holds its triangles itself.
    pub(super) fn bytes(&self) -> u64 {
        match self {
            Entrant::Textbook(Structure::List(_)) => 0,
            Entrant::Textbook(structure) => structure.bytes() as u64,
            Entrant::Alone(fast) | Entrant::Together(fast) => fast.bytes() as u64,
        }
    }
}
