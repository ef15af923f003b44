//! Raystep: one ray walks through an acceleration structure, one decision at a time.

pub mod cli;
mod counts;
mod export;
mod fault;
mod files;
mod reading;
pub mod shown;
pub mod window;
