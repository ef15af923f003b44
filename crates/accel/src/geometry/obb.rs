//! The oriented box, slide 51: a box with axes of its own.

use glam::Vec3;

use super::Aabb;

/// All points `center + u·axes[0] + v·axes[1] + w·axes[2]` with `|u|`, `|v|`, `|w|` at most `half`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Obb {
    /// Its middle.
    pub center: Vec3,
    /// Its own directions: length one, each across the others.
    pub axes: [Vec3; 3],
    /// Half its sides along them, not negative.
    pub half: Vec3,
}

impl Obb {
    /// An axis-aligned box as an oriented one.
    pub fn from_aabb(bounds: &Aabb) -> Obb {
        Obb { center: bounds.center(), axes: Vec3::AXES, half: bounds.extent() * 0.5 }
    }

    /// A small box around it: on each axis it reaches as far as its half sides do together, rounded outward.
    pub fn bounds(&self) -> Aabb {
        let [u, v, w] = self.axes.map(Vec3::abs);
        let reach = (u * self.half.x + v * self.half.y + w * self.half.z) * (1.0 + 4.0 * f32::EPSILON);
        Aabb::reaching(self.center, reach)
    }

    /// Its corners: bit `i` of a corner's number says which way it lies along axis `i`.
    pub fn corners(&self) -> [Vec3; 8] {
        std::array::from_fn(|corner| {
            let along = |i: usize| self.axes[i] * if corner >> i & 1 == 1 { self.half[i] } else { -self.half[i] };
            self.center + along(0) + along(1) + along(2)
        })
    }
}
