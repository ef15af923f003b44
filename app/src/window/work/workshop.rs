//! Where structures are built and rays walk: small ones at once, large ones beside the UI thread.

use std::sync::Arc;

use raystep_accel::Primitives;
use raystep_lesson::{Library, Tape};
use raystep_paint::Mesh;
use raystep_scene::Scene;

use super::asked::plays_board;
use super::bench::{Bench, Broken};
use super::kept::{Kept, Stands};
use super::making::{Failure, Goal, Made, Order, SHORT, is_quick, make, measuring};
use super::task::Task;
use crate::shown::playback::Playback;
use crate::shown::view::View;

impl Broken for Option<Arc<Mesh>> {
    /// The sentence stands on the standard error; the marks alone are drawn.
    fn broken(_: String) -> Option<Arc<Mesh>> {
        None
    }
}

/// Makes walks of views.
pub(crate) struct Workshop {
    bench: Bench<Wanted, Result<Made, Failure>>,
    /// Where a scene that is shown already goes to another device.
    uploads: Bench<Arc<Scene>, Option<Arc<Mesh>>>,
    kept: Kept,
    device: Option<wgpu::Device>,
}

/// What is being made.
struct Wanted {
    view: View,
    /// Whether its structure stands already, so that only a ray walks.
    stands: bool,
    /// How far it is made.
    goal: Goal,
}

impl Workshop {
    pub(crate) fn new(context: egui::Context) -> Workshop {
        let (bench, uploads) = (Bench::new(context.clone()), Bench::new(context));
        Workshop { bench, uploads, kept: Kept::default(), device: None }
    }

    /// Uploads solid scenes to this device from now on, or to none. What was uploaded to another one is gone, and what
    /// is being made is asked for again.
    pub(crate) fn upload_to(&mut self, device: Option<wgpu::Device>) {
        self.bench.cancel();
        self.uploads.cancel();
        self.kept.lose_uploads();
        self.device = device;
    }

    /// Uploads a scene whose walk is there already.
    pub(crate) fn upload(&mut self, scene: &Arc<Scene>) {
        let Some(device) = self.device.clone().filter(|_| !scene.flat && !scene.prims.is_empty()) else { return };
        let (key, scene) = (scene.clone(), scene.clone());
        let quick = scene.prims.len() <= SHORT;
        let work = move |task: &Task| Mesh::new(&device, &scene.prims, &|| !task.is_stopped()).map(Arc::new);
        self.uploads.begin(key, Task::new("Uploading the scene", ""), quick, work);
    }

    /// The scene that was uploaded since the last call.
    pub(crate) fn uploaded(&mut self) -> Option<(Arc<Scene>, Arc<Mesh>)> {
        let (scene, mesh) = self.uploads.collect()?;
        let mesh = mesh?;
        self.kept.upload(&scene, &mesh);
        Some((scene, mesh))
    }

    /// Asks for the walk of a view. It may be there at once; else it arrives some frames later. What a board measures
    /// waits.
    pub(crate) fn ask(&mut self, view: &View, library: &Arc<Library>) {
        // What is being dragged waits for what was asked for before it to arrive: so it is seen to move.
        let busy = |wanted: &Wanted| {
            let held = wanted.view.same_but_held(view) && (wanted.stands || wanted.view.ray == view.ray);
            // A board whose meter is moved is measured coarsely for where it stood a moment ago.
            let metered = wanted.stands && wanted.goal == Goal::Shown;
            let held = held || metered && wanted.view.same_scene(view) && plays_board(view, library);
            wanted.view.same_walk(view) || held
        };
        if self.bench.wanted().is_some_and(busy) {
            return;
        }
        let stands = self.kept.fitting(view, library).cloned();
        let task = match stands {
            Some(_) => Task::new("Walking the ray", ""),
            None => Task::new("Building the structure", "references"),
        };
        self.begin(view, library, stands, Goal::Shown, task);
    }

    /// Asks for the next of what is left to be measured on a board that is shown.
    pub(crate) fn refine(&mut self, draft: &Playback, library: &Arc<Library>) {
        let Tape::Board(filled) = &draft.play.tape else { return };
        let busy = |wanted: &Wanted| wanted.goal == Goal::Further && wanted.view.same_walk(&draft.view);
        if self.bench.wanted().is_some_and(busy) {
            return;
        }
        let mesh = self.kept.over(&draft.view, library).and_then(|stands| stands.mesh.clone());
        let stands = Stands { built: draft.built(), mesh };
        self.begin(&draft.view, library, Some(stands), Goal::Further, measuring(filled));
    }

    fn begin(&mut self, view: &View, library: &Arc<Library>, stands: Option<Stands>, goal: Goal, task: Arc<Task>) {
        let wanted = Wanted { view: view.clone(), stands: stands.is_some(), goal };
        let scene = self.kept.over(view, library).cloned();
        let (view, library) = (view.clone(), library.clone());
        let order = Order { view, library, stands, scene, goal, device: self.device.clone() };
        let quick = is_quick(&order);
        self.bench.begin(wanted, task, quick, move |task| make(order, task));
    }

    /// What has arrived since the last call.
    pub(crate) fn collect(&mut self) -> Option<Result<Made, Failure>> {
        let (_, made) = self.bench.collect()?;
        if let Ok(made) = &made {
            self.kept.keep(Stands { built: made.playback.built(), mesh: made.mesh.clone() });
        }
        Some(made)
    }

    /// What is being made.
    pub(crate) fn task(&self) -> Option<&Arc<Task>> {
        self.bench.task()
    }

    /// Whether no thread is at work any more.
    pub(crate) fn is_idle(&self) -> bool {
        self.bench.is_idle() && self.uploads.is_idle()
    }

    /// Gives up what is being made. Returns whether there was anything.
    pub(crate) fn cancel(&mut self) -> bool {
        self.bench.cancel()
    }
}
