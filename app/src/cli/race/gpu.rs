//! The last rung: the same rays on the graphics card, judged on the CPU where single precision cannot decide.

use raystep_accel::{Mesh, Ray, Want};
use raystep_fast::{Bvh2, Elsewhere, Race, Row, Rung, Settings};
use raystep_paint::compute::{Gpu, Walker};

use crate::files;

/// The rung, or a sentence that says why this machine lacks it; nothing if it shall not go on.
pub(super) fn run(race: &Race<'_>, mesh: &Mesh, rays: &[Ray], clock: &dyn Fn() -> f64) -> Option<Row> {
    let absent = |why: String| Some(Row { rung: Rung::Gpu, told: Err(why) });
    let gpu = match Gpu::new() {
        Ok(gpu) => gpu,
        Err(none) => return absent(none.to_string()),
    };
    let begun = clock();
    let tree = Bvh2::build(mesh, &Settings::default());
    let walker = match Walker::new(&gpu, mesh, &tree) {
        Ok(walker) => walker,
        Err(fault) => return absent(fault.to_string()),
    };
    let build_ms = (clock() - begun) * 1e3;
    let (tests, judged) = match walker.counts(rays, Want::Nearest) {
        Ok((work, judged)) => (work.iter().map(|work| work.triangles as f64).sum::<f64>(), judged),
        Err(fault) => return absent(fault.to_string()),
    };
    let kind = if gpu.is_software { ", which is software on the CPU" } else { "" };
    files::say(&format!(
        "gpu: {}{kind}; {} of {} rays were walked on the CPU, since single precision could not decide",
        gpu.adapter, judged.on_cpu, judged.rays
    ));
    let ask = |rays: &[Ray]| walker.nearest(rays).map(|(answers, _)| answers).map_err(|fault| fault.to_string());
    let tests_per_ray = tests / rays.len().max(1) as f64;
    let elsewhere = Elsewhere { ask: &ask, tests_per_ray, build_ms, bytes: walker.bytes() };
    race.run_elsewhere(Rung::Gpu, &elsewhere)
}
