//! The tree over the boxes of instances: two children to a node, the nearer one first.

use raystep_accel::{Aabb, Mesh, Place, PrimId, Ray, slab};

use crate::build::{DEEPEST, Knot, Settings, Tree, tree};
use crate::judge::{Count, Shot};

/// A tree over boxes.
#[derive(Clone, Debug)]
pub(super) struct Upper {
    nodes: Vec<Node>,
    /// The largest coordinate, without its sign.
    reach: f32,
    /// The root, if there is anything.
    root: Option<(Aabb, u32)>,
}

/// A node: the boxes of its two children, and which nodes or instances those are.
#[derive(Clone, Copy, Debug)]
struct Node {
    boxes: [Aabb; 2],
    children: [u32; 2],
}

/// The bit of a child that is an instance.
const LEAF: u32 = 1 << 31;

impl Upper {
    /// A tree over boxes; empty ones are never met.
    pub(super) fn over(boxes: &[Aabb]) -> Upper {
        let met: Vec<u32> = (0..boxes.len() as u32).filter(|id| !boxes[*id as usize].is_empty()).collect();
        // The builder sorts triangles by their boxes. A triangle from corner to corner has the box that we mean.
        let corners = met.iter().flat_map(|id| [boxes[*id as usize].min, boxes[*id as usize].max]);
        let triangles = (0..met.len() as u32).map(|n| [2 * n, 2 * n + 1, 2 * n]);
        let mesh = Mesh { corners: corners.collect(), triangles: triangles.collect() };
        let built = tree(&mesh, &Settings { leaf: 1, reinsertions: 2, splits: 0 });
        let mut upper = Upper { nodes: Vec::new(), reach: built.reach(), root: None };
        if !met.is_empty() {
            let root = upper.add(&built, &built.root, &met);
            upper.root = Some((built.root.bounds, root));
        }
        upper
    }

    /// Adds a node and all below it; what its parent calls it.
    fn add(&mut self, built: &Tree, knot: &Knot, ids: &[u32]) -> u32 {
        let Some(pair) = built.children(knot) else { return LEAF | ids[built.leaf_prims(knot)[0] as usize] };
        let own = self.nodes.len();
        self.nodes.push(Node { boxes: pair.map(|child| child.bounds), children: [0; 2] });
        let children = pair.map(|child| self.add(built, &child, ids));
        self.nodes[own].children = children;
        own as u32
    }

    /// Offers the instances whose boxes the ray meets, the nearer ones first, with the largest t that still counts. `meet`
    /// says which one counts from now on, if that has changed.
    pub(super) fn walk<C: Count>(
        &self,
        ray: &Ray,
        count: &mut C,
        mut meet: impl FnMut(PrimId, f32, &mut C) -> Option<f32>,
    ) {
        let Some((bounds, mut here)) = self.root else { return };
        let shot = Shot::new(ray, self.reach).ok();
        let near = |bounds: &Aabb, t_max: f32| match &shot {
            Some(shot) => entered(bounds, shot, t_max),
            None => {
                let within = slab(bounds, ray, ray.range(), Place::World, &mut ());
                (!within.is_empty() && within.near <= t_max).then_some(within.near)
            }
        };
        let mut t_max = ray.t_max;
        let (mut waiting, mut high) = ([(0, 0.0_f32); DEEPEST as usize + 1], 0);
        count.node(1);
        if near(&bounds, t_max).is_none() {
            return;
        }
        loop {
            if here & LEAF == 0 {
                let node = &self.nodes[here as usize];
                count.node(2);
                let [first, second] = [0, 1].map(|child: usize| near(&node.boxes[child], t_max));
                match (first, second) {
                    (Some(a), Some(b)) => {
                        let nearer = usize::from(b < a);
                        waiting[high] = (node.children[1 - nearer], a.max(b));
                        high += 1;
                        here = node.children[nearer];
                        continue;
                    }
                    (Some(_), None) => {
                        here = node.children[0];
                        continue;
                    }
                    (None, Some(_)) => {
                        here = node.children[1];
                        continue;
                    }
                    (None, None) => {}
                }
            } else {
                t_max = meet(PrimId(here & !LEAF), t_max, count).unwrap_or(t_max);
            }
            loop {
                if high == 0 {
                    return;
                }
                high -= 1;
                if waiting[high].1 <= t_max {
                    here = waiting[high].0;
                    break;
                }
            }
        }
    }

    pub(super) fn bytes(&self) -> usize {
        size_of_val(&*self.nodes)
    }
}

/// Where an ordinary ray enters a box, if it does no further than `t_max`; widened as `judge` has it, so that no box is
/// ruled out in whose own interval a hit lies.
#[inline(always)]
fn entered(bounds: &Aabb, shot: &Shot<'_>, t_max: f32) -> Option<f32> {
    let (min, max) = (bounds.min.to_array(), bounds.max.to_array());
    let (mut near, mut far) = (shot.ray.t_min, t_max);
    for axis in 0..3 {
        let [low, high] = if shot.down[axis] { [max[axis], min[axis]] } else { [min[axis], max[axis]] };
        near = near.max(low * shot.r[axis] + shot.enter[axis]);
        far = far.min(high * shot.r[axis] + shot.leave[axis]);
    }
    (near <= far).then_some(near)
}
