//! The cheapest place of all: every division along every axis is weighed.

use super::splitter::{Choice, Part, Splitter};
use crate::events::{BETWEEN_LOOKS, patiently};
use crate::{Aabb, Cancelled, Grow, NodeId, Observer};

/// Finds the division with the least expected cost; the first of equals.
pub(super) fn choose(
    splitter: &mut Splitter<'_>,
    node: NodeId,
    part: &Part,
    watch: &mut impl Observer<Grow>,
) -> Result<Option<Choice>, Cancelled> {
    let n = part.len();
    let mut best: Option<Choice> = None;
    let mut measures = std::mem::take(&mut splitter.measures);
    for &axis in splitter.rule.axes.list() {
        let order = splitter.ordered(part, axis);

        // From above: how large the box around the last ones is.
        let mut above = Aabb::EMPTY;
        for i in patiently((1..n).rev(), watch) {
            let i = i?;
            above = above.union(splitter.boxes[order[i] as usize]);
            measures[i] = splitter.measure(&above);
        }

        // From below: weigh each division.
        let mut below = Aabb::EMPTY;
        for i in 1..n {
            if i % BETWEEN_LOOKS == 0 && watch.cancelled() {
                return Err(Cancelled);
            }
            below = below.union(splitter.boxes[order[i - 1] as usize]);
            let plane = splitter.center(order[i], axis);
            let sides = [(splitter.measure(&below), i), (measures[i], n - i)];
            let cost = splitter.weigh(node, part, (axis, plane), sides, watch);
            if best.is_none_or(|best| cost < best.cost) {
                best = Some(Choice { axis, plane, below: i, cost });
            }
        }
    }
    splitter.measures = measures;
    Ok(best)
}
