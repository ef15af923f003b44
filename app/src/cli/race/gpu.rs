//! The last rung, and what is to be said of it.

use raystep_accel::{Mesh, Ray};
use raystep_fast::{Race, Row};

use crate::clock::graphics_card;
use crate::files;

/// The rung, or a sentence that says why this machine lacks it; nothing if it shall not go on.
pub(super) fn run(race: &Race<'_>, mesh: &Mesh, rays: &[Ray], clock: &dyn Fn() -> f64) -> Option<Row> {
    let (row, says) = graphics_card(race, mesh, rays, clock)?;
    if let Some(says) = says {
        files::say(&says);
    }
    Some(row)
}
