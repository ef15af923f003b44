//! A split that was weighed.

use raystep_accel::{Direction, FreePlane, Grow};

use super::{Build, GrowMoment};

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

impl Build<'_> {
    /// What the builder has weighed at its node, and what somebody tries instead of the last of it.
    pub(crate) fn weighed(&self, moment: &GrowMoment) -> (Vec<Weighed>, Option<Weighed>) {
        let mut weighed = moment.weighed.clone();
        let own = match self.instead {
            Some(Grow::Weigh { axis, plane, below, above, cost, .. }) if axis.axis().is_some() => {
                Weighed { axis, plane, below, above, cost, free: None }
            }
            _ => return (weighed, None),
        };
        let tried = weighed.pop();
        weighed.extend(tried.and(Some(own)));
        (weighed, tried)
    }
}
