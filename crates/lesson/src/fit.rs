//! A volume that is fitted around everything, step by step.

use raystep_accel::{Axes, BvhVolume, Cancelled, Fit, Grow, Observer, Trace, fit_around};
use raystep_scene::Scene;

use crate::keys::Keys;
use crate::problem::misspelt;
use crate::reading::Reading;

/// How many events a tape keeps.
const MOST: usize = 200_000;

/// How a volume came to lie around all primitives of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct FitTape {
    /// Which volume it is.
    pub volume: BvhVolume,
    /// What happened.
    pub events: Vec<Fit>,
    /// How many events more there were.
    pub lost: u64,
}

impl FitTape {
    /// Fits a volume around everything in a scene.
    ///
    /// # Errors
    /// `watch` asked to give up.
    pub(crate) fn record(scene: &Scene, volume: BvhVolume, watch: &impl Observer<Grow>) -> Result<FitTape, Cancelled> {
        let axes = if scene.flat { Axes::Xy } else { Axes::Xyz };
        let mut recorder = Recorder { watch, tape: Trace::new(MOST) };
        fit_around(&scene.prims, volume, axes, &mut recorder)?;
        let Trace { events, lost, .. } = recorder.tape;
        Ok(FitTape { volume, events, lost })
    }
}

/// Keeps what happens, and gives up when a builder would.
struct Recorder<'a, W> {
    watch: &'a W,
    tape: Trace<Fit>,
}

impl<W: Observer<Grow>> Observer<Fit> for Recorder<'_, W> {
    fn on(&mut self, event: Fit) {
        self.tape.on(event);
    }

    fn cancelled(&self) -> bool {
        self.watch.cancelled()
    }
}

/// `volume = "sphere"`: what is fitted.
pub(crate) fn read(keys: &mut Keys<'_>, reading: &mut Reading<'_>) -> Option<BvhVolume> {
    if let Some(value) = keys.raw("structure") {
        let message = "a volume is fitted around everything, without a structure: write `volume = \"sphere\"` instead";
        reading.problem(value.span().start, message);
    }
    let (at, word) = keys.need::<String>("volume", reading)?;
    let known = BvhVolume::ALL.iter().find(|volume| volume.word() == word);
    if known.is_none() {
        reading.problem(at, misspelt("volume", &word, BvhVolume::WORDS));
    }
    known.copied()
}
