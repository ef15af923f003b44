//! A reference on its way down the tree: a primitive and the box around its part in the node.

use glam::Vec3;

use super::node::Upright;
use crate::events::patiently;
use crate::{Aabb, Axis, Cancelled, Grow, Observer, PrimId, Primitives};

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

    /// What of it lies below the plane, and what above. A side of the node that its part in the node does not
    /// reach need not be cut along, though it may cut the primitive elsewhere: a convex part cannot go on beyond.
    fn halves(
        &self,
        prims: &impl Primitives,
        node: &Aabb,
        Upright { axis, at }: Upright,
        pad: f32,
    ) -> [Option<Reference>; 2] {
        let Aabb { min, max } = node.padded(pad);
        let reached = Aabb {
            min: Vec3::select(self.bounds.min.cmple(node.min), min, Vec3::NEG_INFINITY),
            max: Vec3::select(self.bounds.max.cmpge(node.max), max, Vec3::INFINITY),
        };
        let [lower, upper] = prims.clip_twice(self.prim, &reached, axis, [at + pad, at - pad]);
        let (below, above) = self.bounds.cut(axis, at);
        let half = |part: Aabb, side| {
            let bounds = part.padded(pad).intersection(side);
            (!part.is_empty()).then_some(Reference { prim: self.prim, bounds })
        };
        [half(lower, below), half(upper, above)]
    }

    /// Whether it reaches below the plane, and whether it reaches above. One that only touches does not:
    /// the primitive itself is `pad` away. One that lies flat in the plane is on both sides.
    pub(super) fn sides(&self, axis: Axis, plane: f32) -> (bool, bool) {
        let (below, above) = (self.bounds.min[axis] < plane, self.bounds.max[axis] > plane);
        if below || above { (below, above) } else { (true, true) }
    }
}

/// Deals the references of the node with box `node` out to its children. Only those on both sides are clipped
/// again.
pub(super) fn deal(
    prims: &impl Primitives,
    refs: &[Reference],
    node: &Aabb,
    plane: Upright,
    pad: f32,
    watch: &impl Observer<Grow>,
) -> Result<[Vec<Reference>; 2], Cancelled> {
    let (mut lower, mut upper) = (Vec::with_capacity(refs.len()), Vec::with_capacity(refs.len()));
    for reference in patiently(refs, watch) {
        let &reference = reference?;
        match reference.sides(plane.axis, plane.at) {
            (true, false) => lower.push(reference),
            (false, true) => upper.push(reference),
            _ => {
                let [below, above] = reference.halves(prims, node, plane, pad);
                lower.extend(below);
                upper.extend(above);
            }
        }
    }
    Ok([lower, upper])
}
