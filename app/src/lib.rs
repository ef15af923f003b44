//! Raystep: one ray walks through an acceleration structure, one decision at a time.

pub mod cli;
mod export;
mod reading;
mod reel;
pub mod window;
