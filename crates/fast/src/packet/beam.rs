//! Several rays from one eye, made ready for lanes.

use raystep_accel::{Hit, PrimId};

use crate::judge::NONE;

/// `G` groups of eight rays with one origin, whose directions have the same signs and the same largest axis.
pub(super) struct Beam<const G: usize> {
    /// The origin.
    pub(super) o: [f32; 3],
    /// The directions, an axis after the other. None counts as more than it is: see [`Shot`](crate::judge::Shot).
    pub(super) d: [[[f32; 8]; 3]; G],
    /// The least and the greatest of one over them.
    pub(super) extreme: [[f32; 3]; 2],
    /// Whether the rays run down each axis.
    pub(super) down: [bool; 3],
    /// The axes, the largest last.
    pub(super) axes: [usize; 3],
    /// The largest component of all directions.
    pub(super) largest: f32,
    /// The least t that counts.
    pub(super) t_min: [[f32; 8]; G],
}

/// The nearest hits so far.
pub(super) struct Found<const G: usize> {
    pub(super) t: [[f32; 8]; G],
    pub(super) prims: [[u32; 8]; G],
}

impl<const G: usize> Found<G> {
    /// The hits, in the order of the rays.
    #[inline(always)]
    pub(super) fn hits(&self) -> impl Iterator<Item = Option<Hit>> {
        let both = self.t.as_flattened().iter().zip(self.prims.as_flattened());
        both.map(|(&t, &prim)| (prim != NONE).then_some(Hit { t, prim: PrimId(prim), inner: None }))
    }
}
