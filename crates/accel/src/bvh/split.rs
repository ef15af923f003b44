//! Dividing a node's primitives in two: which come below, which above.

use std::ops::Range;

use glam::Vec3;

use super::{binned, sweep};
use crate::digits::unit;
use crate::watch::{patiently, sort_patiently};
use crate::{Aabb, Axis, BvhRule, BvhSplit, Cancelled, Grow, NodeId, Observer, PrimId};

/// The primitives of one node: a stretch of every order.
pub(super) struct Part {
    range: Range<usize>,
    pub(super) bounds: Aabb,
}

impl Part {
    pub(super) fn len(&self) -> usize {
        self.range.len()
    }
}

/// Where a node is to be divided: the first `below` of its primitives, ordered along `axis`, come below.
#[derive(Clone, Copy)]
pub(super) struct Choice {
    pub(super) axis: Axis,
    pub(super) plane: f32,
    pub(super) below: usize,
    pub(super) cost: f32,
}

/// A node divided.
pub(super) struct Cut {
    pub(super) axis: Axis,
    pub(super) plane: f32,
    pub(super) cost: f32,
    pub(super) below: Part,
    pub(super) above: Part,
}

/// All primitives, ordered by their centres along every axis. A node's primitives are the same stretch of
/// each order, so no node has to sort again.
pub(super) struct Splitter<'a> {
    pub(super) rule: &'a BvhRule,
    pub(super) boxes: Vec<Aabb>,
    centers: Vec<Vec3>,
    orders: Vec<Vec<u32>>,
    /// Room for what every division needs.
    is_below: Vec<bool>,
    moved: Vec<u32>,
    pub(super) measures: Vec<f32>,
    /// What sides are multiplied with before they are measured.
    unit: f32,
}

impl<'a> Splitter<'a> {
    pub(super) fn new(
        rule: &'a BvhRule,
        boxes: Vec<Aabb>,
        watch: &impl Observer<Grow>,
    ) -> Result<Splitter<'a>, Cancelled> {
        let centers: Vec<Vec3> = boxes.iter().map(Aabb::center).collect();
        let order = |&axis: &Axis| {
            let mut order: Vec<u32> = (0..boxes.len() as u32).collect();
            // Equal centres stay ordered by id.
            let center = |&prim: &u32| centers[prim as usize][axis];
            sort_patiently(&mut order, watch, |a, b| center(a).total_cmp(&center(b)))?;
            Ok(order)
        };
        let orders = rule.axes.list().iter().map(order).collect::<Result<_, _>>()?;
        let (is_below, moved, measures) = (vec![false; boxes.len()], Vec::new(), vec![0.0; boxes.len()]);
        Ok(Splitter { rule, boxes, centers, orders, is_below, moved, measures, unit: 1.0 })
    }

    /// All primitives.
    pub(super) fn whole(&self, bounds: Aabb) -> Part {
        Part { range: 0..self.boxes.len(), bounds }
    }

    /// A node's primitives.
    pub(super) fn prims(&self, part: &Part) -> impl Iterator<Item = PrimId> {
        self.orders[0][part.range.clone()].iter().copied().map(PrimId)
    }

    /// A node's primitives, ordered by their centres.
    pub(super) fn ordered(&self, part: &Part, axis: Axis) -> &[u32] {
        &self.orders[axis.index()][part.range.clone()]
    }

    /// A primitive's centre.
    pub(super) fn center(&self, prim: u32, axis: Axis) -> f32 {
        self.centers[prim as usize][axis]
    }

    /// Divides a node by the rule, or into halves.
    pub(super) fn split(
        &mut self,
        node: NodeId,
        part: &Part,
        halve: bool,
        watch: &mut impl Observer<Grow>,
    ) -> Result<Cut, Cancelled> {
        self.unit = unit(part.bounds.extent().max_element());
        let choice = match self.rule.split {
            _ if halve => None,
            BvhSplit::Middle => self.middle(part, watch)?,
            BvhSplit::Median => None,
            BvhSplit::Binned => binned::choose(self, node, part, watch)?,
            BvhSplit::Sweep => sweep::choose(self, node, part, watch)?,
        };
        // Halves always work, even if all centres coincide.
        let choice = match choice {
            Some(choice) => choice,
            None => self.halves(part, watch)?,
        };

        let cut = self.divide(part, choice, watch)?;
        if halve || matches!(self.rule.split, BvhSplit::Middle | BvhSplit::Median) {
            let Cut { axis, plane, cost, .. } = cut;
            let (below, above) = (cut.below.len() as u32, cut.above.len() as u32);
            watch.on(Grow::Weigh { node, axis: axis.into(), plane, below, above, cost });
        }
        Ok(cut)
    }

    /// What a ray that meets the node is expected to cost: one step, and the tests of each child times the
    /// chance that the ray meets it (slide 53, as in the kd-tree).
    pub(super) fn cost(&self, part: &Part, below: (f32, usize), above: (f32, usize)) -> f32 {
        let whole = self.measure(&part.bounds);
        let chance = |measure: f32| if whole > 0.0 { measure / whole } else { 1.0 };
        1.0 + chance(below.0) * below.1 as f32 + chance(above.0) * above.1 as f32
    }

    /// How large a box is, in a unit in which the node that is being split has a size.
    #[inline]
    pub(super) fn measure(&self, bounds: &Aabb) -> f32 {
        if bounds.is_empty() { 0.0 } else { self.rule.measure.of(bounds.extent() * self.unit) }
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

    /// Reorders the node's stretches so that those below come first in each.
    fn divide(&mut self, part: &Part, choice: Choice, watch: &impl Observer<Grow>) -> Result<Cut, Cancelled> {
        let Choice { axis, plane, below, .. } = choice;
        let at = part.range.start + below;
        let mut bounds = [Aabb::EMPTY; 2];
        for item in patiently(self.orders[axis.index()][part.range.clone()].iter().enumerate(), watch) {
            let (i, &prim) = item?;
            let side = usize::from(i >= below);
            bounds[side] = bounds[side].union(self.boxes[prim as usize]);
            self.is_below[prim as usize] = side == 0;
        }
        for &other in self.rule.axes.list() {
            if other != axis {
                self.reorder(other, part.range.clone(), watch)?;
            }
        }
        let [low, high] = bounds;
        let cost = self.cost(part, (self.measure(&low), below), (self.measure(&high), part.len() - below));
        let (below, above) = (part.range.start..at, at..part.range.end);
        Ok(Cut {
            axis,
            plane,
            cost,
            below: Part { range: below, bounds: low },
            above: Part { range: above, bounds: high },
        })
    }

    /// Moves those below to the front of a stretch; both sides stay ordered.
    fn reorder(&mut self, axis: Axis, range: Range<usize>, watch: &impl Observer<Grow>) -> Result<(), Cancelled> {
        let stretch = &mut self.orders[axis.index()][range];
        self.moved.clear();
        let mut front = 0;
        for i in patiently(0..stretch.len(), watch) {
            let prim = stretch[i?];
            if self.is_below[prim as usize] {
                stretch[front] = prim;
                front += 1;
            } else {
                self.moved.push(prim);
            }
        }
        stretch[front..].copy_from_slice(&self.moved);
        Ok(())
    }
}
