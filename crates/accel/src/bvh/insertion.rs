//! Building a hierarchy by insertion, slide 55: each primitive goes to where the tree grows least (Bittner,
//! Hapala and Havran, "Incremental BVH construction for ray tracing", 2015), then the way up is straightened.

use super::sapling::Sapling;
use crate::{Cancelled, Draft, Grow, Observer, PrimId, Primitives};

/// Inserts everything; the root.
pub(super) fn insert_all<D: Draft, P: Primitives>(
    tree: &mut Sapling<'_, D, P>,
    watch: &mut impl Observer<Grow>,
) -> Result<u32, Cancelled> {
    let mut root = tree.sprout(PrimId(0), watch);
    for prim in (1..tree.len() as u32).map(PrimId) {
        if watch.cancelled() {
            return Err(Cancelled);
        }
        let leaf = tree.sprout(prim, watch);
        let sibling = cheapest(tree, root, leaf, watch);
        // A new node takes the sibling's place and holds both.
        let parent = tree.parent(sibling);
        let both = tree.join(sibling, leaf, watch);
        match parent {
            None => root = both,
            Some(parent) => tree.hang(both, parent, sibling, watch),
        }
        // All the way up volumes grow, and children change places where that makes a volume smaller.
        let mut above = parent;
        while let Some(node) = above {
            tree.refit(node, watch);
            rotate(tree, node, watch);
            above = tree.parent(node);
        }
    }
    Ok(root)
}

/// The node beside which the leaf makes the tree grow least. What lies below a node cannot cost less than the
/// leaf itself and what all above it grow by.
fn cheapest<D: Draft, P: Primitives>(
    tree: &Sapling<'_, D, P>,
    root: u32,
    leaf: u32,
    watch: &mut impl Observer<Grow>,
) -> u32 {
    let own = tree.measure(leaf);
    let (mut best, mut least) = (root, f32::INFINITY);
    let mut waiting = vec![(root, 0.0)];
    while let Some((node, above)) = waiting.pop() {
        if own + above >= least {
            continue;
        }
        tree.touch(node, watch);
        let both = tree.joint(node, leaf);
        if both + above < least {
            (best, least) = (node, both + above);
        }
        let above = above + both - tree.measure(node);
        if let Some([left, right]) = tree.children(node)
            && own + above < least
        {
            // The child that grows less is looked at first.
            let growth = |child: u32| tree.joint(child, leaf) - tree.measure(child);
            let order = if growth(right) < growth(left) { [left, right] } else { [right, left] };
            waiting.extend(order.map(|child| (child, above)));
        }
    }
    best
}

/// Lets a child and a grandchild on the other side change places if that makes the other child smaller.
fn rotate<D: Draft, P: Primitives>(tree: &mut Sapling<'_, D, P>, node: u32, watch: &mut impl Observer<Grow>) {
    let Some([left, right]) = tree.children(node) else { return };
    let mut best = None;
    let mut most = 0.0;
    for (child, other) in [(left, right), (right, left)] {
        let Some([a, b]) = tree.children(other) else { continue };
        for (up, stays) in [(a, b), (b, a)] {
            let gain = tree.measure(other) - tree.joint(child, stays);
            if gain > most {
                (best, most) = (Some((child, other, up)), gain);
            }
        }
    }
    if let Some((child, other, up)) = best {
        tree.hang(up, node, child, watch);
        tree.hang(child, other, up, watch);
        tree.refit(other, watch);
    }
}
