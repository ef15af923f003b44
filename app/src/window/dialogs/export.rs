//! The dialog that writes files: what, as which files, and where. It offers what `raystep export` offers.

use std::path::{Path, PathBuf};

use clap::ValueEnum;
use egui::{ComboBox, DragValue, Grid, RichText, TextEdit, Ui};
use raystep_figure::{Face, Role, Theme};

use crate::export::{Format, Order, Size, View, Which as Steps};
use crate::fault::Fault;
use crate::shown::state::State;
use crate::window::look::controls;
use crate::window::look::fonts::font;
use crate::window::look::visuals::ink;
use crate::window::work::exporting::Wish;

/// What is filled in.
#[derive(Clone)]
pub(super) struct Form {
    which: Which,
    first: usize,
    last: usize,
    view: View,
    format: Format,
    size: String,
    theme: &'static Theme,
    folder: String,
    /// Why it could not be done.
    wrong: Option<String>,
}

/// What was asked for in the dialog.
pub(super) enum Asked {
    /// To choose a folder.
    Folder,
    /// To write files.
    Write(Wish),
    /// To close it.
    Close,
}

/// The steps to write.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Which {
    /// The step that is shown.
    This,
    /// Those of the slide's beats.
    Beats,
    /// From the first to the last one named.
    Steps,
}

impl Form {
    /// The usual choices.
    pub(super) fn of(state: &State, theme: &'static Theme) -> Form {
        let home = std::env::var_os("HOME").map(PathBuf::from).unwrap_or_default();
        Form {
            which: Which::This,
            first: 0,
            last: state.playback().map_or(0, |playback| playback.steps().last()),
            view: View::Plate,
            format: Format::Png,
            size: "1600x1000".to_owned(),
            theme,
            folder: home.join("raystep").to_string_lossy().into_owned(),
            wrong: None,
        }
    }

    /// Another folder to write to.
    pub(super) fn set_folder(&mut self, folder: &Path) {
        self.folder = folder.to_string_lossy().into_owned();
    }

    /// What the form says, at this step.
    fn wish(&self, step: usize) -> Result<Wish, Fault> {
        let size: Size = self.size.trim().parse().map_err(|wrong| Fault::new(format!("Size: {wrong}.")))?;
        if self.which == Which::Steps && self.first > self.last {
            return Err(Fault::new("Write the smaller step first."));
        }
        if self.folder.trim().is_empty() {
            return Err(Fault::new("Write the folder that the files shall go to."));
        }
        Ok(Wish {
            order: Order::new(self.view, self.format, size, self.theme),
            which: match self.which {
                Which::This => Steps::Steps(step..=step),
                Which::Beats => Steps::Beats,
                Which::Steps => Steps::Steps(self.first..=self.last),
            },
            all_rays: self.which == Which::Beats,
            folder: PathBuf::from(self.folder.trim()),
        })
    }

    /// Says why it could not be done.
    pub(super) fn refuse(&mut self, fault: &Fault) {
        self.wrong = Some(fault.to_string());
    }

    /// Shows the dialog; says what was asked for.
    pub(super) fn show(&mut self, ui: &Ui, state: &State, theme: &Theme) -> Option<Asked> {
        let (mut asked, mut write, mut close) = (None, false, false);
        let modal = controls::modal(ui, "export").show(ui.ctx(), |ui| {
            ui.set_width(520.0);
            ui.label(RichText::new("Export").font(font(Face::Bold, 20.0)));
            ui.add_space(6.0);
            if self.rows(ui, state) {
                asked = Some(Asked::Folder);
            }
            ui.add_space(6.0);
            match &self.wrong {
                Some(wrong) => ui.label(RichText::new(wrong).color(ink(theme, Role::Wrong))),
                None => {
                    let hint = "The whole lecture: raystep export --all --beats --out FOLDER";
                    ui.label(RichText::new(hint).small().color(ink(theme, Role::Quiet)))
                }
            };
            ui.horizontal(|ui| {
                write = ui.button("Write").clicked();
                close = ui.button("Cancel").clicked();
            });
        });
        if close || modal.should_close() {
            asked = Some(Asked::Close);
        }
        if write {
            match self.wish(state.view.step) {
                Ok(wish) => asked = Some(Asked::Write(wish)),
                Err(fault) => self.refuse(&fault),
            }
        }
        asked
    }

    /// The rows of the form; says whether a folder shall be chosen.
    fn rows(&mut self, ui: &mut Ui, state: &State) -> bool {
        let last = state.playback().map_or(0, |playback| playback.steps().last());
        let trees = state.playback().is_some_and(|playback| playback.play.structure.node_count() > 0);
        let mut choose = false;
        Grid::new("export").num_columns(2).spacing([18.0, 12.0]).show(ui, |ui| {
            ui.label("What");
            ui.horizontal(|ui| {
                ui.selectable_value(&mut self.which, Which::This, format!("this step ({})", state.view.step));
                ui.selectable_value(&mut self.which, Which::Beats, "all beats");
                ui.selectable_value(&mut self.which, Which::Steps, "steps");
                ui.add_enabled_ui(self.which == Which::Steps, |ui| {
                    let first = ui.add(DragValue::new(&mut self.first).range(0..=last));
                    first.widget_info(|| egui::WidgetInfo::labeled(egui::Role::SpinButton, true, "First step"));
                    ui.label("to");
                    let end = ui.add(DragValue::new(&mut self.last).range(0..=last));
                    end.widget_info(|| egui::WidgetInfo::labeled(egui::Role::SpinButton, true, "Last step"));
                });
            });
            ui.end_row();
            ui.label("Format");
            ui.horizontal(|ui| {
                for format in Format::value_variants() {
                    ui.selectable_value(&mut self.format, *format, format.ending().to_uppercase());
                }
            });
            ui.end_row();
            let drawn = self.format != Format::Json;
            ui.label("View");
            ui.add_enabled_ui(drawn, |ui| {
                ui.horizontal(|ui| {
                    ui.selectable_value(&mut self.view, View::Plate, "plate");
                    ui.selectable_value(&mut self.view, View::Space, "space");
                    let tree = ui.add_enabled_ui(trees, |ui| ui.selectable_value(&mut self.view, View::Tree, "tree"));
                    tree.inner.on_disabled_hover_text("This structure has no tree");
                });
            });
            ui.end_row();
            let size = ui.label("Size");
            ui.add_enabled_ui(drawn, |ui| {
                ui.horizontal(|ui| {
                    ui.add(TextEdit::singleline(&mut self.size).desired_width(104.0)).labelled_by(size.id);
                    for usual in ["1280x800", "1600x1000", "1920x1080", "3200x2000"] {
                        ui.selectable_value(&mut self.size, usual.to_owned(), usual.replace('x', "×"));
                    }
                });
            });
            ui.end_row();
            ui.label("Theme");
            ui.add_enabled_ui(drawn, |ui| {
                let combo = ComboBox::from_id_salt("export theme").selected_text(self.theme.name).show_ui(ui, |ui| {
                    for theme in Theme::ALL {
                        if ui.selectable_label(self.theme.name == theme.name, theme.name).clicked() {
                            self.theme = theme;
                        }
                    }
                });
                controls::name(&combo.response, "Theme");
            });
            ui.end_row();
            let label = ui.label("Folder");
            ui.horizontal(|ui| {
                ui.add(TextEdit::singleline(&mut self.folder).desired_width(300.0)).labelled_by(label.id);
                choose = ui.button("Choose").clicked();
            });
            ui.end_row();
        });
        choose
    }
}
