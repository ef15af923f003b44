//! What answers the rays of a picture: a structure of the textbook, a fast one, or one that keeps what it was asked.

use std::sync::{Mutex, PoisonError};

use raystep_accel::{Accel, Cost, Hit, Prims, Ray, Structure, Want};

use super::standing;

/// What answers the rays of a picture.
pub(super) trait Through: Sync {
    fn nearest(&self, ray: &Ray, cost: &mut Cost) -> Option<Hit>;
    fn any(&self, ray: &Ray, cost: &mut Cost) -> bool;
}

/// A structure of the textbook.
pub(super) struct Textbook<'a> {
    pub(super) structure: &'a Structure,
    pub(super) prims: &'a Prims,
}

impl Through for Textbook<'_> {
    fn nearest(&self, ray: &Ray, cost: &mut Cost) -> Option<Hit> {
        self.structure.intersect(self.prims, ray, cost)
    }

    fn any(&self, ray: &Ray, cost: &mut Cost) -> bool {
        self.structure.occluded(self.prims, ray, cost)
    }
}

/// A fast structure: it answers as the textbook does, to the bit.
pub(super) struct Quick<'a> {
    pub(super) fast: &'a standing::Quick,
}

impl Through for Quick<'_> {
    fn nearest(&self, ray: &Ray, _: &mut Cost) -> Option<Hit> {
        self.fast.nearest(ray)
    }

    fn any(&self, ray: &Ray, _: &mut Cost) -> bool {
        self.fast.any(ray)
    }
}

/// Keeps what was asked.
pub(super) struct Asked<'a> {
    through: &'a Textbook<'a>,
    rays: Mutex<Vec<(Ray, Want)>>,
}

impl<'a> Asked<'a> {
    pub(super) fn new(through: &'a Textbook<'a>) -> Asked<'a> {
        Asked { through, rays: Mutex::default() }
    }

    /// What was asked since the last call.
    pub(super) fn take(&self) -> Vec<(Ray, Want)> {
        std::mem::take(&mut *self.rays.lock().unwrap_or_else(PoisonError::into_inner))
    }

    fn keep(&self, ray: &Ray, want: Want) {
        self.rays.lock().unwrap_or_else(PoisonError::into_inner).push((*ray, want));
    }
}

impl Through for Asked<'_> {
    fn nearest(&self, ray: &Ray, cost: &mut Cost) -> Option<Hit> {
        self.keep(ray, Want::Nearest);
        self.through.nearest(ray, cost)
    }

    fn any(&self, ray: &Ray, cost: &mut Cost) -> bool {
        self.keep(ray, Want::Any);
        self.through.any(ray, cost)
    }
}
