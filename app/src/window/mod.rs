//! The window: one [`App`] that shows a [`State`](crate::shown::state::State) and turns keys and clicks into
//! [`Command`](crate::shown::command::Command)s.

mod app;
mod bars;
mod export_dialog;
mod help;
mod keys;
mod look;
mod news;
mod open;
mod open_dialog;
mod palette;
mod panes;
mod toast;
mod underway;
mod work;

pub use app::App;
pub use look::remembered::Remembered;
pub use open::{NoWindow, Wishes, open};
