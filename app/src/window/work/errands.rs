//! What happens outside the window and beside its thread: dialogs, meshes being read, pictures being
//! written, lessons being saved.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};

use glam::Vec3;
use raystep_accel::{Ray, RayError};
use raystep_lesson::Library;
use raystep_scene::Scene;

use super::task::Task;
use super::watch::Watch;
use crate::fault::{Fault, about};
use crate::reading;
use crate::report;

/// What came back.
pub(crate) enum News {
    /// The user has chosen a mesh.
    Chosen(PathBuf),
    /// A mesh was read; a ray through its middle, and where it lies.
    Mesh(Arc<Scene>, Ray, PathBuf),
    /// Pictures were written: a sentence.
    Written(String),
    /// Pictures could not be written.
    Unwritten(Fault),
    /// A folder was chosen to write to.
    Folder(PathBuf),
    /// A picture for the clipboard.
    Copied(egui::ColorImage),
    /// The lessons have changed.
    Lessons(Box<Library>),
    /// Something went wrong: a sentence.
    Failed(String),
}

/// Everything that is under way.
pub(crate) struct Errands {
    context: egui::Context,
    sender: Sender<News>,
    news: Receiver<News>,
    tasks: Vec<Arc<Task>>,
    reading: Option<Arc<Task>>,
    watch: Option<Watch>,
}

impl Errands {
    pub(crate) fn new(context: egui::Context) -> Errands {
        let (sender, news) = channel();
        Errands { context, sender, news, tasks: Vec::new(), reading: None, watch: None }
    }

    /// What has come back since the last call.
    pub(crate) fn next(&mut self) -> Option<News> {
        self.news.try_recv().ok()
    }

    /// What is under way.
    pub(crate) fn tasks(&mut self) -> &[Arc<Task>] {
        self.tasks.retain(|task| task.is_underway());
        &self.tasks
    }

    /// Runs something in a thread of its own; what it returns comes back as news, unless it was stopped.
    pub(crate) fn run(&mut self, task: Arc<Task>, work: impl FnOnce(&Task) -> News + Send + 'static) {
        self.tasks.push(task.clone());
        self.beside(move || {
            let news = report::guarded(|| work(&task)).unwrap_or_else(News::Failed);
            let wanted = task.is_underway();
            task.finish();
            wanted.then_some(news)
        });
    }

    fn beside(&self, work: impl FnOnce() -> Option<News> + Send + 'static) {
        let (sender, context) = (self.sender.clone(), self.context.clone());
        std::thread::spawn(move || {
            if let Some(news) = work() {
                // The window may be gone; nobody waits then.
                let _ = sender.send(news);
            }
            context.request_repaint();
        });
    }

    /// Asks the user for a mesh.
    pub(crate) fn ask_for_mesh(&self) {
        self.beside(|| {
            let dialog = rfd::FileDialog::new().add_filter("Meshes", &["obj", "OBJ"]).set_title("Open a mesh");
            dialog.pick_file().map(News::Chosen)
        });
    }

    /// Asks the user for a folder to write to.
    pub(crate) fn ask_for_folder(&self) {
        self.beside(|| rfd::FileDialog::new().set_title("Export to").pick_folder().map(News::Folder));
    }

    /// Reads a mesh, in the place of any other that is being read.
    pub(crate) fn load(&mut self, path: PathBuf) {
        if let Some(other) = self.reading.take() {
            other.stop();
        }
        let name = path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
        let task = Task::new(format!("Reading {name}"), "%");
        self.reading = Some(task.clone());
        self.run(task, move |task| read(&path, &name, task));
    }

    /// Reads the lessons in a folder again whenever they have been saved, `only` those or beside the lecture.
    pub(crate) fn watch(&mut self, folder: &Path, only: bool) {
        let (sender, context) = (self.sender.clone(), self.context.clone());
        self.watch = Some(Watch::begin(folder, only, move |lessons| {
            let news = match lessons {
                Ok(library) => News::Lessons(Box::new(library)),
                Err(sentence) => News::Failed(sentence),
            };
            let _ = sender.send(news);
            context.request_repaint();
        }));
    }
}

fn read(path: &Path, name: &str, task: &Task) -> News {
    let bytes = match settled(path, task) {
        Ok(bytes) => bytes,
        Err(fault) => return News::Failed(format!("{fault}.")),
    };
    let mut progress = |part: f32| {
        task.reach((part * 100.0) as usize);
        !task.is_stopped()
    };
    match Scene::from_obj(&bytes, name, &mut progress) {
        Ok(scene) => match ray_through(&scene) {
            Ok(ray) => News::Mesh(Arc::new(scene), ray, path.to_path_buf()),
            Err(error) => News::Failed(format!("{name}: no ray can be shot at this mesh: {error}.")),
        },
        Err(error) => News::Failed(error.to_string()),
    }
}

/// The bytes of a file, once nobody writes it any more: what is still being copied is waited for.
fn settled(path: &Path, task: &Task) -> Result<Vec<u8>, Fault> {
    // A pipe or a device may never end, or never begin.
    if !path.is_file() {
        return Err(Fault::new(format!("{} cannot be read: it is no file", path.display())));
    }
    let look = || std::fs::metadata(path).ok().map(|known| (known.len(), known.modified().ok()));
    loop {
        let before = look();
        let bytes = reading::read(path, reading::MESH, &|| !task.is_stopped()).map_err(about(path))?;
        if look() == before || task.is_stopped() {
            return Ok(bytes);
        }
        std::thread::sleep(std::time::Duration::from_millis(200));
    }
}

/// A ray through the middle of a scene, from beside the eye.
fn ray_through(scene: &Scene) -> Result<Ray, RayError> {
    let bounds = scene.bounds();
    let away = (scene.view.eye - bounds.center()).normalize_or(Vec3::Z);
    let side = away.cross(scene.view.up).normalize_or(Vec3::X);
    let from = bounds.center() + (away * 0.4 + side).normalize() * bounds.extent().length() * 0.9;
    let along = bounds.center() - from;
    Ray::new(from, along.normalize_or(Vec3::X))
}
