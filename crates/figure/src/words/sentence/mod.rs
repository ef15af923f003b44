//! What events say, in plain words.

mod grow;
mod visit;

use crate::words::counted;

pub(crate) use grow::of_grow;
pub(crate) use visit::of_visit;

/// `4 × 4 × 2`; a grid of one layer is a flat scene's, and has no third number.
fn cells(nx: u32, ny: u32, nz: u32) -> String {
    if nz == 1 { format!("{nx} × {ny}") } else { format!("{nx} × {ny} × {nz}") }
}

/// `1 node`, `2 nodes`.
fn count(n: u32, what: &str) -> String {
    counted(u64::from(n), what, &format!("{what}s"))
}
