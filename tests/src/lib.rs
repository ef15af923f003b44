//! What holds across crates: agreement, laws, slides, layers, pixels.
//!
//! The tests stand in `tests/`; what they share with `raystep verify` stands in [`raystep_scene::trial`].

pub mod fuzz;

pub use raystep_scene::trial::{rays, rules, scenes};
