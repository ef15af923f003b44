//! Pairs of rounds that take turns, so that a slow moment of the machine falls on both alike.

use std::time::Instant;

use crate::{Stage, Walk};

/// Prints, for each structure, what `()`, `Cost` and a trace cost against the stripped walk.
pub(crate) fn table(stage: &Stage, rounds: usize) {
    println!("time against the stripped walk, median of {rounds} paired rounds (10th to 90th percentile)");
    for ((structure, stripped, silent), (_, counting, tracing)) in stage.pairs().into_iter().zip(stage.watched()) {
        print!("{structure:>5}");
        for (name, walk) in [("()", &silent), ("Cost", &counting), ("trace", &tracing)] {
            let [low, median, high] = ratios(&stripped, walk, rounds);
            print!("   {name} {median:.3} ({low:.3} to {high:.3})");
        }
        println!();
    }
}

/// Time of `walk` by time of `stripped`: 10th, 50th and 90th percentile.
fn ratios(stripped: &Walk<'_>, walk: &Walk<'_>, rounds: usize) -> [f64; 3] {
    let mut ratios: Vec<f64> = (0..rounds)
        .map(|round| {
            // Who begins changes from round to round.
            let (base, time) = if round % 2 == 0 {
                let base = seconds(stripped);
                (base, seconds(walk))
            } else {
                let time = seconds(walk);
                (seconds(stripped), time)
            };
            time / base
        })
        .collect();
    ratios.sort_by(f64::total_cmp);
    [0.1, 0.5, 0.9].map(|part| ratios[((rounds - 1) as f64 * part).round() as usize])
}

fn seconds(walk: &Walk<'_>) -> f64 {
    let start = Instant::now();
    std::hint::black_box(walk());
    start.elapsed().as_secs_f64()
}
