//! Building a kd-tree: a node's space is a box, and a plane cuts it in two boxes.

use super::Kd;
use super::node::{KdNode, Upright};
use super::reference::{Reference, deal};
use super::split::Scale;
use crate::bsp::{Cutter, Half, Stops};
use crate::events::patiently;
use crate::geometry::digits::unit;
use crate::{Aabb, Cancelled, Grow, KdRule, KdSplit, Margin, NodeId, Observer, PrimId, Primitives};

impl Kd {
    /// Builds a kd-tree over `prims`.
    ///
    /// # Errors
    /// `watch` asked to give up.
    pub fn build(prims: &impl Primitives, rule: &KdRule, watch: &mut impl Observer<Grow>) -> Result<Kd, Cancelled> {
        let &KdRule { max_depth, min_objects, mailbox, cut, .. } = rule;
        let test_cost = (rule.split == KdSplit::Sah).then_some(rule.intersection_cost);
        let stops = Stops { max_depth, min_objects, test_cost, by_hand: cut, mailbox };
        Kd::grow(prims, Boxes { prims, rule, pad: 0.0 }, stops, watch)
    }
}

/// Cuts boxes across an axis.
struct Boxes<'a, P> {
    prims: &'a P,
    rule: &'a KdRule,
    pad: f32,
}

impl<P: Primitives> Cutter for Boxes<'_, P> {
    type Node = KdNode;
    type Space = Aabb;
    type Reference = Reference;

    fn root(
        &mut self,
        bounds: &Aabb,
        margin: &Margin,
        count: u32,
        watch: &impl Observer<Grow>,
    ) -> Result<Half<Self>, Cancelled> {
        self.pad = margin.pad;
        let clipped = |prim| Reference::clipped(self.prims, prim, bounds, margin.pad);
        let refs = patiently((0..count).map(PrimId), watch).filter_map(|prim| prim.map(clipped).transpose());
        Ok((*bounds, refs.collect::<Result<_, _>>()?))
    }

    fn bounds(space: &Aabb) -> Aabb {
        *space
    }

    fn prim(reference: &Reference) -> PrimId {
        reference.prim
    }

    fn is_shared(&self, reference: &Reference, Upright { axis, at }: Upright) -> bool {
        reference.sides(axis, at) == (true, true)
    }

    fn best(
        &mut self,
        node: NodeId,
        bounds: &Aabb,
        refs: &[Reference],
        watch: &mut impl Observer<Grow>,
    ) -> Result<Option<(Upright, f32)>, Cancelled> {
        let (rule, unit) = (self.rule, unit(bounds.extent().max_element()));
        let extent = bounds.extent() * unit;
        let whole = rule.measure.of(extent);
        let cut = Scale { node, bounds, refs, rule, watch, unit, extent, whole }.best()?;
        Ok(cut.map(|cut| (Upright { axis: cut.axis, at: cut.plane }, cut.cost)))
    }

    fn cut(
        &mut self,
        bounds: &Aabb,
        refs: &[Reference],
        plane: Upright,
        watch: &impl Observer<Grow>,
    ) -> Result<[Half<Self>; 2], Cancelled> {
        let [lower, upper] = deal(self.prims, refs, bounds, plane, self.pad, watch)?;
        let (below, above) = bounds.cut(plane.axis, plane.at);
        Ok([(below, lower), (above, upper)])
    }
}
