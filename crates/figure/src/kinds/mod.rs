//! What can be shown step by step: walks and builds, each with the panes that it can draw.

mod film;
mod reel;
mod still;

pub use film::Film;
pub use reel::{Instant, Reel};
pub use still::Still;
