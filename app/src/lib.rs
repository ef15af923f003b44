//! Raystep: one ray walks through an acceleration structure, one decision at a time.

pub mod cli;
mod counts;
mod export;
mod fault;
mod files;
pub mod shown;
pub mod window;
