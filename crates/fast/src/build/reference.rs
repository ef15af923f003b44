//! References: the boxes of triangles, in a row to be sorted into a tree.

use glam::{Vec3, Vec4};
use rayon::prelude::*;
use raystep_accel::{Aabb, Mesh, PrimId};

/// The box of a triangle, and which triangle it is: 32 bytes, two registers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reference {
    /// The lower corner, and the id.
    low: Vec4,
    /// The upper corner.
    high: Vec4,
}

/// Ids are kept as numbers of common size, so that the arithmetic on all four lanes never meets a subnormal one.
const FIRST: u32 = 0x2000_0000;

impl Reference {
    pub(crate) fn new(bounds: &Aabb, prim: u32) -> Reference {
        Reference { low: bounds.min.extend(f32::from_bits(FIRST + prim)), high: bounds.max.extend(1.0) }
    }

    #[inline]
    pub(crate) fn prim(&self) -> u32 {
        self.low.w.to_bits().wrapping_sub(FIRST)
    }

    /// What stands where there is none.
    pub(crate) const NONE: Reference = Reference { low: Vec4::ONE, high: Vec4::ONE };

    pub(crate) fn bounds(&self) -> Aabb {
        self.box4().aabb()
    }

    #[inline]
    pub(crate) fn box4(&self) -> Box4 {
        Box4 { low: self.low, high: self.high }
    }

    /// Twice its middle; the last lane means nothing.
    #[inline]
    pub(crate) fn middle(&self) -> Vec4 {
        self.low + self.high
    }
}

/// A box in two registers; the last lanes mean nothing.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Box4 {
    pub(crate) low: Vec4,
    pub(crate) high: Vec4,
}

impl Box4 {
    pub(crate) const EMPTY: Box4 = Box4 { low: Vec4::INFINITY, high: Vec4::NEG_INFINITY };

    #[inline]
    pub(crate) fn add(&mut self, reference: &Reference) {
        self.low = self.low.min(reference.low);
        self.high = self.high.max(reference.high);
    }

    #[inline]
    pub(crate) fn add_point(&mut self, point: Vec4) {
        self.low = self.low.min(point);
        self.high = self.high.max(point);
    }

    pub(crate) fn from(bounds: &Aabb) -> Box4 {
        Box4 { low: bounds.min.extend(1.0), high: bounds.max.extend(1.0) }
    }

    #[inline]
    pub(crate) fn union(&self, other: &Box4) -> Box4 {
        Box4 { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// The box around references.
    pub(crate) fn around(references: &[Reference]) -> Box4 {
        let mut bounds = Box4::EMPTY;
        for reference in references {
            bounds.add(reference);
        }
        bounds
    }

    /// What both have in common.
    #[inline]
    pub(crate) fn common(&self, other: &Box4) -> Box4 {
        Box4 { low: self.low.max(other.low), high: self.high.min(other.high) }
    }

    /// Half its surface; not negative.
    #[inline]
    pub(crate) fn area(&self) -> f32 {
        let side = (self.high - self.low).max(Vec4::ZERO);
        side.x * side.y + side.y * side.z + side.z * side.x
    }

    pub(crate) fn aabb(&self) -> Aabb {
        Aabb { min: self.low.truncate(), max: self.high.truncate() }
    }
}

/// A reference to each triangle, and the box around all.
pub(crate) fn references(mesh: &Mesh) -> (Vec<Reference>, Box4) {
    assert!(mesh.triangles.len() < FIRST as usize, "more triangles than a tree can tell apart");
    let reference = |prim: u32| Reference::new(&mesh.triangle(PrimId(prim)).bounds(), prim);
    let references: Vec<Reference> =
        (0..mesh.triangles.len() as u32).into_par_iter().with_min_len(4096).map(reference).collect();
    let around = |mut bounds: Box4, reference: &Reference| {
        bounds.add(reference);
        bounds
    };
    let bounds = references.iter().fold(Box4::EMPTY, around);
    debug_assert!(references.is_empty() || bounds.low.truncate().cmple(Vec3::MAX).all());
    (references, bounds)
}
