//! Which primitives of a node lie on which side of a cut.

use raystep_accel::{Aabb, Axis, NodeId, PrimId, Primitives, Structure};

use crate::moments::Build;

/// The two sides of a cut.
pub(crate) struct Sides {
    pub(super) below: Vec<PrimId>,
    pub(super) above: Vec<PrimId>,
    /// A hierarchy puts a box around each side; a tree of planes cuts the node's own box.
    pub(crate) below_box: Aabb,
    pub(crate) above_box: Aabb,
}

impl Sides {
    /// The sides of a cut across `axis`. A tree of planes refers to a primitive on each side that it reaches; a
    /// hierarchy puts the first `count` of its primitives, ordered by their centres, below.
    pub(crate) fn of(build: &Build<'_>, node: NodeId, axis: Axis, plane: f32, count: u32) -> Sides {
        let prims = members(build, node);
        let bounds = |prim: &PrimId| build.prims.bounds(*prim);
        if let Structure::Bvh(_) = build.structure {
            let mut order = prims;
            order.sort_by(|a, b| bounds(a).center()[axis].total_cmp(&bounds(b).center()[axis]).then(a.cmp(b)));
            let above = order.split_off((count as usize).min(order.len()));
            let around = |prims: &[PrimId]| prims.iter().map(bounds).fold(Aabb::EMPTY, Aabb::union);
            let (below_box, above_box) = (around(&order), around(&above));
            return Sides { below: order, above, below_box, above_box };
        }
        let cell = build.structure.node_bounds().get(node.index()).copied().unwrap_or(Aabb::EMPTY);
        let (mut below_box, mut above_box) = (cell, cell);
        (below_box.max[axis], above_box.min[axis]) = (plane, plane);
        let reach = |prim: &&PrimId| build.prims.clip(**prim, &cell);
        let below = prims.iter().filter(|prim| reach(prim).min[axis] < plane || reach(prim).max[axis] <= plane);
        let below = below.copied().collect();
        let above = prims.iter().filter(|prim| reach(prim).max[axis] > plane).copied().collect();
        Sides { below, above, below_box, above_box }
    }

    /// How many lie on both.
    pub(super) fn shared(&self) -> usize {
        self.below.iter().filter(|prim| self.above.contains(prim)).count()
    }
}

/// The primitives below a node: those of its leaves.
pub(super) fn members(build: &Build<'_>, node: NodeId) -> Vec<PrimId> {
    let mut open = vec![node];
    let mut members = Vec::new();
    while let Some(node) = open.pop() {
        members.extend_from_slice(build.structure.leaf_prims(node));
        open.extend(build.structure.children(node));
    }
    members.sort();
    members.dedup();
    members
}

#[cfg(test)]
mod tests {
    use raystep_accel::{Grow, Prims, Random, Rule, Shape, Sphere, Wall};

    use super::*;
    use crate::world::Nodes;

    /// Discs and segments in the plane.
    fn scene(seed: u64) -> Prims {
        let mut random = Random::new(seed);
        let mut at = |reach: f32| glam::Vec2::new(random.unit(), random.unit()) * reach;
        let shapes = (0..14).map(|index| {
            let center = at(9.0);
            if index % 3 == 0 {
                Shape::Wall(Wall { from: center, to: center + at(3.0), z: [-0.5, 0.5] })
            } else {
                Shape::Sphere(Sphere { center: center.extend(0.0), radius: 0.2 + at(0.5).x })
            }
        });
        Prims::Few(shapes.collect())
    }

    #[test]
    fn as_many_lie_on_each_side_as_the_builder_counts() {
        for (line, seed) in [("kd split=sah", 1), ("kd split=sah", 2), ("bvh split=sweep", 3), ("bvh split=binned", 4)]
        {
            let prims = scene(seed);
            let mut words = line.split(' ');
            let mut rule = Rule::default_for(words.next().unwrap()).unwrap();
            for word in words {
                let (key, value) = word.split_once('=').unwrap();
                rule.set(key, value).unwrap();
            }
            let mut events: Vec<Grow> = Vec::new();
            let structure = Structure::build(&prims, &rule.flat(), &mut events).unwrap();
            let nodes = Nodes::of(&structure);
            let lost = std::collections::BTreeMap::new();
            let build = Build {
                structure: &structure,
                nodes: &nodes,
                prims: &prims,
                events: &events,
                lost: &lost,
                instead: None,
                changes: &[],
                flat: true,
            };
            let mut weighed = 0;
            for event in &events {
                let Grow::Weigh { node, axis, plane, below, above, .. } = *event else { continue };
                let sides = Sides::of(&build, node, axis.axis().unwrap(), plane, below);
                assert_eq!(
                    (sides.below.len() as u32, sides.above.len() as u32),
                    (below, above),
                    "{line}, node {node:?} at {axis} = {plane}"
                );
                weighed += 1;
            }
            assert!(weighed > 20, "{line}");
        }
    }
}
