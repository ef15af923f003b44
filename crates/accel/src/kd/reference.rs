//! A reference on its way down the tree: a primitive and the box around its part in the node.

use crate::{Aabb, Axis, PrimId, Primitives};

/// A primitive and the box around what of it lies in the node, `pad` larger than that part on all sides
/// (see [`Margin`](crate::Margin)) but never larger than the node.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reference {
    pub(super) prim: PrimId,
    pub(super) bounds: Aabb,
}

impl Reference {
    /// The reference of a node with box `node` to `prim`; none if the primitive does not reach into it.
    pub(super) fn clipped(prims: &impl Primitives, prim: PrimId, node: &Aabb, pad: f32) -> Option<Reference> {
        let part = prims.clip(prim, &node.padded(pad));
        (!part.is_empty()).then(|| Reference { prim, bounds: part.padded(pad).intersection(*node) })
    }

    /// Whether it reaches below the plane, and whether it reaches above. One that only touches does not:
    /// the primitive itself is `pad` away. One that lies flat in the plane is on both sides.
    pub(super) fn sides(&self, axis: Axis, plane: f32) -> (bool, bool) {
        let (below, above) = (self.bounds.min[axis] < plane, self.bounds.max[axis] > plane);
        if below || above { (below, above) } else { (true, true) }
    }
}

/// Deals a node's references out to its children. Only those on both sides are clipped again.
pub(super) fn deal(
    prims: &impl Primitives,
    refs: &[Reference],
    axis: Axis,
    plane: f32,
    children: &(Aabb, Aabb),
    pad: f32,
) -> (Vec<Reference>, Vec<Reference>) {
    let (mut lower, mut upper) = (Vec::with_capacity(refs.len()), Vec::with_capacity(refs.len()));
    for &reference in refs {
        match reference.sides(axis, plane) {
            (true, false) => lower.push(reference),
            (false, true) => upper.push(reference),
            _ => {
                lower.extend(Reference::clipped(prims, reference.prim, &children.0, pad));
                upper.extend(Reference::clipped(prims, reference.prim, &children.1, pad));
            }
        }
    }
    (lower, upper)
}
