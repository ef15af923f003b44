//! The window: one [`App`] that shows a [`State`](crate::shown::state::State) and turns keys and clicks into
//! [`Command`](crate::shown::command::Command)s. Its rooms, from below: how it looks, what is done beside it,
//! panes, bars, dialogs; each is given what it shows and returns what was asked for.

mod app;
mod bars;
mod device;
mod dialogs;
mod keys;
mod last;
mod look;
mod open;
mod panes;
mod slot;
mod speaker;
mod wishes;
mod work;

pub use app::App;
pub use device::Patience;
pub use last::Last;
pub use look::remembered::Remembered;
pub use open::{EachFrame, NoWindow, Opening};
pub use wishes::Wishes;
