//! The window: one [`App`] that shows a [`State`](crate::shown::state::State) and turns keys and clicks into
//! [`Command`](crate::shown::command::Command)s.

mod app;
mod bars;
mod dialogs;
mod keys;
mod look;
mod news;
mod open;
mod panes;
mod work;

pub use app::App;
pub use look::remembered::Remembered;
pub use open::{NoWindow, Wishes, open};
