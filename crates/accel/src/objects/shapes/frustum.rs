//! The frustum: what a camera sees.

use glam::{Vec2, Vec3};

use super::Plane;
use crate::objects::Part;

/// A pyramid without its tip, between six planes whose normals point inwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frustum {
    /// Left, right, bottom, top, near, far.
    pub planes: [Plane; 6],
    /// The corners: those of the near plane, then those of the far one, each around.
    pub corners: [Vec3; 8],
}

impl Frustum {
    /// What the planes are called.
    pub(crate) const SIDES: [Part; 6] = [Part::Left, Part::Right, Part::Bottom, Part::Top, Part::Near, Part::Far];

    /// What is seen from `eye` along `forward`, from `depth[0]` to `depth[1]` lengths of it. At one length
    /// the view is `2·slope` wide and high; `forward` and `up` are not parallel.
    pub fn new(eye: Vec3, forward: Vec3, up: Vec3, slope: Vec2, depth: [f32; 2]) -> Frustum {
        let right = forward.cross(up).normalize_or_zero() * forward.length();
        let up = right.cross(forward).normalize_or_zero() * forward.length();
        let (aside, over) = (right * slope.x, up * slope.y);
        let [near, far] = depth.map(|depth| eye + forward * depth);
        let planes = [
            Plane { point: eye, normal: (forward - aside).cross(up) },
            Plane { point: eye, normal: up.cross(forward + aside) },
            Plane { point: eye, normal: right.cross(forward - over) },
            Plane { point: eye, normal: (forward + over).cross(right) },
            Plane { point: near, normal: forward },
            Plane { point: far, normal: -forward },
        ]
        .map(|plane| Plane { normal: plane.normal.normalize_or_zero(), ..plane });
        let around = [-aside - over, aside - over, aside + over, over - aside];
        let corner = |i: usize| eye + (forward + around[i % 4]) * depth[i / 4];
        Frustum { planes, corners: std::array::from_fn(corner) }
    }
}
