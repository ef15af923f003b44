//! What a second thread is worth when a tree is built: wall time, and the busiest thread's own time, which is what the wall
//! would show if nothing else ran on the machine.

use std::time::Instant;

use cpu_time::ThreadTime;
use rayon::ThreadPool;
use raystep_accel::Mesh;
use raystep_fast::{Bvh8, Fast, Settings};

use crate::{median, scenes};

/// Builds the same tree on one thread and on two, in turn, and prints both.
pub fn race(rounds: usize) {
    for name in scenes::NAMES {
        let mesh = scenes::stage(name).mesh;
        let pools = [1, 2].map(|threads| rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads"));
        let mut times = [[Vec::new(), Vec::new()], [Vec::new(), Vec::new()]];
        for round in 0..=rounds {
            for (pool, [wall, own]) in pools.iter().zip(&mut times) {
                let (took, busiest) = build(pool, &mesh);
                // The first round warms up.
                if round > 0 {
                    wall.push(took);
                    own.push(busiest);
                }
            }
        }
        let bytes = Bvh8::build(&mesh, &Settings::QUICK).bytes() as f64 / mesh.triangles.len() as f64;
        println!("{name}: bvh8, {bytes:.0} bytes a triangle, {rounds} rounds");
        let [one, two] = &times;
        for (what, one, two) in [("wall", &one[0], &two[0]), ("busiest thread", &one[1], &two[1])] {
            let ratios: Vec<f64> = one.iter().zip(two).map(|(one, two)| two / one).collect();
            let least = ratios.iter().fold(f64::MAX, |least, own| least.min(*own));
            let most = ratios.iter().fold(0.0f64, |most, own| most.max(*own));
            let (one, two, ratio) = (median(one) * 1e3, median(two) * 1e3, median(&ratios));
            println!("  {what}: {one:.1} ms on one, {two:.1} ms on two: {ratio:.2} ({least:.2}-{most:.2})");
        }
    }
}

/// How long a build takes, and the busiest thread's own time, in seconds.
fn build(pool: &ThreadPool, mesh: &Mesh) -> (f64, f64) {
    let clocks = || pool.broadcast(|_| ThreadTime::now().as_duration());
    let before = clocks();
    let start = Instant::now();
    let tree = pool.install(|| Bvh8::build(mesh, &Settings::QUICK));
    let took = start.elapsed().as_secs_f64();
    let own = clocks().into_iter().zip(before).map(|(after, before)| (after - before).as_secs_f64());
    let busiest = own.fold(0.0, f64::max);
    drop(tree);
    (took, busiest)
}
