//! The rows of a picture, made side by side on all processors, and given up between a few of them.

use rayon::prelude::*;
use raystep_accel::{Cancelled, Grow, Observer};

/// So many rows are made between two questions whether to give up.
const BAND: u32 = 16;

/// What `make` makes of each row, from above.
///
/// # Errors
/// `watch` asked to give up.
pub(super) fn each<T: Send>(
    height: u32,
    watch: &impl Observer<Grow>,
    make: impl Fn(u32) -> T + Sync,
) -> Result<Vec<T>, Cancelled> {
    let mut rows = Vec::with_capacity(height as usize);
    for from in (0..height).step_by(BAND as usize) {
        if watch.cancelled() {
            return Err(Cancelled);
        }
        rows.par_extend((from..height.min(from + BAND)).into_par_iter().map(&make));
    }
    Ok(rows)
}
