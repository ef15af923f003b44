//! A tree of two children.

use raystep_accel::Aabb;

/// A tree whose inner nodes have two children.
#[derive(Clone, Debug)]
pub(crate) struct Tree {
    /// The box around everything; empty if there is nothing.
    pub(crate) root: Knot,
    /// Children side by side: a node's own pair, then those below its left child, then those below its right one. Some may
    /// be unused.
    pub(crate) pairs: Vec<[Knot; 2]>,
    /// The triangles of the leaves.
    pub(crate) prims: Vec<u32>,
    /// The most nodes on the way from the root to a leaf.
    pub(crate) depth: u32,
    /// Whether leaves may hold parts of triangles only, so that their boxes do not enclose those.
    pub(crate) parted: bool,
}

/// A node.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Knot {
    pub(crate) bounds: Aabb,
    /// Its first triangle if it is a leaf, its pair of children if it is none.
    first: u32,
    /// How many triangles it has if it is a leaf.
    count: u32,
}

impl Knot {
    pub(crate) const EMPTY: Knot = Knot { bounds: Aabb::EMPTY, first: 0, count: 0 };

    pub(crate) fn leaf(bounds: Aabb, first: u32, count: u32) -> Knot {
        Knot { bounds, first, count }
    }

    pub(crate) fn inner(bounds: Aabb, pair: u32) -> Knot {
        Knot { bounds, first: pair, count: 0 }
    }

    /// The first triangle of a leaf and how many there are.
    pub(crate) fn range(&self) -> (u32, u32) {
        (self.first, self.count)
    }

    /// The number of an inner node's pair of children.
    pub(crate) fn pair(&self) -> usize {
        self.first as usize
    }
}

impl Tree {
    /// The two children of a node, or nothing for a leaf.
    #[inline]
    pub(crate) fn children(&self, knot: &Knot) -> Option<&[Knot; 2]> {
        (knot.count == 0).then(|| &self.pairs[knot.first as usize])
    }

    /// The triangles of a leaf.
    #[inline]
    pub(crate) fn leaf_prims(&self, knot: &Knot) -> &[u32] {
        &self.prims[knot.first as usize..][..knot.count as usize]
    }

    /// The triangles of all leaves below a node, each once.
    pub(crate) fn all_prims(&self, knot: &Knot, found: &mut Vec<u32>) {
        match self.children(knot) {
            None => {
                for prim in self.leaf_prims(knot) {
                    if !self.parted || !found.contains(prim) {
                        found.push(*prim);
                    }
                }
            }
            Some(children) => children.iter().for_each(|child| self.all_prims(child, found)),
        }
    }

    /// Whether there are no more than so many triangles below a node.
    pub(crate) fn has_few(&self, knot: &Knot, most: usize) -> bool {
        // No leaf is empty, so nothing is looked at for longer than a few steps once too many are found.
        let (mut count, mut waiting) = (0, vec![knot]);
        while let Some(knot) = waiting.pop() {
            match self.children(knot) {
                None => count += knot.count as usize,
                Some(children) => waiting.extend(children),
            }
            if count + waiting.len() > most {
                return false;
            }
        }
        true
    }

    /// The most nodes on the way from the root to a leaf.
    pub(super) fn measured_depth(&self) -> u32 {
        let (mut deepest, mut waiting) = (0, vec![(self.root, 1)]);
        while let Some((knot, depth)) = waiting.pop() {
            deepest = deepest.max(depth);
            if !self.prims.is_empty()
                && let Some(children) = self.children(&knot)
            {
                waiting.extend(children.map(|child| (child, depth + 1)));
            }
        }
        deepest
    }

    /// The largest coordinate, without its sign.
    pub(crate) fn reach(&self) -> f32 {
        let Aabb { min, max } = self.root.bounds;
        if self.prims.is_empty() { 0.0 } else { min.abs().max(max.abs()).max_element() }
    }
}
