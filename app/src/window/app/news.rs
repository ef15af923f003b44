//! What is made beside the UI thread, and what comes back from there.

use std::path::{Path, PathBuf};

use egui::Ui;
use raystep_accel::Primitives;
use raystep_figure::counted;
use raystep_scene::Scene;

use super::App;
use crate::files;
use crate::window::work::errands::News;

impl App {
    /// Lets lessons in a folder be read again when they are saved, `only` those or beside the lecture.
    pub fn watch_lessons(&mut self, folder: &Path, only: bool) {
        self.lessons = Some(folder.to_path_buf());
        self.underway.errands.watch(folder, only);
    }

    /// Opens a mesh beside the UI thread.
    pub fn open_mesh(&mut self, path: PathBuf) {
        self.underway.errands.load(path);
    }

    /// Makes what the state asks for, as far as it is not there, and takes in what has come back.
    pub(super) fn catch_up(&mut self, ui: &Ui) {
        if let Some(wrong) = self.underway.catch_up(&mut self.state) {
            self.tell_unmade(wrong);
        }
        for file in ui.input(|input| input.raw.dropped_files.clone()) {
            let path = file.path().to_path_buf();
            match path.extension() {
                Some(ending) if ending.eq_ignore_ascii_case("obj") => self.open_mesh(path),
                _ => self.complain(format!("{} is not opened: a mesh is a file in OBJ.", path.display())),
            }
        }
        while let Some(news) = self.underway.errands.next() {
            self.learn(ui, news);
        }
        self.catch_up_beside(ui);
        self.underway.catch_up_heat(self.kept.heat.take_wish());
        self.underway.judging.catch_up();
    }

    pub(super) fn catch_up_beside(&mut self, ui: &Ui) {
        if let Some(wrong) = self.underway.catch_up_beside(&mut self.state) {
            self.say(ui, wrong);
        }
    }

    /// Takes in what has come back from outside.
    fn learn(&mut self, ui: &Ui, news: News) {
        match news {
            News::Chosen(path) => {
                if !self.overlay.chose_mesh(&path) {
                    self.open_mesh(path);
                }
            }
            News::Mesh(scene, ray, path) => {
                let wanted = self.reopens.take().filter(|link| link.mesh.as_ref().map(Path::new) == Some(&path));
                self.mesh = Some((scene.clone(), path));
                if !scene.note.is_empty() && (wanted.is_some() || self.state.shows_meshes()) {
                    self.say(ui, scene.note.clone());
                }
                self.first_mesh = false;
                match wanted {
                    Some(link) => _ = link.open(&mut self.state, Some(scene)),
                    None if self.state.shows_meshes() => self.state.show_mesh(scene, ray),
                    None => self.say(ui, kept_aside(&scene)),
                }
            }
            News::Folder(folder) => self.overlay.chose_folder(&folder),
            News::Copied(image) => {
                ui.ctx().copy_image(image);
                self.say(ui, "The picture is on the clipboard.");
            }
            News::Lessons(library) => {
                library.problems.iter().for_each(|problem| files::say(&problem.to_string()));
                self.tell_problems(&library);
                self.underway.renew();
                self.state.renew(*library);
            }
            News::Written(sentence) => self.say(ui, sentence),
            // A class sees no dialog.
            News::Unwritten(fault) if self.state.present => self.complain(format!("Nothing was written: {fault}.")),
            News::Unwritten(fault) => {
                files::say(&fault.to_string());
                self.overlay.wrote(Err(fault));
            }
            News::Failed(sentence) => {
                self.reopens = None;
                self.complain(sentence);
                self.give_up_first_mesh();
            }
        }
    }
}

/// What is said of a mesh that is opened over a slide which has scenes of its own.
fn kept_aside(mesh: &Scene) -> String {
    let triangles = counted(mesh.prims.len() as u64, "triangle", "triangles");
    let says = "is open. This slide keeps its own scenes: “Which structure is best?” measures yours.";
    format!("{}\n{}, {triangles}, {says}", mesh.note, mesh.title).trim_start().to_owned()
}
