//! What lies over the page for a while: dialogs and messages.

mod best;
mod drop_hint;
mod export;
mod help;
mod open;
mod overlay;
mod palette;

pub(super) use overlay::{Asked, Overlay};
