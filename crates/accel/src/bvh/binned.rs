//! A few evenly spaced planes are weighed (Wald, "On fast construction of SAH-based BVHs", 2007).

use super::splitter::{Choice, Part, Splitter};
use crate::events::patiently;
use crate::{Aabb, Axis, Cancelled, Grow, NodeId, Observer};

/// The primitives whose centres lie between two neighbouring planes.
#[derive(Clone, Copy)]
struct Bin {
    count: usize,
    bounds: Aabb,
}

impl Bin {
    const EMPTY: Bin = Bin { count: 0, bounds: Aabb::EMPTY };

    fn union(self, other: Bin) -> Bin {
        Bin { count: self.count + other.count, bounds: self.bounds.union(other.bounds) }
    }
}

/// Finds the plane with the least expected cost; the first of equals. Nothing if all centres coincide.
pub(super) fn choose(
    splitter: &Splitter<'_>,
    node: NodeId,
    part: &Part,
    watch: &mut impl Observer<Grow>,
) -> Result<Option<Choice>, Cancelled> {
    let mut best: Option<Choice> = None;
    for &axis in splitter.rule.axes.list() {
        // The primitives are ordered, so the outermost centres are the first and the last.
        let order = splitter.ordered(part, axis);
        let (low, high) = (splitter.center(order[0], axis), splitter.center(order[order.len() - 1], axis));
        if low >= high {
            continue;
        }
        let bins = fill(splitter, order, axis, [low, high], watch)?;

        // From above: everything from a bin on.
        let mut above = bins.clone();
        for i in (0..bins.len() - 1).rev() {
            above[i] = above[i].union(above[i + 1]);
        }

        // From below: weigh each plane between two bins.
        let mut below = Bin::EMPTY;
        for i in 1..bins.len() {
            below = below.union(bins[i - 1]);
            let above = above[i];
            if below.count == 0 || above.count == 0 {
                continue;
            }
            let plane = low + (high - low) * i as f32 / bins.len() as f32;
            let side = |bin: Bin| (splitter.measure(&bin.bounds), bin.count);
            let cost = splitter.weigh(node, part, (axis, plane), [side(below), side(above)], watch);
            if best.is_none_or(|best| cost < best.cost) {
                best = Some(Choice { axis, plane, below: below.count, cost });
            }
        }
    }
    Ok(best)
}

/// Throws each primitive into the bin of its centre.
fn fill(
    splitter: &Splitter<'_>,
    order: &[u32],
    axis: Axis,
    [low, high]: [f32; 2],
    watch: &impl Observer<Grow>,
) -> Result<Vec<Bin>, Cancelled> {
    let mut bins = vec![Bin::EMPTY; splitter.rule.bins.max(2) as usize];
    let last = bins.len() - 1;
    let scale = bins.len() as f32 / (high - low);
    for prim in patiently(order, watch) {
        let &prim = prim?;
        let index = ((splitter.center(prim, axis) - low) * scale) as usize;
        let bin = &mut bins[index.min(last)];
        bin.count += 1;
        bin.bounds = bin.bounds.union(splitter.boxes[prim as usize]);
    }
    Ok(bins)
}
