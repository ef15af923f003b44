//! What lies over the page for a while: dialogs, messages, and how far work has come.

mod best;
mod drop_hint;
mod export;
mod help;
mod open;
mod overlay;
mod palette;
mod progress;

pub(super) use overlay::{Asked, Overlay};
