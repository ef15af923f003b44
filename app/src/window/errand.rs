//! What happens outside the window and beside its thread: dialogs, meshes being read, lessons being saved.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};

use notify::{RecursiveMode, Watcher};
use raystep_lesson::Library;
use raystep_scene::Scene;

/// What came back.
pub(super) enum News {
    /// The user has chosen a mesh.
    Chosen(PathBuf),
    /// A mesh was read.
    Mesh(Arc<Scene>),
    /// Pictures were written, or a sentence why not.
    Written(String),
    /// A folder was chosen to write to.
    Folder(PathBuf),
    /// The lessons have changed.
    Lessons(Box<Library>),
    /// Something went wrong: a sentence.
    Failed(String),
}

/// Everything that is under way.
pub(super) struct Errands {
    context: egui::Context,
    sender: Sender<News>,
    news: Receiver<News>,
    reading: Option<Arc<Reading>>,
    watcher: Option<notify::RecommendedWatcher>,
}

/// A mesh that is being read.
struct Reading {
    name: String,
    stop: AtomicBool,
    percent: AtomicU32,
    over: AtomicBool,
}

impl Errands {
    pub(super) fn new(context: egui::Context) -> Errands {
        let (sender, news) = channel();
        Errands { context, sender, news, reading: None, watcher: None }
    }

    /// What has come back since the last call.
    pub(super) fn next(&mut self) -> Option<News> {
        self.news.try_recv().ok()
    }

    /// What is under way, in words.
    pub(super) fn underway(&self) -> Option<String> {
        let reading = self.reading.as_ref().filter(|reading| !reading.over.load(Ordering::Relaxed))?;
        Some(format!("Reading {}: {} %", reading.name, reading.percent.load(Ordering::Relaxed)))
    }

    /// Gives up what is under way.
    pub(super) fn cancel(&mut self) {
        if let Some(reading) = self.reading.take() {
            reading.stop.store(true, Ordering::Relaxed);
        }
    }

    /// Runs something in a thread of its own; what it returns comes back as news.
    pub(super) fn beside(&self, work: impl FnOnce() -> Option<News> + Send + 'static) {
        let (sender, context) = (self.sender.clone(), self.context.clone());
        std::thread::spawn(move || {
            if let Some(news) = work() {
                // The window may be gone; nobody waits then.
                let _ = sender.send(news);
                context.request_repaint();
            }
        });
    }

    /// Asks the user for a mesh.
    pub(super) fn ask_for_mesh(&self) {
        self.beside(|| {
            let dialog = rfd::FileDialog::new().add_filter("Meshes", &["obj", "OBJ"]).set_title("Open a mesh");
            dialog.pick_file().map(News::Chosen)
        });
    }

    /// Asks the user for a folder to write to.
    pub(super) fn ask_for_folder(&self) {
        self.beside(|| rfd::FileDialog::new().set_title("Export to").pick_folder().map(News::Folder));
    }

    /// Reads a mesh.
    pub(super) fn load(&mut self, path: PathBuf) {
        self.cancel();
        let name = path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
        let reading = Arc::new(Reading {
            name,
            stop: AtomicBool::new(false),
            percent: AtomicU32::new(0),
            over: AtomicBool::new(false),
        });
        self.reading = Some(reading.clone());
        self.beside(move || {
            let news = read(&path, &reading);
            reading.over.store(true, Ordering::Relaxed);
            (!reading.stop.load(Ordering::Relaxed)).then_some(news)
        });
    }

    /// Reads the lessons in a folder again whenever one is saved.
    pub(super) fn watch(&mut self, folder: &Path) {
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

fn read(path: &Path, reading: &Reading) -> News {
    let bytes = match std::fs::read(path) {
        Ok(bytes) => bytes,
        Err(error) => return News::Failed(format!("{} cannot be read: {error}.", reading.name)),
    };
    let mut progress = |part: f32| {
        reading.percent.store((part * 100.0) as u32, Ordering::Relaxed);
        !reading.stop.load(Ordering::Relaxed)
    };
    match Scene::from_obj(&bytes, &reading.name, &mut progress) {
        Ok(scene) => News::Mesh(Arc::new(scene)),
        Err(error) => News::Failed(error.to_string()),
    }
}
