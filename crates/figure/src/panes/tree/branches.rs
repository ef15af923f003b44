//! Which nodes of a tree are drawn: all of a small one. Of a large one the path to where the walk stands with what
//! hangs off it, then as much more, from the top down, as there is room for.

use std::borrow::Cow;
use std::collections::{BTreeSet, VecDeque};

use raystep_accel::{Direction, Lanes, NodeId, PrimId};

use super::tidy::{Tidy, Twig, tidy};
use crate::theme::Role;
use crate::world::Levels;

/// What the user has zoomed to, opened and closed in a tree.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TreeView {
    /// The node to draw on top, if not the root.
    pub focus: Option<NodeId>,
    /// Nodes to open where there is room.
    pub opened: Vec<NodeId>,
    /// Nodes to keep closed.
    pub closed: Vec<NodeId>,
    /// Whether it is left out how many nodes there are in all.
    pub uncounted: bool,
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
    /// How the nodes lie below the root of that path.
    fn levels(&self) -> Cow<'_, Levels>;
    /// Whether a node is none, but the ground on which the trees of a forest stand: it is not drawn.
    fn is_ground(&self, node: NodeId) -> bool {
        let _ = node;
        false
    }
    /// Which rays of a packet took part in a node, or wait to.
    fn lanes(&self, node: NodeId) -> Option<Lanes> {
        let _ = node;
        None
    }
    /// Any lanes of the packet, if one walks: every node leaves room for them.
    fn has_lanes(&self) -> Option<Lanes> {
        None
    }
}

/// How much fits, and how much room a node takes.
pub(crate) struct Room<'a> {
    /// Points from the left to the right.
    pub(crate) width: f32,
    /// Rows of nodes.
    pub(crate) levels: usize,
    /// Points between two nodes.
    pub(crate) gap: f32,
    /// How far a node with what belongs to it reaches to the left and to the right of its middle.
    pub(crate) sides: &'a dyn Fn(&Branch) -> [f32; 2],
    /// Half the width of what stands for the nodes below a closed one.
    pub(crate) rest: &'a dyn Fn(NodeId) -> f32,
}

/// A node that is drawn.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Branch {
    pub(crate) node: NodeId,
    pub(crate) level: usize,
    pub(crate) children: Vec<usize>,
    /// Whether it has children that are not drawn.
    pub(crate) closed: bool,
    /// Whether it stands to the left of its parent.
    pub(crate) left: bool,
}

impl Branch {
    /// Whether nothing hangs below it.
    pub(crate) fn is_leaf(&self) -> bool {
        self.children.is_empty() && !self.closed
    }
}

/// The drawn part of a tree, the topmost node first.
#[derive(Clone, Debug)]
pub(crate) struct Branches {
    /// The ancestors of the topmost node, the root first.
    pub(crate) above: Vec<NodeId>,
    pub(crate) shown: Vec<Branch>,
    pub(crate) tidy: Tidy,
}

impl Branches {
    /// Whether nothing was left out.
    pub(crate) fn is_whole(&self) -> bool {
        self.above.is_empty() && self.shown.iter().all(|branch| !branch.closed)
    }
}

/// Of a tree that is drawn in parts, most nodes that are: an eye reads no more.
const MOST: usize = 36;

/// The path from the root, or from the node that is to be on top, and what lies above that.
fn trunk(tree: &dyn Tree, view: &TreeView) -> (Vec<NodeId>, Vec<NodeId>) {
    let mut path = tree.path();
    match view.focus.map(|focus| (focus, path.iter().position(|node| *node == focus))) {
        None => (Vec::new(), path),
        Some((_, Some(index))) => {
            let rest = path.split_off(index);
            (path, rest)
        }
        // Beside the path: of what lies above it, the root.
        Some((focus, None)) => (path.into_iter().take(1).collect(), vec![focus]),
    }
}

/// All of a tree with at most so many nodes below the topmost one, if it fits.
pub(crate) fn whole(tree: &dyn Tree, view: &TreeView, most: usize, room: &Room<'_>) -> Option<Branches> {
    let (above, path) = trunk(tree, view);
    let top = *path.first()?;
    let is_open = |node: NodeId| !view.closed.contains(&node);
    let (shown, tidy) = grow(tree, top, &is_open, most, room)?;
    let fits = tidy.width <= room.width && shown.iter().all(|branch| !branch.closed || !is_open(branch.node));
    fits.then_some(Branches { above, shown, tidy })
}

/// Chooses what is drawn of a tree that does not fit, and lays it out.
pub(crate) fn part(tree: &dyn Tree, view: &TreeView, room: &Room<'_>) -> Branches {
    let (mut above, mut path) = trunk(tree, view);
    // The lower end of a long path, with a level for the children of its end.
    let end = path.last().is_some_and(|end| !tree.children(*end).is_empty());
    let keep = room.levels.saturating_sub(usize::from(end)).max(1);
    above.extend(path.drain(..path.len().saturating_sub(keep)));
    let drawn = |top: NodeId, open: &BTreeSet<NodeId>| {
        let is_open = |node: NodeId| open.contains(&node);
        // More than the most are never open at a time.
        grow(tree, top, &is_open, usize::MAX, room).unwrap_or_default()
    };
    let mut open: BTreeSet<NodeId>;
    let mut best;
    loop {
        open = path.iter().copied().filter(|node| !view.closed.contains(node)).collect();
        best = drawn(path.first().copied().unwrap_or(NodeId::ROOT), &open);
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
            let more = drawn(top, &open);
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

/// The nodes below `top` that are reached through open ones, level by level; nothing if they are more than `most`.
fn grow(
    tree: &dyn Tree,
    top: NodeId,
    is_open: &dyn Fn(NodeId) -> bool,
    most: usize,
    room: &Room<'_>,
) -> Option<(Vec<Branch>, Tidy)> {
    let branch = |node, level, left| Branch { node, level, children: Vec::new(), closed: false, left };
    let mut shown = vec![branch(top, 0, false)];
    let mut index = 0;
    while index < shown.len() {
        let Branch { node, level, .. } = shown[index];
        let children = tree.children(node);
        if is_open(node) && level + 1 < room.levels {
            let half = children.len() / 2;
            for (place, child) in children.into_iter().enumerate() {
                let at = shown.len();
                shown[index].children.push(at);
                shown.push(branch(child, level + 1, place < half));
            }
        } else {
            shown[index].closed = !children.is_empty();
        }
        if shown.len() > most {
            return None;
        }
        index += 1;
    }
    let mut twigs: Vec<Twig> =
        shown.iter().map(|branch| Twig { sides: (room.sides)(branch), children: branch.children.clone() }).collect();
    // What stands for the nodes below a closed one takes up room on the next level.
    for index in (0..shown.len()).filter(|index| shown[*index].closed) {
        let below = twigs.len();
        twigs[index].children.push(below);
        twigs.push(Twig { sides: [(room.rest)(shown[index].node); 2], children: Vec::new() });
    }
    let tidy = tidy(&twigs, room.gap);
    Some((shown, tidy))
}
