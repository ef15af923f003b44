//! What is equal for all points of a plane.

use raystep_accel::Direction;

/// The coordinate that the points of a plane across `axis` share: `x`, or how far they lie along the normal, `n · p`.
pub fn coordinate(axis: Direction) -> &'static str {
    match axis {
        Direction::Normal => "n · p",
        axis => axis.name(),
    }
}
