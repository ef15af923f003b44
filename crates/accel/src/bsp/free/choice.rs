//! Which plane cuts a node: some are proposed, and the one with the least expected cost is taken.

use glam::{DVec3, Vec3};

use super::fragment::{Fragment, Proposal, proposals};
use super::{ConvexCell, FreePlane};
use crate::events::BETWEEN_LOOKS;
use crate::geometry::digits::unit;
use crate::{Axes, BspPlanes, BspRule, Cancelled, Grow, Measure, NodeId, Observer, Place, Primitives, Random};

/// Planes stand a little further beside a fragment than it is padded, so that it lies on one side of them
/// even after rounding.
const BESIDE: f64 = 1.5;

/// Proposes planes across one node and weighs them.
pub(super) struct Scale<'a, P, O> {
    pub(super) prims: &'a P,
    pub(super) rule: &'a BspRule,
    pub(super) random: &'a mut Random,
    pub(super) pad: f64,
    pub(super) node: NodeId,
    pub(super) cell: &'a ConvexCell,
    pub(super) refs: &'a [Fragment],
    pub(super) watch: &'a mut O,
}

/// Planes across one direction.
struct Across {
    normal: Vec3,
    /// Who proposes them.
    from: Place,
    planes: Vec<Tried>,
}

/// A plane, and how many fragments reach below it and above it.
struct Tried {
    plane: FreePlane,
    below: u32,
    above: u32,
}

impl<P: Primitives, O: Observer<Grow>> Scale<'_, P, O> {
    /// The cheapest plane; none if no proposed plane separates the fragments.
    pub(super) fn best(&mut self) -> Result<Option<(FreePlane, f32)>, Cancelled> {
        let mut proposed = self.proposed();
        self.count(&mut proposed)?;
        // In a unit in which the cell has a size, however small or large it is.
        let unit = f64::from(unit(self.cell.bounds().extent().max_element()));
        let unit = if self.rule.measure == Measure::Area { unit * unit } else { unit };
        let whole = self.cell.size(self.rule.measure);
        let mut best: Option<(FreePlane, Place, f32)> = None;
        for Across { from, planes, .. } in &proposed {
            for tried in planes {
                let cost = self.weigh(tried, *from, whole, unit);
                if let Some(cost) = cost
                    && best.is_none_or(|(_, _, least)| cost < least)
                {
                    best = Some((tried.plane, *from, cost));
                }
            }
        }
        let Some((plane, from, cost)) = best else { return Ok(None) };
        self.tell(plane, from);
        Ok(Some((plane, cost)))
    }

    /// Counts what reaches below and above all planes in one pass, so that a large node's fragments are fetched
    /// from memory once.
    fn count(&self, proposed: &mut [Across]) -> Result<(), Cancelled> {
        let mut extents = Vec::with_capacity(BETWEEN_LOOKS);
        for piece in self.refs.chunks(BETWEEN_LOOKS) {
            if self.watch.cancelled() {
                return Err(Cancelled);
            }
            for Across { normal, planes, .. } in proposed.iter_mut() {
                // Along the normal, fragments are intervals.
                let along = normal.as_dvec3();
                extents.clear();
                extents.extend(piece.iter().map(|fragment| fragment.extent(along)));
                for Tried { plane, below, above } in planes {
                    for &extent in &extents {
                        let (reaches_below, reaches_above) = sides(extent, *plane, self.pad);
                        *below += u32::from(reaches_below);
                        *above += u32::from(reaches_above);
                    }
                }
            }
        }
        Ok(())
    }

    /// What the node costs if it is cut by the plane, as in a kd-tree; none if hardly anything is separated.
    fn weigh(&mut self, &Tried { plane, below, above }: &Tried, from: Place, whole: f64, unit: f64) -> Option<f32> {
        let [size_below, size_above] = self.cell.halves(plane, self.rule.measure);
        let in_unit = |size: f64| (size * unit) as f32;
        let (p_below, p_above) = (in_unit(size_below) / in_unit(whole), in_unit(size_above) / in_unit(whole));
        let tests = p_below * below as f32 + p_above * above as f32;
        let (step, test) = (self.rule.traversal_cost, self.rule.intersection_cost);
        let cost = step + test * tests;
        self.tell(plane, from);
        self.watch.on(Grow::Weigh {
            node: self.node,
            axis: crate::Direction::Normal,
            plane: plane.at,
            below,
            above,
            size: whole as f32,
            size_below: size_below as f32,
            size_above: size_above as f32,
            p_below,
            p_above,
            step,
            test,
            bonus: 1.0,
            cost,
        });
        // A plane that leaves nearly everything, three quarters and more, on both sides separates nothing.
        let separates = 4 * (below as usize + above as usize) <= 7 * self.refs.len();
        (separates && cost.is_finite()).then_some(cost)
    }

    fn tell(&mut self, plane: FreePlane, from: Place) {
        let FreePlane { normal: Vec3 { x, y, z }, at } = plane;
        let normal = Grow::Normal { node: self.node, normal_x: x, normal_y: y, normal_z: z, plane: at, from };
        self.watch.on(normal);
    }

    /// The planes that cut the cell, of those that the rule proposes.
    fn proposed(&mut self) -> Vec<Across> {
        let samples = self.samples();
        let (refs, off) = (self.refs, BESIDE * self.pad);
        match self.rule.planes {
            BspPlanes::Polygons => {
                let own = samples.into_iter().flat_map(|i| {
                    let shape = self.prims.shape(refs[i].prim);
                    proposals(&shape).into_iter().map(move |proposal| (i, proposal))
                });
                own.filter_map(|(i, proposal)| {
                    let (Proposal::Across(along) | Proposal::Beyond(along)) = proposal;
                    let normal = self.normal(along)?;
                    let [low, high] = refs[i].extent(normal.as_dvec3());
                    let from = Place::Prim(refs[i].prim);
                    Some(match proposal {
                        Proposal::Across(_) => self.across(normal, from, [low - off, high + off]),
                        Proposal::Beyond(_) => self.across(normal, from, [high + off]),
                    })
                })
                .collect()
            }
            BspPlanes::Candidates => {
                let beside = |normal: Vec3| {
                    let extents = samples.iter().map(|&i| refs[i].extent(normal.as_dvec3()));
                    self.across(normal, Place::World, extents.flat_map(|[low, high]| [low - off, high + off]))
                };
                DIRECTIONS.iter().filter_map(|&along| self.normal(along.into())).map(beside).collect()
            }
        }
    }

    /// Planes across a direction. One in a face of the cell cuts nothing.
    fn across(&self, normal: Vec3, from: Place, places: impl IntoIterator<Item = f64>) -> Across {
        let [first, last] = self.cell.extent(normal.as_dvec3());
        let planes = places.into_iter().map(|at| FreePlane { normal, at: at as f32 });
        let cuts = |plane: &FreePlane| first + self.pad < plane.at.into() && f64::from(plane.at) < last - self.pad;
        let planes = planes.filter(cuts).map(|plane| Tried { plane, below: 0, above: 0 });
        Across { normal, from, planes: planes.collect() }
    }

    /// Which of the node's fragments propose planes: all, or a few at random.
    fn samples(&mut self) -> Vec<usize> {
        let (all, some) = (self.refs.len(), self.rule.samples as usize);
        if all <= some {
            return (0..all).collect();
        }
        (0..some).map(|_| self.random.below(all as u32) as usize).collect()
    }

    /// The direction with length one; none if it has no length, or may not be used.
    fn normal(&self, along: DVec3) -> Option<Vec3> {
        let normal = along.try_normalize()?.as_vec3();
        match self.rule.axes {
            Axes::Xyz => Some(normal),
            // In a flat scene planes stand upright.
            Axes::Xy => (normal.z.abs() < 1e-6).then_some(normal.with_z(0.0)),
        }
    }
}

/// Whether an extent reaches below the plane, and whether above, `pad` larger on both sides. One without
/// numbers is on both.
pub(super) fn sides([low, high]: [f64; 2], plane: FreePlane, pad: f64) -> (bool, bool) {
    let at = f64::from(plane.at);
    let (below, above) = (low - pad < at, high + pad > at);
    if below || above { (below, above) } else { (true, true) }
}

/// The axes, the edges of a cube and its corners.
const DIRECTIONS: [[f64; 3]; 13] = [
    [1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, 0.0, 1.0],
    [1.0, 1.0, 0.0],
    [1.0, -1.0, 0.0],
    [1.0, 0.0, 1.0],
    [1.0, 0.0, -1.0],
    [0.0, 1.0, 1.0],
    [0.0, 1.0, -1.0],
    [1.0, 1.0, 1.0],
    [1.0, 1.0, -1.0],
    [1.0, -1.0, 1.0],
    [1.0, -1.0, -1.0],
];
