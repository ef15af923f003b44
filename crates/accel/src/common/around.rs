//! The box around everything, slide 29: it begins empty and grows by one primitive after the other.

use crate::events::BETWEEN_LOOKS;
use crate::{Aabb, Cancelled, Grow, Observer, PrimId, Primitives};

/// The box around all primitives.
///
/// # Errors
/// `watch` asked to give up.
pub(crate) fn around(prims: &impl Primitives, watch: &mut impl Observer<Grow>) -> Result<Aabb, Cancelled> {
    let mut bounds = Aabb::EMPTY;
    for prim in (0..prims.len() as u32).map(PrimId) {
        if prim.index().is_multiple_of(BETWEEN_LOOKS) && watch.cancelled() {
            return Err(Cancelled);
        }
        let before = bounds;
        bounds = before.union(prims.bounds(prim));
        watch.on(Grow::Widen { prim, bounds, grown: bounds != before });
    }
    Ok(bounds)
}
