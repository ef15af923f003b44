//! What happens outside the window and beside its thread: dialogs, meshes being read, pictures being
//! written, lessons being saved.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};

use glam::Vec3;
use notify::{RecursiveMode, Watcher};
use raystep_accel::{Ray, RayError};
use raystep_lesson::Library;
use raystep_scene::Scene;

use super::task::Task;
use crate::reading;

/// What came back.
pub(crate) enum News {
    /// The user has chosen a mesh.
    Chosen(PathBuf),
    /// A mesh was read; a ray through its middle.
    Mesh(Arc<Scene>, Ray),
    /// Pictures were written, or a sentence why not.
    Written(String),
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
    watcher: Option<notify::RecommendedWatcher>,
}

impl Errands {
    pub(crate) fn new(context: egui::Context) -> Errands {
        let (sender, news) = channel();
        Errands { context, sender, news, tasks: Vec::new(), reading: None, watcher: None }
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
            let news = work(&task);
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

    /// Reads the lessons in a folder again whenever one is saved.
    pub(crate) fn watch(&mut self, folder: &Path) {
        let (sender, context, lessons) = (self.sender.clone(), self.context.clone(), folder.to_path_buf());
        let saved = move |event: notify::Result<notify::Event>| {
            let changed = event.is_ok_and(|event| !event.kind.is_access());
            if changed {
                let news = match Library::from_dir(&lessons) {
                    Ok(library) => News::Lessons(Box::new(library)),
                    Err(error) => News::Failed(format!("The lessons cannot be read: {error}.")),
                };
                let _ = sender.send(news);
                context.request_repaint();
            }
        };
        let watcher = notify::recommended_watcher(saved).and_then(|mut watcher| {
            watcher.watch(folder, RecursiveMode::Recursive)?;
            Ok(watcher)
        });
        match watcher {
            Ok(watcher) => self.watcher = Some(watcher),
            Err(error) => {
                let sentence = format!("Saved lessons will not be read again by themselves: {error}.");
                let _ = self.sender.send(News::Failed(sentence));
            }
        }
    }
}

fn read(path: &Path, name: &str, task: &Task) -> News {
    // A pipe or a device may never end, or never begin.
    if !path.is_file() {
        return News::Failed(format!("{name} cannot be read: it is no file."));
    }
    let bytes = match reading::read(path, reading::MESH, &|| !task.is_stopped()) {
        Ok(bytes) => bytes,
        Err(error) => return News::Failed(format!("{name} cannot be read: {error}.")),
    };
    let mut progress = |part: f32| {
        task.reach((part * 100.0) as usize);
        !task.is_stopped()
    };
    match Scene::from_obj(&bytes, name, &mut progress) {
        Ok(scene) => match ray_through(&scene) {
            Ok(ray) => News::Mesh(Arc::new(scene), ray),
            Err(error) => News::Failed(format!("No ray can be shot at this mesh: {error}.")),
        },
        Err(error) => News::Failed(error.to_string()),
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
