//! A split that was weighed.

use raystep_accel::{Direction, FreePlane};

/// A split that was weighed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weighed {
    /// Across this axis.
    pub axis: Direction,
    /// At this coordinate.
    pub plane: f32,
    /// References below it.
    pub below: u32,
    /// References above it.
    pub above: u32,
    /// What it would cost.
    pub cost: f32,
    /// In a BSP tree, how the plane stands.
    pub free: Option<FreePlane>,
}

impl Weighed {
    /// The cheapest of some; the first of equals.
    pub fn cheapest(weighed: &[Weighed]) -> Option<Weighed> {
        weighed.iter().copied().reduce(|best, next| if next.cost < best.cost { next } else { best })
    }
}
