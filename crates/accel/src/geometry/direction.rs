//! Across which direction a slab or a plane stands: an axis, or one that a volume or a tree has of its own.

use glam::Vec3;

use super::Axis;

/// The direction across which a slab or a plane stands.
///
/// A point `p` lies at the coordinate `n · p` along a direction `n`; so a ray's `o` and `d` in an event are
/// `n · o` and `n · d`, and the cut of any plane is the cut of slide 13: `t = (plane − o)/d`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Direction {
    /// A coordinate axis.
    Along(Axis),
    /// A side of an oriented box: `u`, `v` or `w` for the first, second and third.
    Own(Axis),
    /// A direction between the axes, of a k-DOP: by its place in [`Direction::SLANTED`].
    Slanted(u8),
    /// The normal of a plane that stands free in space.
    Normal,
}

impl Direction {
    /// The names of the directions between the axes: the four corners of a cube, then its six edges.
    pub const SLANTED: [&'static str; 10] =
        ["x+y+z", "x+y-z", "x-y+z", "x-y-z", "x+y", "x-y", "x+z", "x-z", "y+z", "y-z"];

    /// The direction of a plane's normal: an axis if it runs exactly along one.
    #[inline]
    pub fn of(normal: Vec3) -> Direction {
        let along = |axis: &Axis| Axis::ALL.iter().all(|other| other == axis || normal[*other] == 0.0);
        Axis::ALL.into_iter().find(along).map_or(Direction::Normal, Direction::Along)
    }

    /// What it is called.
    pub fn name(self) -> &'static str {
        match self {
            Direction::Along(axis) => axis.name(),
            Direction::Own(axis) => ["u", "v", "w"][axis.index()],
            Direction::Slanted(number) => Self::SLANTED[usize::from(number)],
            Direction::Normal => "n",
        }
    }

    /// Whether it points out of a flat scene, straight or aslant: there slabs across it cut nothing off that those within
    /// the plane have left. Oriented boxes turn in that plane.
    pub fn leaves_plane(self) -> bool {
        match self {
            Direction::Along(axis) | Direction::Own(axis) => axis == Axis::Z,
            Direction::Slanted(number) => {
                Direction::SLANTED_VECTORS.get(usize::from(number)).is_some_and(|vector| vector.z != 0.0)
            }
            Direction::Normal => false,
        }
    }

    /// The coordinate axis it is, if it is one.
    pub fn axis(self) -> Option<Axis> {
        match self {
            Direction::Along(axis) => Some(axis),
            _ => None,
        }
    }
}

impl From<Axis> for Direction {
    #[inline]
    fn from(axis: Axis) -> Direction {
        Direction::Along(axis)
    }
}

impl std::fmt::Display for Direction {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}
