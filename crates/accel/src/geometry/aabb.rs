//! The axis-aligned box of slide 12: two corners.

use glam::Vec3;

use super::{Axes, Axis, Measure};

/// All points between `min` and `max`, faces included. Empty when `min > max` on some axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb {
    /// The corner with the smallest coordinates.
    pub min: Vec3,
    /// The corner with the largest coordinates.
    pub max: Vec3,
}

impl Aabb {
    /// No points at all: the start of every union.
    pub const EMPTY: Aabb = Aabb { min: Vec3::INFINITY, max: Vec3::NEG_INFINITY };

    /// The box between two corners.
    pub fn new(min: Vec3, max: Vec3) -> Aabb {
        Aabb { min, max }
    }

    /// The smallest box around some points.
    pub fn around(points: impl IntoIterator<Item = Vec3>) -> Aabb {
        points.into_iter().fold(Aabb::EMPTY, Aabb::with_point)
    }

    /// The smallest box around everything no further than `reach` from `center`, rounded outward: what touches its
    /// faces lies in it.
    pub fn reaching(center: Vec3, reach: Vec3) -> Aabb {
        let (center, reach) = (center.as_dvec3(), reach.as_dvec3());
        let down = |exact: f64| {
            let near = exact as f32;
            if f64::from(near) > exact { near.next_down() } else { near }
        };
        let (min, max) = (center - reach, center + reach);
        Aabb {
            min: Vec3::new(down(min.x), down(min.y), down(min.z)),
            max: -Vec3::new(down(-max.x), down(-max.y), down(-max.z)),
        }
    }

    /// Its corners: bit `i` of a corner's number says whether it lies high along axis `i`.
    pub fn corners(&self) -> [Vec3; 8] {
        std::array::from_fn(|corner| {
            let along = |i: usize| if corner >> i & 1 == 1 { self.max[i] } else { self.min[i] };
            Vec3::new(along(0), along(1), along(2))
        })
    }

    /// Whether it holds no point.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.min.cmpgt(self.max).any()
    }

    /// Widened to hold `p`.
    #[inline]
    pub fn with_point(self, p: Vec3) -> Aabb {
        Aabb { min: self.min.min(p), max: self.max.max(p) }
    }

    /// The smallest box around both.
    #[inline]
    pub fn union(self, other: Aabb) -> Aabb {
        Aabb { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// The common part; may be empty.
    #[inline]
    pub fn intersection(self, other: Aabb) -> Aabb {
        Aabb { min: self.min.max(other.min), max: self.max.min(other.max) }
    }

    /// Widened by `by` on all sides.
    #[inline]
    pub fn padded(self, by: f32) -> Aabb {
        Aabb { min: self.min - by, max: self.max + by }
    }

    /// Its middle, which lies in it: the sum is halved, since halves of the smallest numbers would be rounded apart.
    #[inline]
    pub fn center(&self) -> Vec3 {
        (self.min + self.max) * 0.5
    }

    /// Its sides.
    #[inline]
    pub fn extent(&self) -> Vec3 {
        self.max - self.min
    }

    /// The longest of the allowed axes; the first of equals.
    pub fn longest(&self, axes: Axes) -> Axis {
        let e = self.extent();
        axes.list().iter().copied().fold(Axis::X, |best, axis| if e[axis] > e[best] { axis } else { best })
    }

    /// Cut by the plane `axis = plane` into its lower and its upper part.
    #[inline]
    pub fn cut(self, axis: Axis, plane: f32) -> (Aabb, Aabb) {
        let (mut lower, mut upper) = (self, self);
        lower.max[axis] = plane;
        upper.min[axis] = plane;
        (lower, upper)
    }

    /// Surface area, or the perimeter of its x, y rectangle; 0 when empty.
    #[inline]
    pub fn measure(&self, measure: Measure) -> f32 {
        if self.is_empty() { 0.0 } else { measure.of(self.extent()) }
    }
}
