//! Building an octree, slide 43: the bounding box, then eight equal cells, until few enough or deep enough.

use super::{Node, Octree};
use crate::{Aabb, Cancelled, Grow, LeafReason, Margin, NodeId, Observer, OctreeRule, Place, PrimId, Primitives};

impl Octree {
    /// Builds the tree over all primitives.
    ///
    /// # Errors
    /// `watch` asked to give up.
    pub fn build(
        prims: &impl Primitives,
        rule: &OctreeRule,
        watch: &mut impl Observer<Grow>,
    ) -> Result<Octree, Cancelled> {
        // Compute the bounding box.
        let mut bounds = Aabb::EMPTY;
        for prim in (0..prims.len() as u32).map(PrimId) {
            let before = bounds;
            bounds = before.union(prims.bounds(prim));
            watch.on(Grow::Widen { prim, bounds, grown: bounds != before });
        }
        let everything = (0..prims.len() as u32).map(PrimId).collect();
        let mut tree = Octree {
            bounds,
            margin: Margin::of(&bounds),
            rule: *rule,
            nodes: vec![Node::Leaf(everything)],
            refs: prims.len(),
            most_refs: 64 * prims.len() + (1 << 16),
            free: Vec::new(),
        };
        tree.grow(prims, NodeId::ROOT, bounds, 0, watch)?;
        watch.on(Grow::End { nodes: tree.nodes.len() as u32, cells: 0, references: tree.refs as u32 });
        Ok(tree)
    }

    /// Divides a leaf and its children until each holds few enough primitives or is deep enough.
    pub(super) fn grow(
        &mut self,
        prims: &impl Primitives,
        from: NodeId,
        cell: Aabb,
        depth: u32,
        watch: &mut impl Observer<Grow>,
    ) -> Result<(), Cancelled> {
        let mut open = vec![(from, cell, depth)];
        while let Some((node, cell, depth)) = open.pop() {
            if watch.cancelled() {
                return Err(Cancelled);
            }
            let held = self.leaf_prims(node).len() as u32;
            watch.on(Grow::Open { node, bounds: cell, prims: held, depth });

            // Termination criteria: few objects, or deep enough.
            let few = held <= self.rule.min_objects;
            if few || depth >= self.rule.max_depth || self.refs >= self.most_refs {
                let why = match () {
                    () if few => LeafReason::Few,
                    () if depth >= self.rule.max_depth => LeafReason::Deep,
                    () => LeafReason::Crowded,
                };
                watch.on(Grow::Leaf { node, prims: held, why });
                for &prim in self.leaf_prims(node) {
                    watch.on(Grow::Settle { prim, place: Place::Node(node) });
                }
                continue;
            }

            // Eight equal cells; a primitive goes to each that it overlaps.
            let first = self.divide(prims, node, &cell);
            watch.on(Grow::Divide {
                node,
                first,
                ways: self.ways(),
                at_x: cell.center().x,
                at_y: cell.center().y,
                at_z: cell.center().z,
            });
            for number in (0..self.ways()).rev() {
                open.push((NodeId(first.0 + number), self.child_cell(&cell, number), depth + 1));
            }
        }
        Ok(())
    }

    /// Makes a leaf an inner node whose children refer to what it referred to.
    fn divide(&mut self, prims: &impl Primitives, node: NodeId, cell: &Aabb) -> NodeId {
        let first = self.block();
        let Node::Leaf(held) = std::mem::replace(&mut self.nodes[node.index()], Node::Inner(first)) else {
            unreachable!("only leaves are divided")
        };
        self.refs -= held.len();
        for number in 0..self.ways() {
            let child = self.child_cell(cell, number);
            let overlapping: Vec<_> = held.iter().copied().filter(|&prim| self.overlaps(prims, prim, &child)).collect();
            self.refs += overlapping.len();
            self.nodes[(first.0 + number) as usize] = Node::Leaf(overlapping);
        }
        first
    }

    /// Whether a primitive belongs to a cell: rounding needs a margin around it.
    pub(super) fn overlaps(&self, prims: &impl Primitives, prim: PrimId, cell: &Aabb) -> bool {
        prims.overlaps(prim, &cell.padded(self.margin.pad))
    }

    /// Room for one node's children: a block that was given back, or a new one.
    fn block(&mut self) -> NodeId {
        self.free.pop().unwrap_or_else(|| {
            let first = NodeId(self.nodes.len() as u32);
            self.nodes.extend((0..self.ways()).map(|_| Node::Leaf(Vec::new())));
            first
        })
    }
}
