//! All that lies over the page.

use std::path::{Path, PathBuf};

use egui::Ui;
use raystep_figure::Theme;

use super::palette::Palette;
use super::{best, drop_hint, export, help, open, palette};
use crate::fault::Fault;
use crate::shown::Link;
use crate::shown::command::Command;
use crate::shown::state::State;
use crate::window::work::exporting::Wish;
use crate::window::work::judging::Judging;

/// The dialogs that are open.
#[derive(Default)]
pub(crate) struct Overlay {
    palette: Option<Palette>,
    /// The page of keys: of the study, or of what differs before a class.
    help: Option<bool>,
    best: bool,
    export: export::Dialog,
    open: Option<open::Form>,
}

/// What was asked for over the page.
pub(crate) enum Asked {
    /// A command.
    Command(Command),
    /// A slide, by its place.
    Slide(usize),
    /// A place, by a link.
    Link(Box<Link>),
    /// To choose a folder to write to.
    ChooseFolder,
    /// To write files.
    Write(Wish),
    /// To choose a mesh.
    ChooseMesh,
    /// To open a mesh.
    Mesh(PathBuf),
    /// Nobody looks at the measured structures any more.
    Judged,
}

impl Overlay {
    /// Whether a dialog has the keys.
    pub(crate) fn is_open(&self) -> bool {
        self.palette.is_some() || self.help.is_some() || self.best || self.export.is_open() || self.open.is_some()
    }

    /// Closes whatever is open.
    pub(crate) fn close(&mut self) {
        (self.palette, self.help, self.best, self.open) = (None, None, false, None);
        self.export.close();
    }

    /// Opens the palette.
    pub(crate) fn find(&mut self) {
        self.palette = Some(Palette::default());
    }

    /// Opens the page of keys, or closes it.
    pub(crate) fn help(&mut self, class: bool) {
        self.help = if self.help.is_some() { None } else { Some(class) };
    }

    /// Opens the page of all structures.
    pub(crate) fn best(&mut self) {
        self.best = true;
    }

    /// Opens the dialog that writes files.
    pub(crate) fn export(&mut self, state: &State, theme: &'static Theme) {
        self.export.open(state, theme);
    }

    /// Opens the dialog that opens a mesh.
    pub(crate) fn open(&mut self) {
        self.open = Some(open::Form::default());
    }

    /// A mesh was chosen for the dialog. Says whether that is open.
    pub(crate) fn chose_mesh(&mut self, path: &Path) -> bool {
        if let Some(form) = &mut self.open {
            form.choose(path);
        }
        self.open.is_some()
    }

    /// A folder was chosen to write to.
    pub(crate) fn chose_folder(&mut self, folder: &Path) {
        self.export.set_folder(folder);
    }

    /// What was to be written is being written, or cannot be: the dialog says why.
    pub(crate) fn wrote(&mut self, written: Result<(), Fault>) {
        match written {
            Err(fault) => self.export.refuse(&fault),
            Ok(()) => self.export.close(),
        }
    }

    /// Shows all of it; says what was asked for.
    pub(crate) fn show(&mut self, ui: &Ui, state: &State, judging: &Judging, theme: &Theme) -> Vec<Asked> {
        let mut asked = Vec::new();
        if let Some(palette) = &mut self.palette {
            let (close, chosen) = palette.show(ui, &state.library, theme);
            if close {
                self.palette = None;
            }
            asked.extend(chosen.map(|choice| match choice {
                palette::Choice::Command(command) => Asked::Command(command),
                palette::Choice::Slide(slide) => Asked::Slide(slide),
                palette::Choice::Link(link) => Asked::Link(link),
            }));
        }
        if self.help.as_mut().is_some_and(|class| help::page(ui, theme, class)) {
            self.help = None;
        }
        if self.best && best::page(ui, judging, theme) {
            self.best = false;
            asked.push(Asked::Judged);
        }
        match self.export.show(ui, state, theme) {
            Some(export::Asked::Folder) => asked.push(Asked::ChooseFolder),
            Some(export::Asked::Write(wish)) => asked.push(Asked::Write(wish)),
            Some(export::Asked::Close) => self.export.close(),
            None => {}
        }
        match self.open.as_mut().and_then(|form| form.show(ui, theme)) {
            Some(open::Asked::Choose) => asked.push(Asked::ChooseMesh),
            Some(open::Asked::Open(path)) => {
                self.open = None;
                asked.push(Asked::Mesh(path));
            }
            Some(open::Asked::Close) => self.open = None,
            None => {}
        }
        drop_hint::show(ui, theme);
        asked
    }
}
