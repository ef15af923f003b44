//! The dialog that writes files: what, as which files, and where. It offers what `raystep export` offers.

mod form;
mod picked;
mod rows;

use std::path::Path;

use egui::{Key, RichText, ScrollArea, Ui, vec2};
use raystep_figure::{Face, Role, Theme};

use self::form::{Field, Form};
use crate::fault::Fault;
use crate::shown::state::State;
use crate::window::look::controls;
use crate::window::look::fonts::font;
use crate::window::look::visuals::ink;
use crate::window::work::exporting::Wish;

/// What was asked for in the dialog.
pub(super) enum Asked {
    /// To choose a folder.
    Folder,
    /// To write files.
    Write(Wish),
    /// To close it.
    Close,
}

/// The dialog, and what is filled in: it is found again as it was left.
#[derive(Default)]
pub(super) struct Dialog {
    form: Option<Form>,
    open: bool,
    /// Why it could not be done.
    wrong: Option<String>,
    /// In so many frames it still finds its size.
    settles: u8,
}

/// How wide it is where there is room, and how much of the window is left around what it holds.
const WIDTH: f32 = 800.0;
const AROUND: egui::Vec2 = vec2(76.0, 190.0);

impl Dialog {
    /// Opens it, with the choices of before as far as they can be made here.
    pub(super) fn open(&mut self, state: &State, theme: &'static Theme) {
        let form = self.form.take().unwrap_or_else(|| Form::new(theme));
        self.form = Some(form.fitting(state));
        self.wrong = None;
        self.open = true;
        self.settles = 3;
    }

    /// Whether it has the keys.
    pub(super) fn is_open(&self) -> bool {
        self.open
    }

    pub(super) fn close(&mut self) {
        self.open = false;
    }

    /// Another folder to write to.
    pub(super) fn set_folder(&mut self, folder: &Path) {
        if let Some(form) = &mut self.form {
            form.folder = folder.to_string_lossy().into_owned();
        }
    }

    /// Says why it could not be done, in the dialog that asked for it.
    pub(super) fn refuse(&mut self, fault: &Fault) {
        self.open = self.form.is_some();
        self.wrong = Some(sentence(&fault.to_string()));
    }

    /// Shows the dialog; says what was asked for.
    pub(super) fn show(&mut self, ui: &Ui, state: &State, theme: &Theme) -> Option<Asked> {
        let form = self.form.as_mut().filter(|_| self.open)?;
        form.keep_to(state);
        // Its rows wrap as its width says, which the first frame does not know.
        if self.settles > 0 {
            self.settles -= 1;
            ui.ctx().request_repaint();
        }
        let (mut asked, mut write, mut close) = (None, false, false);
        // Enter in a field writes; on a button it presses that.
        let typing = ui.ctx().text_edit_focused();
        let modal = controls::modal(ui, "export").show(ui.ctx(), |ui| {
            let room = ui.ctx().content_rect().size() - AROUND;
            ui.set_width(room.x.min(WIDTH));
            ui.label(RichText::new("Export").font(font(Face::Bold, 20.0)));
            ui.add_space(2.0);
            let area = ScrollArea::vertical().max_height(room.y).auto_shrink([false, true]);
            let folder = form.folder.clone();
            if area.show(ui, |ui| rows::show(ui, form, state)).inner {
                asked = Some(Asked::Folder);
            }
            ui.add_space(2.0);
            // What was refused was refused of that folder.
            if form.folder != folder {
                self.wrong = None;
            }
            let typed = Field::ALL.into_iter().find_map(|field| form.wrong(field));
            match typed.as_ref().or(self.wrong.as_ref()) {
                Some(wrong) => ui.label(RichText::new(wrong).color(ink(theme, Role::Wrong))),
                None => {
                    let hint = "The whole lecture: raystep export --all --beats --out FOLDER";
                    ui.label(RichText::new(hint).small().color(ink(theme, Role::Quiet)))
                }
            };
            ui.horizontal(|ui| {
                write = controls::main_button(ui, "Write").clicked();
                close = ui.button("Cancel").clicked();
            });
        });
        write |= typing && ui.input(|input| input.key_pressed(Key::Enter));
        if close || modal.should_close() {
            asked = Some(Asked::Close);
        }
        if write {
            match form.wish(state.view.step) {
                Ok(wish) => asked = Some(Asked::Write(wish)),
                Err(fault) => self.refuse(&fault),
            }
        }
        asked
    }
}

/// Words as a sentence of their own.
fn sentence(words: &str) -> String {
    let mut letters = words.trim_end_matches('.').chars();
    letters.next().map_or_else(String::new, |first| format!("{}{}.", first.to_uppercase(), letters.as_str()))
}
