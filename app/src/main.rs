//! The `raystep` binary: the window and the command line.

use std::process::ExitCode;

use clap::Parser;

fn main() -> ExitCode {
    raystep::cli::run(&raystep::cli::Arguments::parse())
}
