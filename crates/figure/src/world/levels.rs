//! How the nodes of a tree lie: on which level each, and how many hang below it.

use raystep_accel::NodeId;

use super::space::Depth;

/// The levels of a tree, the root's first.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Levels {
    /// How many nodes there are on each level.
    counts: Vec<usize>,
    /// Of each node of the tree its level, and how many nodes hang below it.
    nodes: Vec<Option<(u32, u32)>>,
}

impl Levels {
    /// Those of the tree below `root`.
    pub(crate) fn of(root: NodeId, children: impl Fn(NodeId) -> Vec<NodeId>) -> Levels {
        // Level by level: each node with its level and the place of its parent in this list.
        let mut order = vec![(root, 0_u32, 0_usize)];
        let mut next = 0;
        while let Some(&(node, level, _)) = order.get(next) {
            order.extend(children(node).into_iter().map(|child| (child, level + 1, next)));
            next += 1;
        }
        let mut below = vec![0_u32; order.len()];
        for (index, &(.., parent)) in order.iter().enumerate().skip(1).rev() {
            below[parent] += below[index] + 1;
        }
        let mut levels = Levels::default();
        for (&(node, level, _), below) in order.iter().zip(below) {
            if levels.counts.len() <= level as usize {
                levels.counts.push(0);
            }
            levels.counts[level as usize] += 1;
            if levels.nodes.len() <= node.index() {
                levels.nodes.resize(node.index() + 1, None);
            }
            levels.nodes[node.index()] = Some((level, below));
        }
        levels
    }

    /// How many nodes there are on each level, the root's first.
    pub(crate) fn counts(&self) -> &[usize] {
        &self.counts
    }

    /// The level of the nodes that lie deepest; the root's is 0.
    pub(crate) fn deepest(&self) -> usize {
        self.counts.len().saturating_sub(1)
    }

    /// The level on which a node lies.
    pub(crate) fn level(&self, node: NodeId) -> Option<usize> {
        let (level, _) = (*self.nodes.get(node.index())?)?;
        Some(level as usize)
    }

    /// How many nodes hang below one, itself not included.
    pub(crate) fn below(&self, node: NodeId) -> usize {
        self.nodes.get(node.index()).copied().flatten().map_or(0, |(_, below)| below as usize)
    }
}

/// The nodes of a level of a tree, with the leaves above it; of a level with more than so many, the last one that
/// has no more.
pub(crate) fn frontier(level: usize, most: usize, children: impl Fn(NodeId) -> Vec<NodeId>) -> Vec<NodeId> {
    let mut row = vec![NodeId::ROOT];
    for _ in 0..level {
        let below = row.iter().flat_map(|&node| match children(node) {
            none if none.is_empty() => vec![node],
            some => some,
        });
        let next: Vec<NodeId> = below.take(most + 1).collect();
        if next.len() > most || next == row {
            break;
        }
        row = next;
    }
    row
}

/// What of a tree with levels down to `deepest` is drawn: of its `volumes`.
pub(crate) fn drawn(volumes: &str, depth: Depth, deepest: usize) -> String {
    match depth {
        Depth::Path => format!("{volumes}: the end of the path and its siblings; {} levels in all", deepest + 1),
        Depth::Down(level) => format!("{volumes}: down to level {level} of {deepest}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_are_counted_from_the_root() {
        // 0 over 1 and 2; 2 over 5, 6 and 7.
        let children = |node: NodeId| match node.0 {
            0 => vec![NodeId(1), NodeId(2)],
            2 => vec![NodeId(5), NodeId(6), NodeId(7)],
            _ => Vec::new(),
        };
        let levels = Levels::of(NodeId::ROOT, children);
        assert_eq!((levels.counts(), levels.deepest()), (&[1, 2, 3][..], 2));
        assert_eq!([0, 1, 2, 6].map(|node| levels.below(NodeId(node))), [5, 0, 3, 0]);
        assert_eq!([0, 2, 6, 3].map(|node| levels.level(NodeId(node))), [Some(0), Some(1), Some(2), None]);
        // A part of a tree counts from its own root.
        assert_eq!(Levels::of(NodeId(2), children).counts(), [1, 3]);
    }
}
