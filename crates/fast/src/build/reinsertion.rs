//! Nodes taken out of a tree and put back where they cost least: Meister and Bittner, "Parallel Reinsertion for Bounding
//! Volume Hierarchy Optimization" (2018).

use rayon::prelude::*;

use super::Tree;
use super::reference::Box4;

/// In each round every so many-th node is looked at, the largest ones.
const PART: usize = 4;

/// Improves a tree, in so many rounds.
pub(super) fn improve(tree: &mut Tree, rounds: u32) {
    if tree.prims.len() < 3 {
        return;
    }
    let mut loose = Loose::of(tree);
    for _ in 0..rounds {
        if loose.round() == 0 {
            break;
        }
    }
    loose.back(tree);
}

/// The root is number 0, and the children of pair p are numbers 2p + 1 and 2p + 2.
type Number = u32;

/// A tree whose nodes know their parents.
struct Loose {
    boxes: Vec<Box4>,
    areas: Vec<f32>,
    /// The first of a node's two children, or nothing for a leaf.
    children: Vec<Number>,
    parents: Vec<Number>,
    /// What a leaf holds.
    leaves: Vec<(u32, u32)>,
}

/// A leaf has no children: no node's first child is the root.
const LEAF: Number = 0;

/// A node that would be better off elsewhere.
#[derive(Clone, Copy)]
struct Move {
    node: Number,
    /// Beside which it is to stand.
    to: Number,
    gain: f32,
}

fn sibling(node: Number) -> Number {
    ((node - 1) ^ 1) + 1
}

impl Loose {
    fn of(tree: &Tree) -> Loose {
        let many = 2 * tree.pairs.len() + 1;
        let mut loose = Loose {
            boxes: vec![Box4::EMPTY; many],
            areas: vec![0.0; many],
            children: vec![LEAF; many],
            parents: vec![0; many],
            leaves: vec![(0, 0); many],
        };
        let mut waiting = vec![(0, tree.root)];
        while let Some((at, knot)) = waiting.pop() {
            let node = at as usize;
            loose.boxes[node] = Box4::from(&knot.bounds);
            loose.areas[node] = loose.boxes[node].area();
            match tree.children(&knot) {
                None => loose.leaves[node] = knot.range(),
                Some(&[left, right]) => {
                    let first = 2 * knot.pair() as u32 + 1;
                    loose.children[node] = first;
                    loose.parents[first as usize] = at;
                    loose.parents[first as usize + 1] = at;
                    waiting.extend([(first, left), (first + 1, right)]);
                }
            }
        }
        loose
    }

    /// Writes the tree back.
    fn back(&self, tree: &mut Tree) {
        let knot = |node: usize| {
            let bounds = self.boxes[node].aabb();
            match self.children[node] {
                LEAF => super::Knot::leaf(bounds, self.leaves[node].0, self.leaves[node].1),
                _ => super::Knot::inner(bounds, 0),
            }
        };
        // In the order in which a tree has them: below a node first what is on the left, then what is on the right.
        let (mut next, mut waiting) = (0, vec![(0, None)]);
        while let Some((node, place)) = waiting.pop() {
            let mut own = knot(node);
            if self.children[node] != LEAF {
                let first = self.children[node] as usize;
                own = super::Knot::inner(own.bounds, next as u32);
                waiting.extend([(first + 1, Some((next, 1))), (first, Some((next, 0)))]);
                next += 1;
            }
            match place {
                None => tree.root = own,
                Some((pair, side)) => tree.pairs[pair][side] = own,
            }
        }
        tree.depth = tree.measured_depth();
    }

    /// Looks at the largest nodes and moves those that are better off elsewhere; how many were moved.
    fn round(&mut self) -> usize {
        let mut largest: Vec<Number> =
            (1..self.boxes.len() as u32).filter(|&node| self.areas[node as usize] > 0.0).collect();
        let many = largest.len() / PART + 1;
        if many < largest.len() {
            let by_area = |a: &u32, b: &u32| self.areas[*b as usize].total_cmp(&self.areas[*a as usize]).then(a.cmp(b));
            largest.select_nth_unstable_by(many, by_area);
            largest.truncate(many);
        }
        let mut moves: Vec<Move> =
            largest.into_par_iter().with_min_len(64).filter_map(|node| self.best_move(node)).collect();
        // The best first; those that meddle with what another has changed wait for the next round.
        moves.par_sort_unstable_by(|a, b| b.gain.total_cmp(&a.gain).then(a.node.cmp(&b.node)));
        let mut touched = vec![false; self.boxes.len()];
        let mut moved = 0;
        for Move { node, to, .. } in moves {
            let parent = self.parents[node as usize];
            let places = [node, to, sibling(node), parent, self.parents[to as usize]].map(|place| place as usize);
            if places.iter().any(|&place| touched[place]) {
                continue;
            }
            for place in places {
                touched[place] = true;
            }
            self.apply(node, to);
            moved += 1;
        }
        moved
    }

    /// Where a node is better off, if anywhere: upwards step by step, and from each step down into the other branch.
    fn best_move(&self, node: Number) -> Option<Move> {
        let parent = self.parents[node as usize];
        if parent == 0 {
            return None;
        }
        let own = &self.boxes[node as usize];
        let area = self.areas[node as usize];
        let mut best = Move { node, to: 0, gain: 0.0 };
        // What is won so far: the parent goes, and everything above it shrinks.
        let mut won = self.areas[parent as usize];
        let mut left_over = self.boxes[sibling(node) as usize];
        let (mut pivot, mut other) = (parent, sibling(node));
        let mut waiting = Vec::with_capacity(64);
        loop {
            waiting.push((won, other));
            while let Some((won, at)) = waiting.pop() {
                if won - area <= best.gain {
                    continue;
                }
                let gain = won - self.boxes[at as usize].union(own).area();
                if gain > best.gain && at != sibling(node) {
                    best = Move { node, to: at, gain };
                }
                let first = self.children[at as usize];
                if first != LEAF {
                    let won = gain + self.areas[at as usize];
                    waiting.extend([(won, first), (won, first + 1)]);
                }
            }
            if pivot == 0 {
                break;
            }
            if pivot != parent {
                left_over = left_over.union(&self.boxes[other as usize]);
                won += self.areas[pivot as usize] - left_over.area();
            }
            other = sibling(pivot);
            pivot = self.parents[pivot as usize];
        }
        // A gain of nothing but roundings is none.
        (best.to != 0 && best.to != parent && best.gain > 1e-6 * area).then_some(best)
    }

    /// Puts a node beside another: its parent's place goes to its sibling, and the pair of both moves below the place of
    /// the other.
    fn apply(&mut self, node: Number, to: Number) {
        let (brother, parent) = (sibling(node), self.parents[node as usize]);
        // The sibling takes the place of the parent, the other one that of the sibling.
        self.put(brother, parent);
        self.put(to, brother);
        self.children[to as usize] = node.min(brother);
        self.parents[node as usize] = to;
        self.parents[brother as usize] = to;
        self.refit(to);
        self.refit(parent);
    }

    /// Writes a node over another place.
    fn put(&mut self, node: Number, place: Number) {
        let (node, at) = (node as usize, place as usize);
        self.boxes[at] = self.boxes[node];
        self.areas[at] = self.areas[node];
        self.leaves[at] = self.leaves[node];
        self.children[at] = self.children[node];
        if self.children[at] != LEAF {
            let first = self.children[at] as usize;
            self.parents[first] = place;
            self.parents[first + 1] = place;
        }
    }

    /// Makes the boxes from a node up fit their children again.
    fn refit(&mut self, from: Number) {
        let mut at = from as usize;
        loop {
            if self.children[at] != LEAF {
                let first = self.children[at] as usize;
                self.boxes[at] = self.boxes[first].union(&self.boxes[first + 1]);
                self.areas[at] = self.boxes[at].area();
            }
            if at == 0 {
                break;
            }
            at = self.parents[at] as usize;
        }
    }
}
