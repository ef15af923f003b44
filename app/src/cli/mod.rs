//! The command line: what Raystep does without a window.

mod check;
mod doctor;
mod export;
mod forest;
mod handout;
mod heatmap;
mod lessons;
mod measure;
pub mod page;
mod progress;
mod race;
mod rays;
mod spelt;
mod start;
mod subject;
mod told;
mod trace;
mod verify;
mod walked;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

pub use crate::export::{Size, View};
pub use crate::fault::Fault;
use crate::{files, report};
pub use check::CheckArguments;
pub use export::ExportArguments;
pub use forest::ForestArguments;
pub use handout::HandoutArguments;
pub use heatmap::HeatmapArguments;
pub use measure::MeasureArguments;
pub use race::RaceArguments;
pub use rays::read as read_rays;
pub use spelt::rule as read_rule;
pub use start::StartArguments;
pub use trace::TraceArguments;
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
    /// The lecture on pages to be printed, with questions, and the answers at the end.
    Handout(HandoutArguments),
    /// Walk rays and write hits and counters.
    Trace(TraceArguments),
    /// Count what each ray of a picture costs and write that as a picture or a table.
    Heatmap(HeatmapArguments),
    /// Count what rays cost: the lecture's tables, as printed and as measured here.
    Measure(MeasureArguments),
    /// Race brute force, the textbook and what the last chapter adds over the same rays.
    Race(RaceArguments),
    /// Draw fifty billion triangles and tell what that takes.
    Forest(ForestArguments),
    /// Shoot rays at every structure and compare with brute force.
    Verify(VerifyArguments),
    /// Say what a window needs and what was found.
    Doctor,
}

/// Does what was asked. Exit code 2 means that there is something to mend; a sentence says what.
pub fn run(arguments: &Arguments) -> ExitCode {
    report::prepare();
    large_files_are_errors();
    // What verifies rays ends by itself, and tells what is known by then.
    if !matches!(arguments.command, Some(Command::Verify(_))) {
        end_cleanly();
    }
    let done = match &arguments.command {
        None => start::run(&arguments.start),
        Some(Command::Check(arguments)) => check::run(arguments),
        Some(Command::Export(arguments)) => export::run(arguments),
        Some(Command::Handout(arguments)) => handout::run(arguments),
        Some(Command::Trace(arguments)) => trace::run(arguments),
        Some(Command::Heatmap(arguments)) => heatmap::run(arguments),
        Some(Command::Measure(arguments)) => measure::run(arguments),
        Some(Command::Race(arguments)) => race::run(arguments),
        Some(Command::Forest(arguments)) => forest::run(arguments),
        Some(Command::Verify(arguments)) => verify::run(arguments),
        Some(Command::Doctor) => doctor::run(),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(fault) => {
            files::say(&fault.to_string());
            ExitCode::from(2)
        }
    }
}

/// A file that may not grow as large as it would (`ulimit -f`) is an error where it is written, and not the end of
/// the program, which would leave it half-written.
fn large_files_are_errors() {
    #[cfg(unix)]
    let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, std::sync::Arc::default());
}

/// The exit code of what Ctrl+C has ended: not done, and nothing to mend.
const STOPPED: i32 = 130;

/// From now on Ctrl+C leaves nothing half-written. Where no handler can be set it ends the program as it always does.
fn end_cleanly() {
    let _ = ctrlc::set_handler(|| files::stop(STOPPED));
}
