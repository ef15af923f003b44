//! Bounding volumes, slides 49-52: shapes around sets of primitives that a ray can be tested against first.

mod aabb;

use std::fmt::Debug;

use crate::{Aabb, Axes, Interval, Measure, Observer, Place, PrimId, Primitives, Ray, Visit};

/// A shape that holds a set of primitives and is tested before any of them.
///
/// What brute force calls a hit is moved by rounding: its t is a single-precision number, clamped into the
/// primitive's own box. Volumes along the axes bracket such a t exactly (see [`slab`](crate::slab)); all
/// others test a body that is a little larger, the more so the further away the ray starts.
pub trait Volume: Clone + Debug + PartialEq {
    /// The volume around some primitives; `bounds` is the box around them. There must be at least one.
    fn fit<P: Primitives>(prims: &P, ids: impl Iterator<Item = PrimId>, bounds: &Aabb, axes: Axes) -> Self;

    /// The part of `within` for which the ray lies in the volume; empty if it misses.
    fn meet(&self, ray: &Ray, within: Interval, place: Place, watch: &mut impl Observer<Visit>) -> Interval;

    /// The box around it.
    fn bounds(&self) -> Aabb;

    /// Its surface, or in a flat scene the length of its outline.
    fn measure(&self, measure: Measure) -> f32;

    /// How much room it encloses.
    fn content(&self) -> f32;

    /// How much memory it takes.
    fn bytes(&self) -> usize {
        size_of::<Self>()
    }
}
