//! What can be shown step by step: each kind in a file that says which panes it draws. A new kind is such a file.

mod build;
mod film;
mod instant;
mod kind;
mod reel;
mod still;
mod walk;

use raystep_accel::Structure;

use crate::panes::Pane;

pub use film::Film;
pub use instant::Instant;
pub use kind::{Guess, Kind};
pub use reel::Reel;
pub use still::Still;
use still::has;

/// The pane in which a structure is best seen beside space; nothing if it has no parts.
fn best_of(structure: &Structure) -> Option<Pane> {
    match structure {
        Structure::Slab(_) => Some(Pane::Slabs),
        Structure::List(_) => None,
        structure if structure.grid().is_some() => Some(Pane::Cells),
        _ => Some(Pane::Tree),
    }
}
