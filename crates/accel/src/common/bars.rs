//! What keeps a ray from being walked through a structure: where it starts, and how long its direction is.

use crate::{Ray, Visit};

/// Why a ray starts too far away, if it does, for the square of the way from there to be a number.
#[inline]
pub(crate) fn bars_origin(ray: &Ray) -> Option<Visit> {
    const REACH: f32 = 4e18;
    (ray.o.abs().max_element() > REACH).then_some(Visit::Distant { reach: REACH })
}

/// Why a ray cannot be seen along directions between the axes, if it cannot: the sums of products that this takes
/// lose their digits.
#[inline]
pub(crate) fn bars_projection(ray: &Ray) -> Option<Visit> {
    bars_origin(ray).or_else(|| bars_length(ray, 1e-30, 1e30))
}

/// Why a ray's direction is too short or too long, if it is.
#[inline]
pub(crate) fn bars_length(ray: &Ray, shortest: f32, longest: f32) -> Option<Visit> {
    let length = ray.d.abs().max_element();
    let fits = shortest <= length && length <= longest;
    (!fits).then_some(Visit::Extreme { length, shortest, longest })
}
