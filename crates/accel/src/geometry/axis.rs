//! The three axes, and which of them a builder may use.

use std::fmt;
use std::ops::{Index, IndexMut};

use glam::Vec3;

/// A coordinate axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Axis {
    /// x
    X,
    /// y
    Y,
    /// z
    Z,
}

impl Axis {
    /// x, y, z.
    pub const ALL: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

    /// 0, 1 or 2.
    #[inline]
    pub fn index(self) -> usize {
        self as usize
    }

    /// `"x"`, `"y"` or `"z"`.
    pub fn name(self) -> &'static str {
        ["x", "y", "z"][self.index()]
    }
}

impl fmt::Display for Axis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl Index<Axis> for Vec3 {
    type Output = f32;

    #[inline]
    fn index(&self, axis: Axis) -> &f32 {
        match axis {
            Axis::X => &self.x,
            Axis::Y => &self.y,
            Axis::Z => &self.z,
        }
    }
}

impl IndexMut<Axis> for Vec3 {
    #[inline]
    fn index_mut(&mut self, axis: Axis) -> &mut f32 {
        match axis {
            Axis::X => &mut self.x,
            Axis::Y => &mut self.y,
            Axis::Z => &mut self.z,
        }
    }
}

/// The axes along which a builder may split: all three, or x and y in a flat scene.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Axes {
    /// x, y and z.
    #[default]
    Xyz,
    /// x and y: a flat scene lives in a thin z slab.
    Xy,
}

impl Axes {
    /// The axes in order.
    #[inline]
    pub fn list(self) -> &'static [Axis] {
        match self {
            Axes::Xyz => &Axis::ALL,
            Axes::Xy => &Axis::ALL[..2],
        }
    }
}

/// How a builder measures a box: the chance that a ray which meets the parent meets the child is the
/// ratio of their areas (in a flat scene, of their perimeters).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Measure {
    /// Surface area, for solid scenes.
    #[default]
    Area,
    /// Perimeter of the x, y rectangle, for flat scenes.
    Perimeter,
}

impl Measure {
    /// The measure of a box with these sides.
    #[inline]
    pub fn of(self, sides: Vec3) -> f32 {
        match self {
            Measure::Area => 2.0 * (sides.x * sides.y + sides.y * sides.z + sides.z * sides.x),
            Measure::Perimeter => 2.0 * (sides.x + sides.y),
        }
    }
}
