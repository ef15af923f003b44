//! The window: one [`App`] that shows a [`State`](crate::shown::state::State) and turns keys and clicks into
//! [`Command`](crate::shown::command::Command)s.

mod app;
mod bench;
mod beside;
mod bottom;
mod columns;
mod controls;
mod errand;
mod export_dialog;
mod exporting;
mod fonts;
mod formulas;
mod help;
mod icons;
mod keys;
mod lesson_pane;
mod markdown;
mod news;
mod open;
mod open_dialog;
mod outline;
mod painter;
mod palette;
mod present;
mod prose;
mod question;
mod remember;
mod rival;
mod solid;
mod space_pane;
mod stage_pane;
mod task;
mod tex;
mod toast;
mod top;
mod underway;
mod visuals;
mod workshop;

pub use app::App;
pub use open::{NoWindow, Wishes, open};
pub use remember::Remembered;
