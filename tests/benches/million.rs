//! Every builder over a million triangles: how long it takes, how much memory it holds and takes on the way, how
//! often it tells of progress, and how long it may be deaf to a cancel. What is not ready in time is
//! cancelled and built again over a quarter as many triangles. `-- kd 60` builds only rules that start with
//! `kd`, and gives each a minute.

use std::cell::Cell;
use std::env;
use std::fs;
use std::process::Command;
use std::time::{Duration, Instant};

use raystep_accel::{Grow, Observer, Primitives, Structure};
use raystep_scene::teapot;
use raystep_tests::rules::rule;

/// Steps along a patch: a teapot of 1,015,056 triangles, and smaller ones with about a quarter as many each.
const STEPS: [u32; 5] = [126, 63, 32, 16, 8];

/// How long a builder has, unless the command line says otherwise.
const SECONDS: u64 = 180;

/// Every kind, and every builder of a hierarchy with every volume.
const RULES: &[&str] = &[
    "grid",
    "nested-grid",
    "hashed-grid",
    "kd",
    "kd split=middle",
    "kd split=median",
    "octree",
    "bsp",
    "bsp planes=candidates straddlers=both",
    "bvh",
    "bvh split=middle",
    "bvh split=median",
    "bvh split=sweep",
    "bvh volume=sphere",
    "bvh volume=obb",
    "bvh volume=kdop14",
    "bvh volume=kdop18",
    "bvh volume=kdop26",
    "bvh volume=hull",
    "bvh builder=ploc",
    "bvh builder=insertion",
    "bvh builder=bottom-up",
];

/// Counts what settles, as the window's progress does, and cancels when the time is up.
struct Stopwatch {
    start: Instant,
    limit: Duration,
    settled: u64,
    /// When the builder last asked whether to give up, and the longest that it did not.
    asked: Cell<Instant>,
    deaf: Cell<Duration>,
}

impl Observer<Grow> for Stopwatch {
    fn on(&mut self, event: Grow) {
        self.settled += u64::from(matches!(event, Grow::Settle { .. }));
    }

    fn cancelled(&self) -> bool {
        let now = Instant::now();
        self.deaf.set(self.deaf.get().max(now - self.asked.get()));
        self.asked.set(now);
        now - self.start > self.limit
    }
}

/// The most memory that this process has held so far, in MB; none where the system does not say.
fn peak() -> Option<u64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    Some(line.trim().trim_end_matches("kB").trim().parse::<u64>().ok()? / 1024)
}

/// Builds one structure in this process and prints its row; whether it was ready in time.
fn build(line: &str, steps: u32, limit: Duration) -> bool {
    let mesh = teapot(steps);
    let before = peak();
    let start = Instant::now();
    let (asked, deaf) = (Cell::new(start), Cell::new(Duration::ZERO));
    let mut watch = Stopwatch { start, limit, settled: 0, asked, deaf };
    let Ok(structure) = Structure::build(&mesh, &rule(line), &mut watch) else { return false };
    let took = start.elapsed();
    // From the last question to the end nobody could cancel either.
    let deaf = watch.deaf.get().max(watch.asked.get().elapsed());
    let grown = match (before, peak()) {
        (Some(before), Some(after)) => (after - before).to_string(),
        _ => "-".to_owned(),
    };
    println!(
        "{line:<40} {:>9} {:>8.2} {:>9.1} {grown:>8} {:>9.0} {:>8.1} {:>9}",
        mesh.len(),
        took.as_secs_f64(),
        structure.bytes() as f64 / 1e6,
        watch.settled as f64 / took.as_secs_f64() / 1e3,
        deaf.as_secs_f64() * 1e3,
        structure.node_count(),
    );
    true
}

fn main() {
    let words: Vec<String> = env::args().skip(1).filter(|word| word != "--bench").collect();
    // A process of its own for each build, so that each has its own peak.
    if let [one, line, steps, seconds] = &words[..]
        && one == "one"
    {
        let limit = Duration::from_secs(seconds.parse().expect("seconds"));
        let ready = build(line, steps.parse().expect("steps"), limit);
        std::process::exit(i32::from(!ready));
    }
    let only = words.first().map_or("", String::as_str);
    let seconds = words.get(1).cloned().unwrap_or(SECONDS.to_string());
    println!(
        "{:<40} {:>9} {:>8} {:>9} {:>8} {:>9} {:>8} {:>9}",
        "rule", "triangles", "s", "holds MB", "peak MB", "k told/s", "deaf ms", "nodes"
    );
    let program = env::current_exe().expect("the benchmark's own file");
    for line in RULES.iter().filter(|line| line.starts_with(only)) {
        let ready = STEPS.iter().find(|steps| {
            let words = ["one", *line, &steps.to_string(), &seconds];
            Command::new(&program).args(words).status().expect("the benchmark runs itself").success()
        });
        if ready.is_none() {
            println!("{line:<40} not ready after {seconds} s");
        }
    }
}
