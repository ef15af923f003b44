//! A page and what stands on it: marks, and the few shapes that all panes share.

mod figure;
mod look;
mod motion;
mod table;
mod ticks;

pub use figure::{Anchor, Figure, Image, Ink, Mark};
pub use look::{Look, nothing};
pub(crate) use look::{block, line, wrapped, write};
pub use motion::Motion;
pub(crate) use table::{CLOSE, Entry, Table};
pub(crate) use ticks::Ticks;
