//! The cut that is weighed, taken in the hand: where its line stands, and which cut stands where the hand is.

use glam::Vec2;
use raystep_accel::{Axis, HandCut, Primitives};

use super::order::{Order, place_of};
use super::{Candidate, Layout};
use crate::moments::{Build, GrowMoment};
use crate::panes::Ask;

/// The line of a cut on the page.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CutLine {
    /// The cut.
    pub cut: HandCut,
    /// One end.
    pub from: Vec2,
    /// The other end, at its cost.
    pub to: Vec2,
    /// How far apart the places are that it can take, in points.
    pub step: f32,
}

/// The line of the cut that is weighed now; nothing while an open question hides what it costs.
pub(crate) fn cut_line(build: &Build<'_>, moment: &GrowMoment, ask: &Ask<'_>) -> Option<CutLine> {
    let now = moment.event.and_then(Candidate::of).filter(|_| !ask.hide)?;
    let Layout { space, costs, beside, .. } = Layout::of(build, moment, ask.size, &ask.look);
    let (order, axis) = (Order::of(build, now.node, now.axis), now.axis);
    let across = place_of(&space, axis, order.as_ref(), now.plane, now.below);
    let (from, to) = match axis {
        Axis::Y => (Vec2::new(space.min.x, across), Vec2::new(space.max.x + beside, across)),
        _ => (Vec2::new(across, space.min.y), Vec2::new(across, space.max.y + costs)),
    };
    let step = order.map_or(3.0, |order| (space.along(axis, order.share(1)) - space.along(axis, 0.0)).abs());
    Some(CutLine { cut: HandCut { node: now.node, axis, at: now.plane }, from, to, step })
}

/// The cut of the same node across the same axis that stands at a point of the page: between two primitives of a list,
/// else at a coordinate on a grid of about a pixel.
pub(crate) fn cut_to(build: &Build<'_>, moment: &GrowMoment, ask: &Ask<'_>, point: Vec2) -> Option<HandCut> {
    let line = cut_line(build, moment, ask)?;
    let Layout { space, .. } = Layout::of(build, moment, ask.size, &ask.look);
    let axis = line.cut.axis;
    let along = if axis == Axis::Y { point.y } else { point.x };
    let at = match Order::of(build, line.cut.node, axis) {
        Some(order) => {
            let whole = space.along(axis, 1.0) - space.along(axis, 0.0);
            let share = (along - space.along(axis, 0.0)) / whole;
            build.prims.bounds(order.after(share)?).center()[axis]
        }
        None => {
            let bounds = moment.nodes.get(&line.cut.node)?.bounds;
            let (low, high) = (bounds.min[axis], bounds.max[axis]);
            let step = short(((high - low) / 400.0).max(1e-6));
            let value = f64::from(space.value(axis, along).clamp(low, high));
            let at = ((value / step).round() * step) as f32;
            // A plane in a face of the node cuts nothing.
            if at <= low {
                low + step as f32
            } else if at >= high {
                high - step as f32
            } else {
                at
            }
        }
    };
    Some(HandCut { at, ..line.cut })
}

/// The power of ten below a length.
fn short(length: f32) -> f64 {
    let mut step = 1e-6;
    while step * 10.0 <= f64::from(length) {
        step *= 10.0;
    }
    step
}
