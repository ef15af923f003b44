//! Raystep: one ray walks through an acceleration structure, one decision at a time.

pub mod cli;
mod counts;
mod export;
mod fault;
mod files;
mod reel;
pub mod window;
