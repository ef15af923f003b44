//! What lies over the page for a while: dialogs, messages, and how far work has come.

pub(super) mod export;
pub(super) mod help;
pub(super) mod open;
pub(super) mod palette;
pub(super) mod toasts;
pub(super) mod underway;
