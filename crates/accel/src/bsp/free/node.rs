//! A plane across any direction, and a node that holds one: four numbers where a kd-tree needs one.

use glam::{DVec3, Vec3};

use crate::bsp::{Kind, Meeting, Node, Plane, PlaneTest};
use crate::common::bars_projection;
use crate::{Direction, NodeId, Ray, Visit};

/// All points `p` with `normal · p = at`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreePlane {
    /// Its normal, of about length one.
    pub normal: Vec3,
    /// Its place along the normal.
    pub at: f32,
}

impl FreePlane {
    /// How far above the plane a point lies; negative below.
    pub(super) fn height(self, p: DVec3) -> f64 {
        self.normal.as_dvec3().dot(p) - f64::from(self.at)
    }
}

impl Plane for FreePlane {
    const TEST: PlaneTest = PlaneTest { numbers: 4, products: 6, sums: 5, quotients: 1 };

    fn stand(self) -> (Direction, f32) {
        (Direction::Normal, self.at)
    }

    #[inline]
    fn across(self, ray: &Ray) -> Meeting {
        // Along the normal there is one dimension: that of the kd-tree.
        let (o, d) = (self.normal.dot(ray.o), self.normal.dot(ray.d));
        Meeting { axis: Direction::Normal, plane: self.at, o, d }
    }

    #[inline]
    fn bars(ray: &Ray) -> Option<Visit> {
        bars_projection(ray)
    }
}

/// A node in twenty bytes: the normal, and what a kd-tree's node holds in its eight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BspNode {
    normal: Vec3,
    place: u32,
    tag: u32,
}

impl Node for BspNode {
    type Plane = FreePlane;

    /// One bit tells leaves from inner nodes.
    const MOST: u32 = u32::MAX >> 1;

    fn inner(FreePlane { normal, at }: FreePlane, below: NodeId) -> BspNode {
        BspNode { normal, place: at.to_bits(), tag: below.0 << 1 }
    }

    fn leaf(first: u32, count: u32) -> BspNode {
        BspNode { normal: Vec3::ZERO, place: first, tag: count << 1 | 1 }
    }

    #[inline]
    fn kind(self) -> Kind<FreePlane> {
        let number = self.tag >> 1;
        if self.tag & 1 == 1 {
            return Kind::Leaf { first: self.place, count: number };
        }
        let plane = FreePlane { normal: self.normal, at: f32::from_bits(self.place) };
        Kind::Inner { plane, below: NodeId(number), above: NodeId(number + 1) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn packing_loses_nothing() {
        assert_eq!(size_of::<BspNode>(), 20);
        let plane = FreePlane { normal: Vec3::new(0.6, -0.8, -0.0), at: -3e38 };
        let below = NodeId(BspNode::MOST - 1);
        let inner = BspNode::inner(plane, below).kind();
        assert_eq!(inner, Kind::Inner { plane, below, above: NodeId(BspNode::MOST) });
        let leaf = BspNode::leaf(u32::MAX, BspNode::MOST).kind();
        assert_eq!(leaf, Kind::Leaf { first: u32::MAX, count: BspNode::MOST });
    }
}
