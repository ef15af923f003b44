//! Building a hierarchy from below, slide 54: the two nearest sets become one until one is left.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::ploc;
use super::sapling::{Nearness, Sapling};
use crate::{Cancelled, Draft, Grow, Observer, Primitives};

/// Of more sets than this not all pairs are compared: PLOC joins them until so few are left.
const MOST: usize = 1 << 14;

/// Two sets and how far apart they are; of equals the pair with the fewest primitives comes first.
type Pair = (Nearness, u32, u32, u32);

/// Joins everything; the root.
pub(super) fn join_all<D: Draft, P: Primitives>(
    tree: &mut Sapling<'_, D, P>,
    watch: &mut impl Observer<Grow>,
) -> Result<u32, Cancelled> {
    let sets = tree.sprout_all(watch)?;
    let mut live = ploc::join_until(tree, sets, MOST, watch)?;
    // For each set the nearest of those after it; for later ones, of all. So the nearest two of all are there.
    let mut heap: BinaryHeap<Reverse<Pair>> = BinaryHeap::new();
    for i in 0..live.len() {
        if watch.cancelled() {
            return Err(Cancelled);
        }
        heap.extend(nearest(tree, live[i], &live[i + 1..]).map(Reverse));
    }
    let mut gone = vec![false; 2 * tree.len()];
    while live.len() > 1 {
        if watch.cancelled() {
            return Err(Cancelled);
        }
        let Some(Reverse((_, _, a, b))) = heap.pop() else { break };
        if gone[a as usize] {
            continue;
        }
        if gone[b as usize] {
            // Its nearest was joined meanwhile: look again.
            heap.extend(nearest(tree, a, &live).map(Reverse));
            continue;
        }
        // The two nearest become one, the last of all sets; each other set may be near it.
        live.retain(|&set| set != a && set != b);
        let both = tree.join(a, b, watch);
        gone[a as usize] = true;
        gone[b as usize] = true;
        heap.extend(nearest(tree, both, &live).map(Reverse));
        live.push(both);
    }
    Ok(live[0])
}

/// The nearest of `others`.
fn nearest<D: Draft, P: Primitives>(tree: &Sapling<'_, D, P>, set: u32, others: &[u32]) -> Option<Pair> {
    let pair = |&other: &u32| (tree.nearness(set, other), tree.count(set) + tree.count(other), set, other);
    others.iter().filter(|&&other| other != set).map(pair).min()
}
