//! What comes back from outside is taken into the state.

use egui::{Align2, Id, LayerId, Order, StrokeKind, Ui};
use raystep_figure::{Face, Role};
use raystep_lesson::Library;

use super::app::App;
use super::errand::News;
use super::painter::caption;
use super::visuals::{fill, line};

impl App {
    /// While files are held over the window: what dropping them does.
    pub(super) fn drop_hint(&self, ui: &Ui) {
        if ui.input(|input| input.raw.hovered_files.is_empty()) {
            return;
        }
        let rect = ui.ctx().content_rect();
        let painter = ui.ctx().layer_painter(LayerId::new(Order::Foreground, Id::unique("drop hint")));
        painter.rect_filled(rect, 0.0, fill(self.theme, Role::Page).gamma_multiply(0.85));
        painter.rect_stroke(rect.shrink(14.0), 10.0, line(self.theme, Role::Here), StrokeKind::Inside);
        let says = "Drop an OBJ file: a ray walks through it";
        caption(&painter, rect.center(), Align2::CENTER_CENTER, says, Face::Medium, 22.0, Role::Text, self.theme);
    }

    /// Takes in what has come back, and files dropped on the window.
    pub(super) fn errands_done(&mut self, ui: &Ui) {
        let dropped = ui.input(|input| input.raw.dropped_files.clone());
        for file in dropped {
            let path = file.path().to_path_buf();
            match path.extension() {
                Some(ending) if ending.eq_ignore_ascii_case("obj") => self.open_mesh(path),
                _ => self.toasts.say(ui, "Only OBJ files can be opened."),
            }
        }
        while let Some(news) = self.errands.next() {
            match news {
                News::Chosen(path) => match &mut self.opening {
                    Some(form) => form.choose(&path),
                    None => self.open_mesh(path),
                },
                News::Mesh(scene, ray) => {
                    if !scene.note.is_empty() {
                        self.toasts.say(ui, scene.note.clone());
                    }
                    self.state.show_mesh(scene, ray);
                }
                News::Folder(folder) => {
                    if let Some(form) = &mut self.export {
                        form.set_folder(&folder);
                    }
                }
                News::Copied(image) => {
                    ui.ctx().copy_image(image);
                    self.toasts.say(ui, "The picture is on the clipboard.");
                }
                News::Lessons(library) => self.renew(ui, *library),
                News::Written(sentence) | News::Failed(sentence) => self.toasts.say(ui, sentence),
            }
        }
    }

    /// The lessons were saved: the same slide, as it is now.
    fn renew(&mut self, ui: &Ui, library: Library) {
        if let Some(problem) = library.problems.first() {
            self.toasts.say(ui, problem.to_string());
        }
        self.workshop.cancel();
        self.state.renew(library);
    }
}
