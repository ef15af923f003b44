//! What times are measured with: this machine's clock, and its graphics card.

use std::time::Instant;

use raystep_accel::{Mesh, Ray, Want};
use raystep_fast::{Bvh2, Elsewhere, Race, Row, Rung, Settings, Told};
use raystep_lesson::Stopwatch;
use raystep_paint::compute::{Gpu, Walker};

/// A clock that runs from now on.
pub(crate) struct Clock<'a> {
    begun: Instant,
    goes_on: &'a (dyn Fn() -> bool + Sync),
}

impl<'a> Clock<'a> {
    /// A clock for as long as somebody waits.
    pub(crate) fn new(goes_on: &'a (dyn Fn() -> bool + Sync)) -> Clock<'a> {
        Clock { begun: Instant::now(), goes_on }
    }
}

impl Stopwatch for Clock<'_> {
    fn seconds(&self) -> f64 {
        self.begun.elapsed().as_secs_f64()
    }

    fn goes_on(&self) -> bool {
        (self.goes_on)()
    }

    fn graphics_card(&self, race: &Race<'_>, mesh: &Mesh, rays: &[Ray]) -> Option<Result<Told, String>> {
        let clock = || self.seconds();
        graphics_card(race, mesh, rays, &clock).map(|(row, _)| row.told)
    }
}

/// The last rung: the same rays on the graphics card, judged on the CPU where single precision cannot decide; and what is
/// to be said of it. Without a card the row says why; nothing if it shall not go on.
pub(crate) fn graphics_card(
    race: &Race<'_>,
    mesh: &Mesh,
    rays: &[Ray],
    clock: &dyn Fn() -> f64,
) -> Option<(Row, Option<String>)> {
    let absent = |why: String| Some((Row { rung: Rung::Gpu, told: Err(why) }, None));
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
    let says = format!(
        "gpu: {}{kind}; {} of {} rays were walked on the CPU, since single precision could not decide",
        gpu.adapter, judged.on_cpu, judged.rays
    );
    let ask = |rays: &[Ray]| walker.nearest(rays).map(|(answers, _)| answers).map_err(|fault| fault.to_string());
    let tests_per_ray = tests / rays.len().max(1) as f64;
    let elsewhere = Elsewhere { ask: &ask, tests_per_ray, build_ms, bytes: walker.bytes() };
    Some((race.run_elsewhere(Rung::Gpu, &elsewhere)?, Some(says)))
}
