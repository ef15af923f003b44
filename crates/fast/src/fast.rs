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

    /// The answers to rays one after the other, on this thread. Quicker than one call a ray; rays that run alike should
    /// stand together.
    fn ask_some<T>(&self, rays: &[Ray], answers: &mut [T], question: impl Question<T>) {
        for (ray, answer) in rays.iter().zip(answers) {
            *answer = question.answer(self.walk(ray, question.want(), &mut ()));
        }
    }

    /// The answers to many rays, in their order, on the threads of the current pool. The same on any number of them.
    fn ask_many<T: Clone + Send>(&self, rays: &[Ray], question: impl Question<T>) -> Vec<T> {
        let mut answers = vec![question.answer(None); rays.len()];
        let tiles = rays.par_chunks(TILE).zip(answers.par_chunks_mut(TILE));
        tiles.for_each(|(rays, answers)| self.ask_some(rays, answers, question));
        answers
    }

    /// The nearest hits of many rays: see [`ask_many`](Fast::ask_many).
    fn intersect_many(&self, rays: &[Ray]) -> Vec<Option<Hit>> {
        self.ask_many(rays, Nearest)
    }

    /// Whether each of many rays hits anything: see [`ask_many`](Fast::ask_many).
    fn occluded_many(&self, rays: &[Ray]) -> Vec<bool> {
        self.ask_many(rays, Any)
    }
}

/// What is asked of rays, and what form the answers have.
pub trait Question<T>: Copy + Sync {
    /// What a walk has to find.
    fn want(&self) -> Want;
    /// The answer for what it found.
    fn answer(&self, found: Option<Hit>) -> T;
}

/// The nearest hit.
#[derive(Clone, Copy, Debug)]
pub struct Nearest;

impl Question<Option<Hit>> for Nearest {
    #[inline(always)]
    fn want(&self) -> Want {
        Want::Nearest
    }

    #[inline(always)]
    fn answer(&self, found: Option<Hit>) -> Option<Hit> {
        found
    }
}

/// Whether there is any hit.
#[derive(Clone, Copy, Debug)]
pub struct Any;

impl Question<bool> for Any {
    #[inline(always)]
    fn want(&self) -> Want {
        Want::Any
    }

    #[inline(always)]
    fn answer(&self, found: Option<Hit>) -> bool {
        found.is_some()
    }
}

/// So many rays are a piece of work for a thread.
const TILE: usize = 1024;
