//! What holds across crates: agreement, laws, slides, layers, pixels.
//!
//! The tests stand in `tests/`; here is what they share.

pub mod rays;
pub mod rules;
pub mod scenes;
