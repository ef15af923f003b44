//! The dialog that opens a mesh: its path can be typed where the desktop has no dialog of its own.

use std::path::{Path, PathBuf};

use egui::{Key, RichText, TextEdit, Ui};
use raystep_figure::{Face, Role, Theme};

use crate::window::look::controls;
use crate::window::look::fonts::font;
use crate::window::look::visuals::ink;

/// What was asked for in the dialog.
pub(super) enum Asked {
    /// To choose a file.
    Choose,
    /// To open this one.
    Open(PathBuf),
    /// To close it.
    Close,
}

/// What is filled in.
#[derive(Default)]
pub(super) struct Form {
    path: String,
    /// Why it could not be opened.
    wrong: Option<String>,
    shown: bool,
}

impl Form {
    /// The mesh that a dialog of the desktop has chosen.
    pub(super) fn choose(&mut self, path: &Path) {
        self.path = path.to_string_lossy().into_owned();
        self.wrong = None;
    }

    /// Shows the dialog; says what was asked for.
    pub(super) fn show(&mut self, ui: &Ui, theme: &Theme) -> Option<Asked> {
        let (mut asked, mut open, mut close) = (None, false, false);
        let modal = controls::modal(ui, "open mesh").show(ui.ctx(), |ui| {
            ui.set_width(480.0);
            ui.label(RichText::new("Open a mesh").font(font(Face::Bold, 20.0)));
            ui.horizontal(|ui| {
                let label = ui.label("OBJ file");
                let field = TextEdit::singleline(&mut self.path).desired_width(300.0).hint_text("/folder/mesh.obj");
                let field = ui.add(field).labelled_by(label.id);
                if !std::mem::replace(&mut self.shown, true) {
                    field.request_focus();
                }
                open = field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
                if ui.button("Choose").clicked() {
                    asked = Some(Asked::Choose);
                }
            });
            if let Some(wrong) = &self.wrong {
                ui.label(RichText::new(wrong).color(ink(theme, Role::Wrong)));
            }
            let hint = "A file can also be dropped on the window.";
            ui.label(RichText::new(hint).small().color(ink(theme, Role::Quiet)));
            ui.horizontal(|ui| {
                open |= ui.button("Open").clicked();
                close = ui.button("Cancel").clicked();
            });
        });
        if close || modal.should_close() {
            asked = Some(Asked::Close);
        }
        if open {
            let path = PathBuf::from(self.path.trim());
            if path.is_file() {
                return Some(Asked::Open(path));
            }
            // The field has the focus again, to be mended.
            self.shown = false;
            self.wrong = Some(match self.path.trim() {
                "" => "Write the path of an OBJ file.".to_owned(),
                path => {
                    let why = if Path::new(path).is_dir() { "it is a folder" } else { "there is no such file" };
                    format!("{}: {why}.", quoted(path))
                }
            });
        }
        asked
    }
}

/// A path as a sentence has room for it: of a long one its end.
fn quoted(path: &str) -> String {
    const MOST: usize = 120;
    match path.char_indices().nth_back(MOST) {
        Some((at, letter)) => format!("…{}", &path[at + letter.len_utf8()..]),
        None => path.to_owned(),
    }
}
