//! A node in four cache lines.

use glam::Vec3;
use raystep_accel::Aabb;

/// Up to eight children; a lane for each.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub(crate) struct Node {
    /// The bits of the lower and upper planes across x, y and z; then where the children are, and their orders.
    pub(crate) rows: [[u32; 8]; 8],
}

/// The row in which it stands where the children are: a number of an inner node, or of a leaf with the highest bit set.
pub(crate) const CHILDREN: usize = 6;
/// The row of orders: three bits for each octant of directions. Those of lane i say which child comes i-th.
pub(crate) const ORDERS: usize = 7;
/// The bit that marks a leaf.
pub(crate) const LEAF: u32 = 1 << 31;

impl Node {
    /// No child: boxes that no ray meets.
    pub(crate) const EMPTY: Node = {
        let (low, high) = ([f32::INFINITY.to_bits(); 8], [f32::NEG_INFINITY.to_bits(); 8]);
        Node { rows: [low, high, low, high, low, high, [0; 8], [0; 8]] }
    };

    /// Puts a child in a lane.
    pub(crate) fn set(&mut self, lane: usize, bounds: &Aabb, child: u32) {
        for axis in 0..3 {
            self.rows[2 * axis][lane] = bounds.min[axis].to_bits();
            self.rows[2 * axis + 1][lane] = bounds.max[axis].to_bits();
        }
        self.rows[CHILDREN][lane] = child;
    }

    /// The box of the child in a lane; empty if there is none.
    pub(crate) fn bounds(&self, lane: usize) -> Aabb {
        let [min, max] = [0, 1].map(|side| [0, 2, 4].map(|axis| f32::from_bits(self.rows[axis + side][lane])));
        Aabb { min: Vec3::from(min), max: Vec3::from(max) }
    }

    /// Finds for each octant of directions the order in which such rays meet the children: along its diagonal.
    pub(crate) fn order(&mut self) {
        self.rows[ORDERS] = [0; 8];
        for octant in 0..8u32 {
            let along = Vec3::from([0, 1, 2].map(|axis| if octant >> axis & 1 == 0 { 1.0 } else { -1.0 }));
            let mut lanes: [usize; 8] = std::array::from_fn(|lane| lane);
            let places: [f32; 8] = std::array::from_fn(|lane| {
                let bounds = self.bounds(lane);
                if bounds.is_empty() { f32::INFINITY } else { (bounds.min + bounds.max).dot(along) }
            });
            lanes.sort_by(|&a, &b| places[a].total_cmp(&places[b]));
            for (place, lane) in lanes.into_iter().enumerate() {
                self.rows[ORDERS][place] |= (lane as u32) << (3 * octant);
            }
        }
    }
}
