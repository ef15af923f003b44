//! What builders do that put sets together: nodes are joined, moved, fitted anew, and laid in their order at last.

use raystep_accel::{Aabb, Grow, NodeId};

use super::{Build, GrowMoment, GrowNode};
use crate::world::Form;

impl Build<'_> {
    /// Whether this builder puts sets together, and divides none.
    pub(crate) fn joins(&self) -> bool {
        // A builder that divides does so before it can join anything.
        let first = self.events.iter().find(|event| {
            matches!(event, Grow::Merge { .. } | Grow::Split { .. } | Grow::Divide { .. } | Grow::Leaf { .. })
        });
        matches!(first, Some(Grow::Merge { .. }))
    }

    /// What a node looks like so far, in this box. A set that is joined and moved has only its box, until it lies
    /// where it stays: then it has the volume of the finished tree.
    pub(crate) fn look(&self, moment: &GrowMoment, node: NodeId, bounds: Aabb) -> Vec<Form> {
        let grows = moment.nodes.get(&node).is_some_and(|node| !node.placed);
        if grows && !self.nodes.are_boxes() && self.joins() {
            return if bounds.is_empty() { Vec::new() } else { vec![Form::Box(bounds)] };
        }
        self.nodes.look(self.structure, node, bounds, self.flat)
    }
}

impl GrowMoment {
    /// Two nodes become the children of a third, which may have stood before with others below it.
    pub(super) fn join(&mut self, node: NodeId, children: [NodeId; 2], bounds: Aabb) {
        self.consider(node);
        self.tally.joined += 1;
        self.shorten(node, children, bounds);
        let prims = children.iter().filter_map(|child| self.nodes.get(child)).map(|child| child.prims).sum();
        self.forget_below(node);
        let fresh = GrowNode {
            bounds,
            prims,
            depth: 0,
            split: None,
            children: Vec::new(),
            leaf: None,
            settled: Vec::new(),
            placed: false,
        };
        self.nodes.insert(node, fresh);
        for child in children {
            self.hang(child, node);
        }
    }

    /// A set chooses its neighbour; with the first choice after sets were joined a round begins.
    pub(super) fn prefer(&mut self, node: NodeId, nearest: NodeId) {
        if matches!(self.last, Some(Grow::Merge { .. })) {
            self.preferred.clear();
        }
        self.consider(node);
        self.preferred.push((node, nearest));
    }

    /// The sets on the curve in their order, each the root of a tree of its own.
    pub(crate) fn roots(&self) -> Vec<NodeId> {
        self.curve.iter().map(|(node, _)| *node).collect()
    }

    /// The sets that no node holds together yet, if there are several.
    pub(crate) fn apart(&self) -> Vec<NodeId> {
        let sets: Vec<NodeId> = self.nodes.keys().filter(|node| !self.parents.contains_key(node)).copied().collect();
        if sets.len() > 1 { sets } else { Vec::new() }
    }

    /// On the curve, two sets become one in the place of the first.
    fn shorten(&mut self, node: NodeId, children: [NodeId; 2], bounds: Aabb) {
        let mut places = (0..self.curve.len()).filter(|place| children.contains(&self.curve[*place].0));
        if let (Some(first), Some(second)) = (places.next(), places.next()) {
            self.curve[first] = (node, bounds.center());
            self.curve.remove(second);
        }
    }

    /// A node is taken from where it hangs and put under another.
    pub(super) fn hang(&mut self, node: NodeId, parent: NodeId) {
        if let Some(old) = self.parents.insert(node, parent)
            && let Some(old) = self.nodes.get_mut(&old)
        {
            old.children.retain(|child| *child != node);
        }
        if let Some(parent) = self.nodes.get_mut(&parent) {
            parent.children.push(node);
        }
        self.count_again(parent);
    }

    /// A node and all above it hold what their children hold together.
    fn count_again(&mut self, node: NodeId) {
        let mut next = Some(node);
        while let Some(id) = next {
            let children = self.nodes.get(&id).map(|node| node.children.clone()).unwrap_or_default();
            let prims = children.iter().filter_map(|child| self.nodes.get(child)).map(|child| child.prims).sum();
            if let Some(node) = self.nodes.get_mut(&id) {
                node.prims = prims;
            }
            next = self.parents.get(&id).copied();
        }
    }

    /// A node's volume is another now.
    pub(super) fn refit(&mut self, node: NodeId, bounds: Aabb) {
        self.consider(node);
        if let Some(node) = self.nodes.get_mut(&node) {
            node.bounds = bounds;
        }
    }

    /// A node is laid where it stays, and has its final number from now on, if it had not before.
    pub(super) fn renumber(&mut self, from: NodeId, to: NodeId) {
        let Some(mut node) = self.nodes.remove(&from) else { return };
        node.placed = true;
        self.parents.extend(node.children.iter().map(|child| (*child, to)));
        self.nodes.insert(to, node);
        if let Some(parent) = self.parents.remove(&from) {
            self.parents.insert(to, parent);
            if let Some(parent) = self.nodes.get_mut(&parent) {
                parent.children.iter_mut().filter(|child| **child == from).for_each(|child| *child = to);
                parent.children.sort_unstable();
            }
        }
        self.consider(to);
    }

    /// What lies below a node is gone; says how many references went with it.
    pub(super) fn forget_below(&mut self, node: NodeId) -> usize {
        let Some(node) = self.nodes.get_mut(&node) else { return 0 };
        let mut gone = std::mem::take(&mut node.children);
        let mut references = 0;
        while let Some(child) = gone.pop() {
            self.parents.remove(&child);
            let Some(child) = self.nodes.remove(&child) else { continue };
            references += child.settled.len();
            gone.extend(child.children);
        }
        references
    }
}
