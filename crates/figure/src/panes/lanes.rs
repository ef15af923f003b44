//! Which rays of a packet take part, as a strip of small cells: one a ray.

use glam::Vec2;
use raystep_accel::{Lanes, Place};

use crate::page::{Figure, block};
use crate::theme::Role;

/// A strip without numbers has so many cells in a row; of more there are several rows.
pub(crate) const ROW: usize = 8;

/// How wide and how high a strip of small cells is, each with a side of `cell`.
pub(crate) fn strip_room(lanes: Lanes, cell: f32) -> Vec2 {
    let (across, down) = (lanes.width().min(ROW), lanes.width().div_ceil(ROW));
    Vec2::new(across as f32, down as f32) * cell * 1.2
}

/// A strip of small cells without numbers: filled are those who take part. `corner` is its upper left one.
pub(crate) fn small_strip(figure: &mut Figure, place: Option<Place>, lanes: Lanes, corner: Vec2, cell: f32) {
    for lane in 0..lanes.width() {
        let at = corner + Vec2::new((lane % ROW) as f32, (lane / ROW) as f32) * cell * 1.2;
        let role = if lanes.has(lane) { Role::Lane } else { Role::Edge };
        figure.add(role, place, block(at, Vec2::splat(cell), cell * 0.2));
    }
}
