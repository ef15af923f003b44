//! Raystep: one ray walks through an acceleration structure, one decision at a time.

// A closed standard output or error must not end the program: `files::print`, `say` and `tell` take care.
#![warn(clippy::print_stderr, clippy::print_stdout)]

pub mod cli;
mod clock;
mod export;
mod fault;
mod fields;
mod files;
mod folders;
mod rating;
mod reading;
mod report;
pub mod shown;
mod texts;
pub mod window;
