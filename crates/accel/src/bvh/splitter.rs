//! The primitives of a hierarchy while it is built top-down: ordered along every axis, and divided in two.

use std::ops::Range;

use glam::Vec3;

use crate::events::{patiently, sort_patiently};
use crate::geometry::digits::{in_world, unit};
use crate::{Aabb, Axis, BvhRule, Cancelled, Grow, NodeId, Observer, PrimId};

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

/// How large the box around a child's primitives is, in the splitter's unit, and how many they are.
pub(super) type Side = (f32, usize);

/// What a division is expected to cost, and from what. The size of the node is in the splitter's unit.
struct Expected {
    size: f32,
    p_below: f32,
    p_above: f32,
    cost: f32,
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
    pub(super) centers: Vec<Vec3>,
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

    /// From now on sizes are in a unit in which this node has one, however small or large it is.
    pub(super) fn measure_within(&mut self, part: &Part) {
        self.unit = unit(part.bounds.extent().max_element());
    }

    /// How large a box is, in the unit of the node that is being split.
    #[inline]
    pub(super) fn measure(&self, bounds: &Aabb) -> f32 {
        if bounds.is_empty() { 0.0 } else { self.rule.measure.of(bounds.extent() * self.unit) }
    }

    /// What a ray that meets the node is expected to cost: one step, and the tests of each child times the
    /// chance that the ray meets it (slide 53, as in the kd-tree). A step tests boxes, and counts as much as a test.
    #[inline]
    fn expect(&self, part: &Part, [below, above]: [Side; 2]) -> Expected {
        let size = self.measure(&part.bounds);
        let chance = |side: f32| if size > 0.0 { side / size } else { 1.0 };
        let (p_below, p_above) = (chance(below.0), chance(above.0));
        let cost = 1.0 + p_below * below.1 as f32 + p_above * above.1 as f32;
        Expected { size, p_below, p_above, cost }
    }

    /// Weighs a way to share out a node's primitives, and returns its cost.
    #[inline]
    pub(super) fn weigh(
        &self,
        node: NodeId,
        part: &Part,
        (axis, plane): (Axis, f32),
        sides: [Side; 2],
        watch: &mut impl Observer<Grow>,
    ) -> f32 {
        let Expected { size, p_below, p_above, cost } = self.expect(part, sides);
        let [(size_below, below), (size_above, above)] = sides;
        let told = |size: f32| in_world(size, self.rule.measure, self.unit);
        watch.on(Grow::Weigh {
            node,
            axis: axis.into(),
            plane,
            below: below as u32,
            above: above as u32,
            size: told(size),
            size_below: told(size_below),
            size_above: told(size_above),
            p_below,
            p_above,
            step: 1.0,
            test: 1.0,
            bonus: 1.0,
            cost,
        });
        cost
    }

    /// Reorders the node's stretches so that those below come first in each.
    pub(super) fn divide(
        &mut self,
        part: &Part,
        choice: Choice,
        watch: &impl Observer<Grow>,
    ) -> Result<Cut, Cancelled> {
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
        let sides = [(self.measure(&low), below), (self.measure(&high), part.len() - below)];
        let cost = self.expect(part, sides).cost;
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
