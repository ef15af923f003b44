//! Which nodes of a tree are drawn. Of a large one: the path to where the walk stands with what hangs
//! off it, then as much more, from the top down, as there is room for.

use std::collections::{BTreeSet, VecDeque};

use raystep_accel::{Direction, NodeId, PrimId};

use super::tidy::{Tidy, Twig, tidy};
use crate::theme::Role;

/// What the user has zoomed to, opened and closed in a tree.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TreeView {
    /// The node to draw on top, if not the root.
    pub focus: Option<NodeId>,
    /// Nodes to open where there is room.
    pub opened: Vec<NodeId>,
    /// Nodes to keep closed.
    pub closed: Vec<NodeId>,
}

/// What the drawing of a tree asks, of a finished tree or of one that grows.
pub(crate) trait Tree {
    /// The children of a node; none of a leaf.
    fn children(&self, node: NodeId) -> Vec<NodeId>;
    /// The axis across which a node is split.
    fn axis(&self, node: NodeId) -> Option<Direction>;
    /// What a leaf refers to.
    fn prims(&self, node: NodeId) -> Vec<PrimId>;
    /// The state of a node.
    fn role(&self, node: NodeId) -> Role;
    /// The state of a primitive.
    fn prim_role(&self, prim: PrimId) -> Role;
    /// From the root to where things happen.
    fn path(&self) -> Vec<NodeId>;
}

/// How much fits: points of width, levels of height, and how large a node is drawn.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Room<F> {
    pub(crate) width: f32,
    pub(crate) levels: usize,
    pub(crate) gap: f32,
    /// Half the width of a node's mark.
    pub(crate) half_width: F,
}

/// A node that is drawn.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Branch {
    pub(crate) node: NodeId,
    pub(crate) level: usize,
    pub(crate) children: Vec<usize>,
    /// Whether it has children that are not drawn.
    pub(crate) closed: bool,
}

/// The drawn part of a tree, the topmost node first.
#[derive(Clone, Debug)]
pub(crate) struct Branches {
    /// The ancestors of the topmost node that did not fit, the root first.
    pub(crate) above: Vec<NodeId>,
    pub(crate) shown: Vec<Branch>,
    pub(crate) tidy: Tidy,
}

impl Branches {
    /// Whether nothing was left out.
    pub(crate) fn whole(&self) -> bool {
        self.above.is_empty() && self.shown.iter().all(|branch| !branch.closed)
    }
}

/// Most nodes that are drawn: an eye reads no more.
pub(crate) const MOST: usize = 36;

/// Chooses what is drawn and lays it out.
pub(crate) fn branches<F: Fn(NodeId) -> f32>(tree: &impl Tree, view: &TreeView, room: &Room<F>) -> Branches {
    let mut path = tree.path();
    if let Some(focus) = view.focus {
        match path.iter().position(|node| *node == focus) {
            Some(index) => drop(path.drain(..index)),
            None => path = vec![focus],
        }
    }
    // The lower end of a long path, with a level for the children of its end.
    let end = path.last().is_some_and(|end| !tree.children(*end).is_empty());
    let keep = room.levels.saturating_sub(usize::from(end)).max(1);
    let mut above: Vec<NodeId> = path.drain(..path.len().saturating_sub(keep)).collect();
    let mut open: BTreeSet<NodeId>;
    let mut best;
    loop {
        open = path.iter().copied().filter(|node| !view.closed.contains(node)).collect();
        best = grow(tree, path.first().copied().unwrap_or(NodeId::ROOT), &open, room);
        if best.1.width <= room.width || path.len() < 2 {
            break;
        }
        above.push(path.remove(0));
    }
    let top = best.0[0].node;

    // What the user opened, then level by level: whatever still fits.
    let mut queue: VecDeque<NodeId> = view.opened.iter().copied().chain([top]).collect();
    let fits = |(shown, tidy): &(Vec<Branch>, Tidy)| shown.len() <= MOST && tidy.width <= room.width;
    while let Some(node) = queue.pop_front() {
        let Some(branch) = best.0.iter().find(|branch| branch.node == node) else { continue };
        if branch.closed && branch.level + 1 < room.levels && !view.closed.contains(&node) {
            open.insert(node);
            let more = grow(tree, top, &open, room);
            if fits(&more) {
                best = more;
            } else {
                open.remove(&node);
            }
        }
        let shown = best.0.iter().find(|branch| branch.node == node);
        queue.extend(shown.iter().flat_map(|branch| &branch.children).map(|&child| best.0[child].node));
    }
    Branches { above, shown: best.0, tidy: best.1 }
}

/// The nodes below `top` that are reached through open ones, level by level.
fn grow<F: Fn(NodeId) -> f32>(
    tree: &impl Tree,
    top: NodeId,
    open: &BTreeSet<NodeId>,
    room: &Room<F>,
) -> (Vec<Branch>, Tidy) {
    let mut shown = vec![Branch { node: top, level: 0, children: Vec::new(), closed: false }];
    let mut index = 0;
    while index < shown.len() && shown.len() <= 2 * MOST {
        let Branch { node, level, .. } = shown[index];
        let children = tree.children(node);
        if open.contains(&node) && level + 1 < room.levels {
            for child in children {
                let at = shown.len();
                shown[index].children.push(at);
                shown.push(Branch { node: child, level: level + 1, children: Vec::new(), closed: false });
            }
        } else {
            shown[index].closed = !children.is_empty();
        }
        index += 1;
    }
    let mut twigs: Vec<Twig> = shown
        .iter()
        .map(|branch| Twig { half_width: (room.half_width)(branch.node), children: branch.children.clone() })
        .collect();
    // What hangs below a closed node, and the dots of a leaf, take up room on the next level.
    for index in (0..shown.len()).filter(|index| shown[*index].children.is_empty()) {
        let below = twigs.len();
        let half_width = if shown[index].closed { twigs[index].half_width } else { room.gap * 0.3 };
        twigs[index].children.push(below);
        twigs.push(Twig { half_width, children: Vec::new() });
    }
    let tidy = tidy(&twigs, room.gap);
    (shown, tidy)
}

/// How many nodes hang below one, itself included; counts no further than `most`.
pub(crate) fn count_below(tree: &impl Tree, node: NodeId, most: usize) -> usize {
    let (mut count, mut left) = (0, vec![node]);
    while let Some(node) = left.pop() {
        count += 1;
        if count > most {
            break;
        }
        left.extend(tree.children(node));
    }
    count
}
