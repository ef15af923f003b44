//! What can be shown step by step: each kind in a file that says which panes it draws. A new kind is such a file.

mod board;
mod build;
mod detail;
mod film;
mod fit;
mod instant;
mod kind;
mod packet;
mod pairs;
mod reel;
mod still;
mod walk;
mod walks;

pub use board::Board;
pub use detail::Detail;
pub use film::Film;
pub use fit::Fitting;
pub use instant::Instant;
pub use kind::{Guess, Kind};
pub use pairs::Pairs;
pub use reel::Reel;
pub use still::Still;
pub use walks::Walks;
