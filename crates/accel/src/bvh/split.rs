//! Dividing a node's primitives in two, slide 53: which come below, which above.

use super::splitter::{Choice, Cut, Part, Splitter};
use super::{binned, sweep};
use crate::events::patiently;
use crate::{Aabb, BvhSplit, Cancelled, Grow, NodeId, Observer};

impl Splitter<'_> {
    /// Divides a node by the rule, or into halves.
    pub(super) fn split(
        &mut self,
        node: NodeId,
        part: &Part,
        halve: bool,
        watch: &mut impl Observer<Grow>,
    ) -> Result<Cut, Cancelled> {
        self.measure_within(part);
        let by_hand = self.by_hand(node, part).filter(|_| !halve);
        let choice = match self.rule.split {
            _ if halve => None,
            BvhSplit::Middle => self.middle(part, watch)?,
            BvhSplit::Median => None,
            BvhSplit::Binned => binned::choose(self, node, part, watch)?,
            BvhSplit::Sweep => sweep::choose(self, node, part, watch)?,
        };
        // What was chosen by hand is taken whatever it costs. Halves always work, even if all centres coincide.
        let choice = match by_hand.or(choice) {
            Some(choice) => choice,
            None => self.halves(part, watch)?,
        };

        let cut = self.divide(part, choice, watch)?;
        if halve || by_hand.is_some() || matches!(self.rule.split, BvhSplit::Middle | BvhSplit::Median) {
            let side = |part: &Part| (self.measure(&part.bounds), part.len());
            let sides = [side(&cut.below), side(&cut.above)];
            self.weigh(node, part, (cut.axis, cut.plane), sides, watch);
        }
        Ok(cut)
    }

    /// Where the node's list was cut by hand, if that leaves something on both sides.
    fn by_hand(&self, node: NodeId, part: &Part) -> Option<Choice> {
        let cut = self.rule.cut.of(node).filter(|cut| self.rule.axes.list().contains(&cut.axis))?;
        let (axis, plane) = (cut.axis, cut.at);
        let below = self.ordered(part, axis).partition_point(|&prim| self.center(prim, axis) < plane);
        (below > 0 && below < part.len()).then_some(Choice { axis, plane, below, cost: 0.0 })
    }

    /// The box around a node's centres.
    fn centers_box(&self, part: &Part, watch: &impl Observer<Grow>) -> Result<Aabb, Cancelled> {
        patiently(self.prims(part), watch)
            .try_fold(Aabb::EMPTY, |bounds, prim| Ok(bounds.with_point(self.centers[prim?.index()])))
    }

    /// By the middle of the centres' longest side; nothing if all lie on one side of it.
    fn middle(&self, part: &Part, watch: &impl Observer<Grow>) -> Result<Option<Choice>, Cancelled> {
        let centers = self.centers_box(part, watch)?;
        let axis = centers.longest(self.rule.axes);
        let plane = centers.center()[axis];
        let below = self.ordered(part, axis).partition_point(|&prim| self.center(prim, axis) < plane);
        Ok((below > 0 && below < part.len()).then_some(Choice { axis, plane, below, cost: 0.0 }))
    }

    /// As many primitives below as above, along the centres' longest side.
    fn halves(&self, part: &Part, watch: &impl Observer<Grow>) -> Result<Choice, Cancelled> {
        let axis = self.centers_box(part, watch)?.longest(self.rule.axes);
        let below = part.len() / 2;
        let plane = self.center(self.ordered(part, axis)[below], axis);
        Ok(Choice { axis, plane, below, cost: 0.0 })
    }
}
