//! Runs a target over its seeds, changed at random, and watches the clock and the memory.

use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, Once, PoisonError};
use std::time::{Duration, Instant};

use raystep_accel::Random;

use super::{Target, mutate};

/// What became of all runs.
#[derive(Clone, Debug)]
pub struct Report {
    /// How many there were.
    pub runs: u64,
    /// How long they took together.
    pub time: Duration,
    /// How long the slowest took.
    pub slowest: Duration,
    /// Its input.
    pub slowest_input: Vec<u8>,
    /// The most memory that the program has held so far, in MiB; 0 where nobody tells.
    pub peak_mib: u64,
}

/// No run takes longer.
const LONGEST: Duration = Duration::from_secs(5);

/// The seeds of a target: its files in `fuzz/seeds`, and files of the project.
///
/// # Panics
/// If a folder cannot be read.
pub fn seeds(target: &Target) -> Vec<Vec<u8>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut paths = files(&root.join("fuzz/seeds").join(target.name), "");
    for (folder, ending) in target.seeds {
        paths.extend(files(&root.join(folder), ending));
    }
    paths.sort();
    let read = |path: &PathBuf| std::fs::read(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    paths.iter().map(read).collect()
}

/// The files with this ending in a folder and those in it.
fn files(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut found = Vec::new();
    for path in entries.filter_map(|entry| Some(entry.ok()?.path())) {
        if path.is_dir() {
            found.extend(files(&path, ending));
        } else if ending.is_empty() || path.extension().is_some_and(|own| own == ending) {
            found.push(path);
        }
    }
    found
}

/// Runs a target: each seed as it is, then `runs` inputs made of them. What fails is shortened and kept in `keep`.
///
/// # Panics
/// If a run fails or takes longer than five seconds.
pub fn run(target: &Target, runs: u64, seed: u64, keep: &Path) -> Report {
    let seeds = seeds(target);
    assert!(!seeds.is_empty(), "{} has no seeds", target.name);
    let watch = Watch::over(target.name, keep);
    let mut random = Random::new(seed);
    let mut report =
        Report { runs: 0, time: Duration::ZERO, slowest: Duration::ZERO, slowest_input: Vec::new(), peak_mib: 0 };
    let start = Instant::now();
    let made = (0..runs).map(|_| mutate::changed(&seeds, target, &mut random));
    for input in seeds.iter().cloned().chain(made) {
        let time = one(target, &input, &watch, keep);
        report.runs += 1;
        if time > report.slowest {
            (report.slowest, report.slowest_input) = (time, input);
        }
    }
    report.time = start.elapsed();
    report.peak_mib = peak_mib();
    report
}

/// One run.
fn one(target: &Target, input: &[u8], watch: &Watch, keep: &Path) -> Duration {
    watch.begins(input);
    let start = Instant::now();
    let done = catch_unwind(AssertUnwindSafe(|| (target.body)(input)));
    let time = start.elapsed();
    watch.ends();
    if done.is_err() {
        let fails = |input: &[u8]| quietly(|| catch_unwind(AssertUnwindSafe(|| (target.body)(input))).is_err());
        let file = write(keep, target.name, &mutate::shortened(input, &fails));
        panic!("{} fails; the input is kept in {}", target.name, file.display());
    }
    // The machine may have been busy with something else: what hangs does so again.
    let again = || {
        let start = Instant::now();
        (target.body)(input);
        start.elapsed()
    };
    let time = if time > LONGEST { time.min(again()) } else { time };
    if time > LONGEST {
        let file = write(keep, target.name, input);
        panic!("{} takes {time:?}; the input is kept in {}", target.name, file.display());
    }
    time
}

/// Does what panics very often without a word of it.
fn quietly(what: impl FnOnce() -> bool) -> bool {
    thread_local!(static QUIET: Cell<bool> = const { Cell::new(false) });
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        let usual = take_hook();
        set_hook(Box::new(move |panic| {
            if !QUIET.get() {
                usual(panic);
            }
        }));
    });
    QUIET.set(true);
    let done = what();
    QUIET.set(false);
    done
}

fn write(folder: &Path, name: &str, input: &[u8]) -> PathBuf {
    let sum = input
        .iter()
        .fold(0xcbf2_9ce4_8422_2325_u64, |sum, byte| (sum ^ u64::from(*byte)).wrapping_mul(0x100_0000_01b3));
    let file = folder.join(format!("{name}-{sum:016x}"));
    std::fs::write(&file, input).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    file
}

/// The most memory that the program has held.
fn peak_mib() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:")).unwrap_or_default();
    line.split_whitespace().next().and_then(|kib| kib.parse::<u64>().ok()).unwrap_or(0) / 1024
}

/// The input that is tried now, and since when.
type Current = Arc<Mutex<Option<(Instant, Vec<u8>)>>>;

/// Writes down the input of a run that never ends, and ends the program.
struct Watch(Current);

impl Watch {
    fn over(name: &'static str, keep: &Path) -> Watch {
        let current = Current::default();
        let (seen, keep) = (Arc::downgrade(&current), keep.to_path_buf());
        std::thread::spawn(move || {
            while let Some(current) = seen.upgrade() {
                let held = current.lock().unwrap_or_else(PoisonError::into_inner).clone();
                if let Some((_, input)) = held.filter(|(began, _)| began.elapsed() > LONGEST * 12) {
                    eprintln!("{name} does not end; the input is kept in {}", write(&keep, name, &input).display());
                    std::process::exit(1);
                }
                drop(current);
                std::thread::sleep(Duration::from_secs(1));
            }
        });
        Watch(current)
    }

    fn begins(&self, input: &[u8]) {
        *self.0.lock().unwrap_or_else(PoisonError::into_inner) = Some((Instant::now(), input.to_vec()));
    }

    fn ends(&self) {
        *self.0.lock().unwrap_or_else(PoisonError::into_inner) = None;
    }
}
