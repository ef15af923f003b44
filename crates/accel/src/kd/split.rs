//! Where to cut a node, slide 30: through the middle, at the median, or where the cost is least.

use std::cmp::Ordering;

use glam::Vec3;

use super::reference::Reference;
use crate::geometry::digits::in_world;
use crate::{Aabb, Axis, Cancelled, Grow, KdRule, KdSplit, NodeId, Observer};

/// A plane and what it is worth.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cut {
    pub(super) axis: Axis,
    pub(super) plane: f32,
    pub(super) cost: f32,
    below: u32,
    above: u32,
}

/// Weighs planes across one node.
pub(super) struct Scale<'a, O> {
    pub(super) node: NodeId,
    pub(super) bounds: &'a Aabb,
    pub(super) refs: &'a [Reference],
    pub(super) rule: &'a KdRule,
    pub(super) watch: &'a mut O,
    /// The sides of `bounds`, and its measure, in the unit with which it has one.
    pub(super) unit: f32,
    pub(super) extent: Vec3,
    pub(super) whole: f32,
}

impl<O: Observer<Grow>> Scale<'_, O> {
    /// The plane that the rule asks for; none if no plane separates the references.
    pub(super) fn best(&mut self) -> Result<Option<Cut>, Cancelled> {
        let best = match self.rule.split {
            KdSplit::Middle => self.across_the_longest(|bounds, _, axis| bounds.center()[axis]),
            KdSplit::Median => self.across_the_longest(|_, refs, axis| median(refs, axis)),
            KdSplit::Sah => self.cheapest()?,
        };
        Ok(self.by_hand().or(best))
    }

    /// The plane that was chosen by hand: weighed after all others, and taken whatever it costs.
    fn by_hand(&mut self) -> Option<Cut> {
        let cut = self.rule.cut.of(self.node).filter(|cut| cut.divides(self.bounds))?;
        Some(self.weigh_at(cut.axis, cut.at))
    }

    /// Weighs one plane.
    fn weigh_at(&mut self, axis: Axis, plane: f32) -> Cut {
        let (mut below, mut above) = (0, 0);
        for reference in self.refs {
            let reaches = reference.sides(axis, plane);
            below += u32::from(reaches.0);
            above += u32::from(reaches.1);
        }
        self.weigh(axis, plane, below, above)
    }

    /// One plane across the longest side; if it puts everything on both sides, across the next longest.
    fn across_the_longest(&mut self, place: impl Fn(&Aabb, &[Reference], Axis) -> f32) -> Option<Cut> {
        let mut axes = self.rule.axes.list().to_vec();
        axes.sort_by(|&a, &b| self.extent[b].total_cmp(&self.extent[a]));
        axes.into_iter().find_map(|axis| {
            let plane = place(self.bounds, self.refs, axis);
            if !self.inside(axis, plane) {
                return None;
            }
            let cut = self.weigh_at(axis, plane);
            self.separates(&cut).then_some(cut)
        })
    }

    /// The surface area heuristic: of all planes along the faces of the references, the one with the
    /// least expected cost.
    fn cheapest(&mut self) -> Result<Option<Cut>, Cancelled> {
        let mut best: Option<Cut> = None;
        let all = self.refs.len();
        let (mut starts, mut ends) = (Vec::with_capacity(all), Vec::with_capacity(all));
        for &axis in self.rule.axes.list() {
            if self.watch.cancelled() {
                return Err(Cancelled);
            }
            self.faces(axis, &mut starts, &mut ends);
            // Which axis it is, is asked here and not again at every plane.
            match axis {
                Axis::X => self.sweep(Axis::X, &starts, &ends, &mut best),
                Axis::Y => self.sweep(Axis::Y, &starts, &ends, &mut best),
                Axis::Z => self.sweep(Axis::Z, &starts, &ends, &mut best),
            }
        }
        Ok(best)
    }

    /// Fills `starts` and `ends` with the lower and upper faces across one axis, from low to high, but not with
    /// those that lie in the node's own faces: what starts there lies below all planes, what ends there above all.
    fn faces(&self, axis: Axis, starts: &mut Vec<f32>, ends: &mut Vec<f32>) {
        starts.clear();
        ends.clear();
        let (low, high) = (self.bounds.min[axis], self.bounds.max[axis]);
        for Reference { bounds, .. } in self.refs {
            let (start, end) = (bounds.min[axis], bounds.max[axis]);
            if start > low {
                starts.push(start);
            }
            if end < high {
                ends.push(end);
            }
        }
        starts.sort_unstable_by(by_size);
        ends.sort_unstable_by(by_size);
    }

    /// Weighs the planes across one axis from low to high, as counts change only where a reference starts or ends.
    #[inline(always)]
    fn sweep(&mut self, axis: Axis, mut starts: &[f32], mut ends: &[f32], best: &mut Option<Cut>) {
        let all = self.refs.len();
        let lasting = all - ends.len();
        loop {
            // The next face, of those that are left.
            let plane = match (starts, ends) {
                ([start, ..], [end, ..]) if start < end => *start,
                (_, [end, ..]) => *end,
                ([start, ..], []) => *start,
                ([], []) => return,
            };
            while ends.first().is_some_and(|&end| end <= plane) {
                ends = &ends[1..];
            }
            // Below the plane lies what has started, and above it what has not ended.
            if self.inside(axis, plane) {
                let (below, above) = (all - starts.len(), ends.len() + lasting);
                let cut = self.weigh(axis, plane, below as u32, above as u32);
                if self.separates(&cut) && best.is_none_or(|best| cut.cost < best.cost) {
                    *best = Some(cut);
                }
            }
            while starts.first().is_some_and(|&start| start <= plane) {
                starts = &starts[1..];
            }
        }
    }

    /// What the node costs if it is cut there: a step, and for each child its primitives as often as a ray
    /// that meets the node meets the child. Cutting off empty space is worth a bonus.
    #[inline(always)]
    fn weigh(&mut self, axis: Axis, plane: f32, below: u32, above: u32) -> Cut {
        // The children are as wide as the node, but along the axis.
        let sides = |side: f32| match axis {
            Axis::X => self.extent.with_x(side),
            Axis::Y => self.extent.with_y(side),
            Axis::Z => self.extent.with_z(side),
        };
        let (size, measure) = (self.whole, |side: f32| self.rule.measure.of(sides(side * self.unit)));
        let (size_below, size_above) = (measure(plane - self.bounds.min[axis]), measure(self.bounds.max[axis] - plane));
        let (p_below, p_above) = (size_below / size, size_above / size);
        let tests = p_below * below as f32 + p_above * above as f32;
        let bonus = if below == 0 || above == 0 { 1.0 - self.rule.empty_bonus } else { 1.0 };
        let (step, test) = (self.rule.traversal_cost, self.rule.intersection_cost);
        let cost = bonus * (step + test * tests);
        let told = |size: f32| in_world(size, self.rule.measure, self.unit);
        self.watch.on(Grow::Weigh {
            node: self.node,
            axis: axis.into(),
            plane,
            below,
            above,
            size: told(size),
            size_below: told(size_below),
            size_above: told(size_above),
            p_below,
            p_above,
            step,
            test,
            bonus,
            cost,
        });
        Cut { axis, plane, cost, below, above }
    }

    /// A plane in a face of the node cuts nothing.
    fn inside(&self, axis: Axis, plane: f32) -> bool {
        self.bounds.min[axis] < plane && plane < self.bounds.max[axis]
    }

    /// A cut that puts nearly everything, three quarters and more, on both sides is none.
    fn separates(&self, cut: &Cut) -> bool {
        4 * (cut.below as usize + cut.above as usize) <= 7 * self.refs.len()
    }
}

/// Half of the references have their middle below it.
fn median(refs: &[Reference], axis: Axis) -> f32 {
    let mut middles: Vec<f32> = refs.iter().map(|reference| reference.bounds.center()[axis]).collect();
    let half = middles.len() / 2;
    *middles.select_nth_unstable_by(half, by_size).1
}

/// Which of two numbers comes first; no box has a face at none.
fn by_size(a: &f32, b: &f32) -> Ordering {
    a.partial_cmp(b).unwrap_or(Ordering::Equal)
}
