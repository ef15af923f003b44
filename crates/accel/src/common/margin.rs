//! How much room rounding needs.

use glam::Vec3;

use super::bars::bars_length;
use crate::geometry::digits::{STEPS, length};
use crate::{Aabb, Ray, Visit};

/// Structures that cut space keep a primitive out of a cell that its box meets but the primitive does
/// not. Rounding may carry a ray past the very cell in which it meets the primitive, so such a test
/// asks for a cell larger by `pad` on all sides.
///
/// A walk errs by a few roundings of its distance from the origin of the ray. `pad` is a 2048th of the
/// box, which covers every ray that starts within `reach` (64 diagonals) of its middle, or a smaller part for a
/// smaller reach. A ray from further away cannot be told which cells it meets, nor can one so fast that its t, of
/// which the smallest lie in steps, does not tell places a pad apart: the structures answer it by brute force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Margin {
    /// By how much a cell is larger when references are pruned, in world units.
    pub pad: f32,
    /// How far from the middle of the box a ray may start, in world units.
    pub reach: f32,
    /// How long the largest component of a ray's direction may be.
    pub longest: f32,
    center: Vec3,
}

impl Margin {
    /// The margin for a structure over so many primitives with `bounds` around them all.
    ///
    /// Were the pad as large as the primitives, each would lie in many cells: a finer scene has a smaller pad,
    /// for rays from less far away. Triangles of a surface become narrower as the root of their number.
    pub fn of(bounds: &Aabb, count: usize) -> Margin {
        let finer = (count as f32 / Margin::COARSE).sqrt().max(1.0);
        Margin::within(bounds, (64.0 / finer).max(4.0))
    }

    /// So many primitives are coarse beside a 2048th of the box around them.
    const COARSE: f32 = 8192.0;

    /// The margin for a structure whose cells may be much smaller than `bounds`: a 16th of the pad, for rays
    /// that start within a 16th of the reach.
    pub fn near(bounds: &Aabb) -> Margin {
        Margin::within(bounds, 4.0)
    }

    /// The margin for rays that start within so many diagonals; the pad grows with them.
    fn within(bounds: &Aabb, diagonals: f32) -> Margin {
        if bounds.is_empty() {
            return Margin { pad: 0.0, reach: f32::INFINITY, longest: f32::INFINITY, center: Vec3::ZERO };
        }
        let diagonal = length(bounds.extent());
        let largest = bounds.min.abs().max(bounds.max.abs()).max_element();
        // The second term covers the rounding of the boxes themselves in scenes far from the origin.
        let pad = (diagonal * (diagonals / (64.0 * 2048.0))).max(largest * (4.0 * f32::EPSILON)).max(STEPS);
        let longest = pad / STEPS;
        Margin { pad, reach: diagonals * diagonal, longest, center: bounds.center() }
    }

    /// What keeps a ray from being walked through cells, if anything does.
    #[inline]
    pub fn bars(&self, ray: &Ray) -> Option<Visit> {
        if length(ray.o - self.center) > self.reach {
            return Some(Visit::Distant { reach: self.reach });
        }
        bars_length(ray, 0.0, self.longest)
    }
}
