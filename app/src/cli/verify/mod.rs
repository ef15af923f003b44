//! `raystep verify`: every structure against brute force, and brute force against double precision.

mod campaign;
mod cause;
mod contender;
mod kept;
mod referee;
mod tally;
mod watertight;

use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use clap::Args;
use raystep_accel::{Grow, Observer, Rule};
use raystep_fast::FastKind;
use raystep_figure::whole;

use super::progress::bar;
use super::spelt;
use crate::fault::Fault;
use crate::files;
use campaign::Campaign;
use contender::Contender;
pub use kept::replay;
use tally::Tally;

/// What to verify.
#[derive(Args, Debug)]
pub struct VerifyArguments {
    /// How many rays to shoot.
    #[arg(long, value_name = "N", default_value_t = 1_000_000, allow_negative_numbers = true,
          value_parser = spelt::whole(1_u64..))]
    rays: u64,
    /// The kind of structure: grid, kd, bvh, fast-bvh8 ..., all whose names begin alike: fast-*, or all.
    #[arg(long, value_name = "KIND", default_value = "all")]
    structure: String,
    /// Another seed: other scenes and other rays.
    #[arg(long, value_name = "S", default_value_t = 0, allow_negative_numbers = true,
          value_parser = spelt::whole(0_u64..))]
    seed: u64,
    /// Ask each ray of one structure of each kind only, of another one for the next ray: more rays in the same time.
    #[arg(long)]
    in_turn: bool,
    /// Shoot from inside a closed sphere instead: no ray may leave it.
    #[arg(long)]
    watertight: bool,
    /// Shoot the rays of a file that was kept, or of all files in a folder, once more.
    #[arg(long, value_name = "PATH", conflicts_with_all = ["watertight", "rays", "seed", "in_turn"])]
    replay: Option<PathBuf>,
    /// The folder in which rays are kept that showed a difference.
    #[arg(long, value_name = "DIR", default_value = "tests/regress")]
    keep: PathBuf,
}

/// Whether Ctrl+C was pressed: what runs ends soon, and what is known by then is printed.
static STOPPED: AtomicBool = AtomicBool::new(false);

/// Called when Ctrl+C is pressed. Whoever presses it again does not want to wait.
fn stop() {
    const INTERRUPTED: i32 = 130;
    if STOPPED.swap(true, Ordering::Relaxed) {
        std::process::exit(INTERRUPTED);
    }
}

/// Watches builders, which break off when Ctrl+C is pressed.
struct UntilStopped;

impl Observer<Grow> for UntilStopped {
    fn on(&mut self, _: Grow) {}

    fn cancelled(&self) -> bool {
        stopped()
    }
}

/// Shoots the rays.
pub(crate) fn run(arguments: &VerifyArguments) -> Result<(), Fault> {
    if let Some(path) = &arguments.replay {
        let rays = replay(path)?;
        return files::print(&format!("{}: 0 differences.\n", counted(rays, "kept ray")));
    }
    let kinds = kinds(&arguments.structure)?;
    // Where no handler can be set, Ctrl+C ends the program at once, as usual.
    let _ = ctrlc::set_handler(stop);
    if arguments.watertight {
        return watertight::run(arguments.rays, arguments.seed, &kinds);
    }
    let rules: Vec<_> = Contender::all().filter(|(_, contender)| kinds.contains(&contender.kind())).collect();
    let &VerifyArguments { seed, rays, in_turn, ref keep, .. } = arguments;
    let campaign = Campaign { rules, seed, rays, in_turn, keep };
    let threads = rayon::current_num_threads();
    files::print(&format!(
        "{} {}against brute force over {}, seed {seed}, {}\n",
        counted(campaign.rules.len() as u64, "structure"),
        if in_turn { "in turn " } else { "" },
        counted(rays, "ray"),
        counted(threads as u64, "thread"),
    ))?;
    let begun = Instant::now();
    let bar = bar(rays, "rays");
    let tally = campaign.run(&bar);
    bar.finish_and_clear();
    files::print(&report(&tally, &kinds, &campaign, begun.elapsed().as_secs_f64()))?;
    match tally.differences() {
        0 if stopped() => Err(unfinished(tally.rays, rays)),
        0 => Ok(()),
        n => Err(Fault::new(format!(
            "{}: a structure does not answer as brute force does; the rays are kept in {}",
            counted(n, "difference"),
            keep.display()
        ))),
    }
}

/// What was asked for was not done, though nothing wrong was found.
fn unfinished(shot: u64, asked: u64) -> Fault {
    Fault::new(format!(
        "stopped after {} of {}: no difference so far, and the others were not tried",
        whole(shot),
        counted(asked, "ray")
    ))
}

/// The kinds that are meant; brute force is the judge of all of them.
fn kinds(structure: &str) -> Result<Vec<&'static str>, Fault> {
    let textbook = Rule::KINDS.into_iter().filter(|kind| *kind != "list");
    let judged = || textbook.clone().chain(FastKind::ALL.map(FastKind::name));
    match structure {
        "all" | "*" => Ok(judged().collect()),
        alike if judged().any(|kind| alike.strip_suffix('*').is_some_and(|begin| kind.starts_with(begin))) => {
            let begin = alike.trim_end_matches('*');
            Ok(judged().filter(|kind| kind.starts_with(begin)).collect())
        }
        "list" => Err(Fault::new(format!(
            "--structure list: brute force is the judge; there are all, {}",
            judged().collect::<Vec<_>>().join(", ")
        ))),
        kind => {
            if let Some(fast) = FastKind::ALL.into_iter().find(|fast| fast.name() == kind) {
                return Ok(vec![fast.name()]);
            }
            let rule = spelt::answering(kind)?;
            Ok(judged().filter(|judged| *judged == rule.kind()).collect())
        }
    }
}

/// What was found, as a page of text.
fn report(tally: &Tally, kinds: &[&str], campaign: &Campaign<'_>, seconds: f64) -> String {
    let mut page = String::new();
    if stopped() {
        page += &format!("Stopped after {} of {}.\n", whole(tally.rays), counted(campaign.rays, "ray"));
    }
    page += &format!(
        "{} over {}; {} of the rays hit something.\n\n",
        counted(tally.rays, "ray"),
        counted(tally.scenes, "scene"),
        percent(tally.hits, tally.rays)
    );
    page += &format!("{:<14}{:>6}{:>18}{:>14}\n", "structure", "rules", "answers", "differences");
    for kind in kinds {
        let of_kind = |(_, rule): &&(&str, Contender)| rule.kind() == *kind;
        let (answers, differences) = tally.kinds.get(kind).copied().unwrap_or_default();
        let rules = campaign.rules.iter().filter(of_kind).count();
        page += &format!("{kind:<14}{rules:>6}{:>18}{:>14}\n", whole(answers), whole(differences));
    }
    page += "\nAn answer is the nearest hit (t to the bit, and the primitive) or whether there is any.\n";
    page += &tally.referee.to_string();
    let rate = tally.rays as f64 / seconds.max(1e-9);
    page += &format!("{seconds:.1} s, {} a second.\n", counted(rate as u64, "ray"));
    page
}

fn stopped() -> bool {
    STOPPED.load(Ordering::Relaxed)
}

/// `1 ray`, `12,000 rays`.
pub(crate) fn counted(n: u64, what: &str) -> String {
    format!("{} {what}{}", whole(n), if n == 1 { "" } else { "s" })
}

/// A share in parts of a hundred.
fn percent(part: u64, whole: u64) -> String {
    let share = part as f64 / whole.max(1) as f64 * 100.0;
    if share != 0.0 && share < 0.1 { format!("{share:.1e} %") } else { format!("{share:.1} %") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_begin_alike_are_one_choice() {
        let fast: Vec<_> = FastKind::ALL.map(FastKind::name).to_vec();
        assert_eq!(kinds("fast-*").ok(), Some(fast));
        assert_eq!(kinds("kd").ok(), Some(vec!["kd"]));
        assert_eq!(kinds("*").ok(), kinds("all").ok());
        assert!(kinds("slow-*").is_err());
    }

    #[test]
    fn every_kind_has_rules_to_try() {
        for kind in kinds("all").unwrap() {
            assert!(Contender::all().any(|(_, rule)| rule.kind() == kind), "no rule of {kind} in the list of trials");
        }
    }
}
