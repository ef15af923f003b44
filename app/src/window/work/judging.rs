//! Where all structures are built and measured, one after the other.

use std::sync::Arc;

use raystep_accel::Ray;
use raystep_scene::Scene;

use super::bench::{Bench, Broken};
use super::task::Task;
use crate::rating::{Candidate, Rated, Rating, rate};

/// What was measured so far.
pub(crate) struct Judged {
    /// Over what.
    pub(crate) scene: Arc<Scene>,
    rays: Arc<Vec<Ray>>,
    /// The structures that were measured.
    pub(crate) rated: Vec<Rated>,
    /// The same, ready to be drawn.
    pub(crate) rating: Arc<Rating>,
    /// Those that are still to be measured.
    left: Vec<Candidate>,
}

/// Builds and measures.
pub(crate) struct Judging {
    bench: Bench<Candidate, Result<Rated, ()>>,
    judged: Option<Judged>,
}

impl Broken for Result<Rated, ()> {
    /// The sentence stands on the standard error; this structure is left out.
    fn broken(_: String) -> Result<Rated, ()> {
        Err(())
    }
}

impl Judging {
    pub(crate) fn new(context: &egui::Context) -> Judging {
        Judging { bench: Bench::new(context.clone()), judged: None }
    }

    /// Measures all structures over a scene with these rays.
    pub(crate) fn begin(&mut self, scene: Arc<Scene>, rays: Vec<Ray>) {
        self.bench.cancel();
        let rating = Arc::new(Rating::of(&scene, &[], true));
        // The last one is taken first.
        let left = Candidate::all(&scene).into_iter().rev().collect();
        self.judged = Some(Judged { scene, rays: Arc::new(rays), rated: Vec::new(), rating, left });
    }

    /// Gives up, and forgets what was measured.
    pub(crate) fn end(&mut self) {
        self.bench.cancel();
        self.judged = None;
    }

    /// What was measured so far.
    pub(crate) fn shown(&self) -> Option<&Judged> {
        self.judged.as_ref()
    }

    /// What is being measured.
    pub(crate) fn underway(&self) -> Option<&Candidate> {
        self.bench.wanted()
    }

    /// Whether no thread is at work any more.
    pub(crate) fn is_idle(&self) -> bool {
        self.bench.is_idle()
    }

    /// Takes in what was measured, and begins with the next.
    pub(crate) fn catch_up(&mut self) {
        let made = self.bench.collect();
        let Some(judged) = &mut self.judged else { return };
        if let Some((_, Ok(rated))) = made {
            judged.rated.push(rated);
            judged.rating = Arc::new(Rating::of(&judged.scene, &judged.rated, true));
        }
        if self.bench.wanted().is_some() {
            return;
        }
        if let Some(what) = judged.left.pop() {
            let (scene, rays) = (judged.scene.clone(), judged.rays.clone());
            let task = Task::new("Measuring", "");
            let work = move |task: &Task| rate(&scene, what, &rays, &|| !task.is_stopped()).ok_or(());
            self.bench.begin(what, task, false, work);
        }
    }
}
