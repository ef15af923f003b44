//! A node in four cache lines.

use bytemuck::{Pod, Zeroable};
use glam::Vec3;
use raystep_accel::Aabb;

/// Up to eight children; a lane for each, those that are nodes before those that are leaves.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C, align(64))]
pub(crate) struct Node {
    /// The lower and upper planes across x, y and z. Two more rows, of which the walk knows nothing, hold the rest, so that
    /// a row can be looked up without a branch.
    pub(crate) planes: [[f32; 8]; 6],
    /// For each octant of directions that run up along x, and for each child, a bit for every child that such a ray meets
    /// before it. For the opposite octant all is the other way round.
    before: [[u8; 8]; 4],
    /// What to add to the lane of a child to get its number, for nodes and for leaves.
    first: [u32; 2],
    /// How many of the children are nodes.
    nodes: u32,
    spare: [u32; 5],
}

/// The bit that marks the number of a leaf.
pub(crate) const LEAF: u32 = 1 << 31;

impl Node {
    /// No child: boxes that no ray meets.
    pub(crate) const EMPTY: Node = {
        let (low, high) = ([f32::INFINITY; 8], [f32::NEG_INFINITY; 8]);
        Node { planes: [low, high, low, high, low, high], before: [[0; 8]; 4], first: [0; 2], nodes: 0, spare: [0; 5] }
    };

    /// A node with these children, of which so many are nodes, numbered from `first_node` on, and the others are leaves.
    pub(crate) fn new(children: &[&Aabb], nodes: usize, first_node: usize, first_leaf: usize) -> Node {
        let mut node = Node::EMPTY;
        for (lane, bounds) in children.iter().enumerate() {
            for axis in 0..3 {
                node.planes[2 * axis][lane] = bounds.min[axis];
                node.planes[2 * axis + 1][lane] = bounds.max[axis];
            }
        }
        let leaves = (first_leaf as u32 | LEAF).wrapping_sub(nodes as u32);
        node.first = [first_node as u32, leaves];
        node.nodes = nodes as u32;
        for (octant, before) in node.before.iter_mut().enumerate() {
            // Along the diagonal of the octant.
            let along = Vec3::from([1.0, sign(octant, 1), sign(octant, 2)]);
            let places: [f32; 8] = std::array::from_fn(|lane| {
                children.get(lane).map_or(f32::INFINITY, |own| (own.min + own.max).dot(along))
            });
            for (lane, before) in before.iter_mut().enumerate() {
                let is_before = |other: usize| (places[other], other) < (places[lane], lane);
                *before = (0..8).fold(0, |bits, other| bits | u8::from(is_before(other)) << other);
            }
        }
        node
    }

    /// The number of the child in a lane.
    #[inline(always)]
    pub(crate) fn child(&self, lane: u32) -> u32 {
        let [node, leaf] = self.first;
        lane.wrapping_add(if lane < self.nodes { node } else { leaf })
    }

    /// Which children a ray of an octant meets before the one in a lane. `octant` and `turned` come from [`octant`].
    #[inline(always)]
    pub(crate) fn before(&self, octant: usize, turned: u8, lane: u32) -> u32 {
        u32::from(self.before[octant & 3][lane as usize & 7] ^ turned)
    }

    /// How many children are nodes or leaves.
    pub(crate) fn count(&self) -> usize {
        self.planes[0].iter().filter(|low| **low != f32::INFINITY).count()
    }

    /// The box of the child in a lane; empty if there is none.
    pub(crate) fn bounds(&self, lane: usize) -> Aabb {
        let [min, max] = [0, 1].map(|side| [0, 2, 4].map(|axis| self.planes[axis + side][lane]));
        Aabb { min: Vec3::from(min), max: Vec3::from(max) }
    }
}

fn sign(octant: usize, axis: usize) -> f32 {
    if octant >> (axis - 1) & 1 == 0 { 1.0 } else { -1.0 }
}

/// The octant of rays that run down some axes, or the opposite one and what turns its order round.
#[inline(always)]
pub(crate) fn octant(down: [bool; 3]) -> (usize, u8) {
    let [x, y, z] = down;
    let octant = usize::from(y ^ x) | usize::from(z ^ x) << 1;
    (octant, if x { 0xff } else { 0 })
}
