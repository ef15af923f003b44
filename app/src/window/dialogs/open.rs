//! The dialog that opens a mesh: its path can be typed where the desktop has no dialog of its own.

use std::path::PathBuf;

use egui::{Key, RichText, TextEdit, Ui};
use raystep_figure::{Face, Role};

use crate::window::app::App;
use crate::window::look::controls;
use crate::window::look::fonts::font;
use crate::window::look::visuals::ink;

/// What is filled in.
#[derive(Default)]
pub(crate) struct Form {
    path: String,
    /// Why it could not be opened.
    wrong: Option<String>,
    shown: bool,
}

impl Form {
    /// The mesh that a dialog of the desktop has chosen.
    pub(crate) fn choose(&mut self, path: &std::path::Path) {
        self.path = path.to_string_lossy().into_owned();
        self.wrong = None;
    }
}

impl App {
    /// Shows the dialog while it is open.
    pub(crate) fn open_dialog(&mut self, ui: &Ui) {
        let Some(mut form) = self.opening.take() else { return };
        let (mut open, mut close) = (false, false);
        let modal = controls::modal(ui, "open mesh").show(ui.ctx(), |ui| {
            ui.set_width(480.0);
            ui.label(RichText::new("Open a mesh").font(font(Face::Bold, 20.0)));
            ui.horizontal(|ui| {
                let label = ui.label("OBJ file");
                let field = TextEdit::singleline(&mut form.path).desired_width(300.0).hint_text("/folder/mesh.obj");
                let field = ui.add(field).labelled_by(label.id);
                if !std::mem::replace(&mut form.shown, true) {
                    field.request_focus();
                }
                open = field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
                if ui.button("Choose").clicked() {
                    self.errands.ask_for_mesh();
                }
            });
            if let Some(wrong) = &form.wrong {
                ui.label(RichText::new(wrong).color(ink(self.theme, Role::Wrong)));
            }
            let hint = "A file can also be dropped on the window.";
            ui.label(RichText::new(hint).small().color(ink(self.theme, Role::Quiet)));
            ui.horizontal(|ui| {
                open |= ui.button("Open").clicked();
                close = ui.button("Cancel").clicked();
            });
        });
        close |= modal.should_close();
        if open {
            let path = PathBuf::from(form.path.trim());
            if path.is_file() {
                self.open_mesh(path);
                return;
            }
            // The field has the focus again, to be mended.
            form.shown = false;
            form.wrong = Some(match form.path.trim() {
                "" => "Write the path of an OBJ file.".to_owned(),
                path => format!("{path}: there is no such file."),
            });
        }
        if !close {
            self.opening = Some(form);
        }
    }
}
