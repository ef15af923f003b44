//! Building a BSP tree: a node's space is a convex cell, and a plane of any direction cuts it in two
//! (Ize, Wald and Parker 2008 weigh such planes as a kd-tree does).

use super::choice::{Scale, sides};
use super::fragment::Fragment;
use super::{Bsp, BspNode, ConvexCell, FreePlane};
use crate::bsp::{Cutter, Half, Stops};
use crate::events::patiently;
use crate::{Aabb, BspRule, ByHand, Cancelled, Grow, Margin, NodeId, Observer, PrimId, Primitives, Random, Straddlers};

impl Bsp {
    /// Builds a BSP tree over `prims`.
    ///
    /// # Errors
    /// `watch` asked to give up.
    pub fn build(prims: &impl Primitives, rule: &BspRule, watch: &mut impl Observer<Grow>) -> Result<Bsp, Cancelled> {
        let &BspRule { max_depth, min_objects, mailbox, .. } = rule;
        let stops = Stops {
            max_depth,
            min_objects,
            test_cost: Some(rule.intersection_cost),
            by_hand: ByHand::default(),
            mailbox,
        };
        let random = Random::new(rule.seed.into());
        Bsp::grow(prims, Cells { prims, rule, random, pad: 0.0 }, stops, watch)
    }
}

/// Cuts convex cells by any plane.
struct Cells<'a, P> {
    prims: &'a P,
    rule: &'a BspRule,
    random: Random,
    pad: f64,
}

impl<P> Cells<'_, P> {
    fn sides(&self, fragment: &Fragment, plane: FreePlane) -> (bool, bool) {
        sides(fragment.extent(plane.normal.as_dvec3()), plane, self.pad)
    }
}

impl<P: Primitives> Cutter for Cells<'_, P> {
    type Node = BspNode;
    type Space = ConvexCell;
    type Reference = Fragment;

    fn root(
        &mut self,
        bounds: &Aabb,
        margin: &Margin,
        count: u32,
        watch: &impl Observer<Grow>,
    ) -> Result<Half<Self>, Cancelled> {
        self.pad = margin.pad.into();
        let whole = |prim| Fragment::of(prim, &self.prims.shape(prim));
        let refs = patiently((0..count).map(PrimId), watch).map(|prim| prim.map(whole));
        Ok((ConvexCell::of(bounds), refs.collect::<Result<_, _>>()?))
    }

    fn bounds(cell: &ConvexCell) -> Aabb {
        cell.bounds()
    }

    fn prim(fragment: &Fragment) -> PrimId {
        fragment.prim
    }

    fn is_shared(&self, fragment: &Fragment, plane: FreePlane) -> bool {
        self.sides(fragment, plane) == (true, true)
    }

    fn best(
        &mut self,
        node: NodeId,
        cell: &ConvexCell,
        refs: &[Fragment],
        watch: &mut impl Observer<Grow>,
    ) -> Result<Option<(FreePlane, f32)>, Cancelled> {
        let Cells { prims, rule, ref mut random, pad } = *self;
        Scale { prims, rule, random, pad, node, cell, refs, watch }.best()
    }

    fn cut(
        &mut self,
        cell: &ConvexCell,
        refs: &[Fragment],
        plane: FreePlane,
        watch: &impl Observer<Grow>,
    ) -> Result<[Half<Self>; 2], Cancelled> {
        let (mut lower, mut upper) = (Vec::new(), Vec::new());
        for fragment in patiently(refs, watch) {
            let fragment = fragment?;
            match (self.sides(fragment, plane), self.rule.straddlers) {
                ((true, false), _) => lower.push(fragment.clone()),
                ((false, true), _) => upper.push(fragment.clone()),
                (_, Straddlers::Both) => {
                    lower.push(fragment.clone());
                    upper.push(fragment.clone());
                }
                (_, Straddlers::Cut) => {
                    let [below, above] = fragment.cut(plane, self.pad);
                    lower.push(below);
                    upper.push(above);
                }
            }
        }
        let [below, above] = cell.cut(plane);
        Ok([(below, lower), (above, upper)])
    }
}
