//! Several rays from one eye, made ready for lanes.

use bytemuck::cast_mut;
use raystep_accel::Hit;

use crate::judge::{NONE, Nearest};

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

impl<const G: usize> Beam<G> {
    /// To be filled.
    pub(super) const EMPTY: Beam<G> = Beam {
        o: [0.0; 3],
        d: [[[0.0; 8]; 3]; G],
        extreme: [[0.0; 3]; 2],
        down: [false; 3],
        axes: [0; 3],
        largest: 0.0,
        t_min: [[0.0; 8]; G],
    };
}

/// The nearest hits so far.
pub(super) struct Found<const G: usize> {
    pub(super) t: [[f32; 8]; G],
    pub(super) prims: [[u32; 8]; G],
}

impl<const G: usize> Found<G> {
    /// Nothing.
    pub(super) const NONE: Found<G> = Found { t: [[0.0; 8]; G], prims: [[NONE; 8]; G] };

    /// The t and the triangles of four rays: the first or the last of a group.
    #[inline(always)]
    pub(super) fn half(&mut self, group: usize, half: usize) -> (&mut [f32; 4], &mut [u32; 4]) {
        let t: &mut [[f32; 4]; 2] = cast_mut(&mut self.t[group]);
        let prims: &mut [[u32; 4]; 2] = cast_mut(&mut self.prims[group]);
        (&mut t[half & 1], &mut prims[half & 1])
    }

    /// The hit of a ray of a group.
    #[inline(always)]
    pub(super) fn hit(&self, group: usize, at: usize) -> Option<Hit> {
        Nearest::of(self.t[group][at], self.prims[group][at]).hit()
    }
}
