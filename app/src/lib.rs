//! Raystep: one ray walks through an acceleration structure, one decision at a time.

pub mod cli;
pub mod window;
