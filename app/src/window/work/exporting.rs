//! What the window shows, written to files or put on the clipboard by the code of the command line.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use raystep_accel::{Cancelled, Grow, Observer};
use raystep_figure::{Depth, Theme};
use raystep_lesson::{BoardTape, Care, Library, Tape};

use super::errands::{Errands, News};
use super::task::Task;
use crate::export::{self, Changes, Ground, Order, Session, View, Which, jobs, pictures, rays_of_beats};
use crate::fault::Fault;
use crate::shown::all_nodes::AllNodes;
use crate::shown::camera::Seen;
use crate::shown::playback::{Built, Playback};
use crate::shown::state::State;
use crate::shown::view::RayChoice;
use crate::window::look::formulas::decoded;

/// What shall be written, how, and where to.
pub(crate) struct Wish {
    /// How steps are drawn.
    pub(crate) order: Order,
    /// Which steps.
    pub(crate) which: Which,
    /// Whether each beat is drawn on the ray that it is told on.
    pub(crate) all_rays: bool,
    /// The folder of the files.
    pub(crate) folder: PathBuf,
}

/// What the window shows, for another thread.
pub(crate) struct Window {
    library: Arc<Library>,
    playback: Arc<Playback>,
    seen: Option<Seen>,
    depth: Option<Depth>,
}

impl Window {
    /// What is shown, as far as there is a walk; `aspect` is that of the picture in which the camera was moved.
    pub(crate) fn of(state: &State, aspect: f32) -> Result<Window, Fault> {
        // A cut that is only tried is not in the build, nor in pictures of it.
        let playback = state.made().cloned().ok_or_else(|| Fault::new("There is no walk yet."))?;
        let seen = state.view.camera.map(|camera| Seen { camera, aspect });
        Ok(Window { library: state.library.clone(), playback, seen, depth: state.view.depth })
    }

    /// The ground that its ray walks on.
    fn ground<'a>(&'a self, go_on: &'a (dyn Fn() -> bool + Sync)) -> Result<Ground<'a>, Fault> {
        let gone = || Fault::new("The slide is not there any more.");
        let view = &self.playback.view;
        let slide = self.library.slides.get(view.slide).ok_or_else(gone)?;
        let stage = slide.stage(view.stage).or(slide.stages.first()).ok_or_else(gone)?;
        let Built { scene, rule, structure, nodes, told, .. } = self.playback.built();
        let title = scene.title.clone();
        // Nobody writes down what is still to be measured with more rays.
        let told = match told {
            Some(Tape::Board(filled)) => {
                let filled = filled.filled(&scene, Care::Full, &mut GoesOn(go_on)).map(BoardTape::untold);
                Some(Tape::Board(filled.map_err(|Cancelled| Fault::new("the export was cancelled"))?))
            }
            other => other,
        };
        // What is drawn follows.
        let nodes = match &told {
            Some(Tape::Board(_)) => Arc::new(AllNodes::of(&structure, told.as_ref())),
            _ => nodes,
        };
        let built = raystep_lesson::Built { scene, structure, told };
        let changes = Changes {
            scene: view.is_elsewhere().then_some(title),
            settings: view.settings.clone(),
            seen: self.seen,
            depth: self.depth,
            own: view.own.as_ref().map(|own| own.scene.as_ref()),
            told: view.example.is_none(),
        };
        Ok(Ground::new(&self.library, slide, stage, built, rule, nodes, changes, go_on))
    }

    /// The walks to draw: that of its ray, or of all rays that the slide's beats are told on.
    fn sessions<'a>(&self, ground: &'a Ground<'a>, all: bool) -> Vec<Session<'a>> {
        match self.playback.view.ray {
            RayChoice::Own(ray) if self.playback.play.tape.ray().is_some() => Session::of_own_ray(ground, ray),
            RayChoice::Named(index) if !all => {
                Session::of_rays(ground, &ground.stage.rays.get(index).into_iter().collect::<Vec<_>>())
            }
            _ => Session::of_rays(ground, &rays_of_beats(ground.slide, ground.stage)),
        }
    }

    /// Writes files; says which.
    fn write(&self, wish: &Wish, task: &Task) -> Result<String, Fault> {
        let Wish { order, which, all_rays, folder } = wish;
        let waits = || !task.is_stopped();
        let ground = self.ground(&waits)?;
        let sessions = self.sessions(&ground, *all_rays);
        // A beat that is told on another ray is drawn where an own ray reaches it.
        let own = matches!(self.playback.view.ray, RayChoice::Own(_));
        let which = if own && matches!(which, Which::Beats) { &Which::ReachedBeats } else { which };
        let jobs = jobs(&sessions, which, order)?;
        task.expect(pictures(&jobs, order));
        let files = export::write(&jobs, order, folder, &|| {
            task.count();
            !task.is_stopped()
        })?;
        Ok(written(&files, folder))
    }
}

/// Asks the measuring of a board to give up.
struct GoesOn<'a>(&'a (dyn Fn() -> bool + Sync));

impl Observer<Grow> for GoesOn<'_> {
    fn on(&mut self, _: Grow) {}

    fn cancelled(&self) -> bool {
        !(self.0)()
    }
}

/// Writes files beside the UI thread.
pub(crate) fn write(errands: &mut Errands, window: Window, wish: Wish) {
    let task = Task::new(format!("Writing to {}", wish.folder.display()), "pictures");
    errands.run(task, move |task| match window.write(&wish, task) {
        Ok(sentence) => News::Written(sentence),
        Err(fault) => News::Unwritten(fault),
    });
}

/// Puts the picture of space on the clipboard, as it would be exported.
pub(crate) fn copy(
    errands: &mut Errands,
    window: Result<Window, Fault>,
    step: usize,
    size: glam::Vec2,
    theme: &'static Theme,
) {
    errands.run(Task::new("Drawing the picture", ""), move |task| {
        match window.and_then(|window| picture(&window, step, size, theme, task)) {
            Ok(image) => News::Copied(image),
            Err(fault) => News::Failed(fault.to_string()),
        }
    });
}

fn picture(
    window: &Window,
    step: usize,
    size: glam::Vec2,
    theme: &'static Theme,
    task: &Task,
) -> Result<egui::ColorImage, Fault> {
    let waits = || !task.is_stopped();
    let ground = window.ground(&waits)?;
    let sessions = window.sessions(&ground, false);
    let session = sessions.first().ok_or_else(|| Fault::new("There is no picture yet."))?;
    let size = size.clamp(glam::Vec2::splat(64.0), glam::Vec2::splat(4096.0));
    let (figure, scale) = session.figure(View::Space, step, None, size, theme)?;
    let png = raystep_print::png(&raystep_print::svg(&figure, theme), scale);
    let png = png.map_err(|error| Fault::new(error.to_string()))?;
    decoded(&png).ok_or_else(|| Fault::new("The picture cannot be made."))
}

/// Which files are there now.
fn written(files: &[String], folder: &Path) -> String {
    let folder = folder.display();
    match files {
        [] => format!("There was nothing to write to {folder}."),
        [only] => format!("{only} is in {folder}."),
        [first, second] => format!("{first} and {second} are in {folder}."),
        [first, .., last] => format!("{} files are in {folder}: {first} to {last}.", files.len()),
    }
}
