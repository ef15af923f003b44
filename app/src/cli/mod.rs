//! The command line: what Raystep does without a window.

mod check;
mod doctor;
mod export;
mod fault;
pub(crate) mod files;
mod lessons;
mod measure;
pub mod page;
mod rays;
mod spelt;
mod start;
mod trace;
mod verify;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

pub use crate::export::{Size, View};
pub use check::CheckArguments;
pub use export::ExportArguments;
pub use fault::Fault;
pub use measure::MeasureArguments;
pub use rays::read as read_rays;
pub use spelt::rule as read_rule;
pub use start::StartArguments;
pub use trace::TraceArguments;
pub(crate) use verify::thousands;
pub use verify::{VerifyArguments, replay};

/// One ray walks through an acceleration structure, one decision at a time.
#[derive(Parser, Debug)]
#[command(name = "raystep", version, about, args_conflicts_with_subcommands = true)]
pub struct Arguments {
    /// What to do instead of opening the window.
    #[command(subcommand)]
    command: Option<Command>,
    #[command(flatten)]
    start: StartArguments,
}

#[derive(Subcommand, Debug)]
enum Command {
    /// Check lessons; silent when all is well.
    Check(CheckArguments),
    /// Draw steps as pictures.
    Export(ExportArguments),
    /// Walk rays and write hits and counters.
    Trace(TraceArguments),
    /// Count what rays cost: the lecture's tables, as printed and as measured here.
    Measure(MeasureArguments),
    /// Shoot rays at every structure and compare with brute force.
    Verify(VerifyArguments),
    /// Say what a window needs and what was found.
    Doctor,
}

/// Does what was asked. Exit code 2 means that there is something to mend; a sentence says what.
pub fn run(arguments: &Arguments) -> ExitCode {
    let done = match &arguments.command {
        None => start::run(&arguments.start),
        Some(Command::Check(arguments)) => check::run(arguments),
        Some(Command::Export(arguments)) => export::run(arguments),
        Some(Command::Trace(arguments)) => trace::run(arguments),
        Some(Command::Measure(arguments)) => measure::run(arguments),
        Some(Command::Verify(arguments)) => verify::run(arguments),
        Some(Command::Doctor) => doctor::run(),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(fault) => {
            eprintln!("raystep: {fault}");
            ExitCode::from(2)
        }
    }
}
