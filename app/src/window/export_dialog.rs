//! The dialog that writes pictures: what, as which files, and where.

use std::path::{Path, PathBuf};

use egui::{ComboBox, Id, Modal, RichText, TextEdit, Ui};
use raystep_figure::{Face, Figure, Role, Theme};

use super::app::App;
use super::controls;
use super::errand::News;
use super::eye;
use super::fonts::font;
use super::formulas::decoded;
use super::pictures::exported;
use super::playback::Playback;
use super::state::State;
use super::visuals::ink;

/// The width and height of an exported picture in points.
const SIZE: glam::Vec2 = glam::Vec2::new(1200.0, 900.0);

/// What is filled in.
pub(super) struct Form {
    folder: String,
    format: Format,
    which: Which,
    theme: &'static Theme,
}

/// The files to write.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Format {
    Svg,
    Png,
}

/// The steps to write.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Which {
    This,
    Beats,
    All,
}

impl Form {
    /// The usual choices.
    pub(super) fn of(state: &State, theme: &'static Theme) -> Form {
        let home = std::env::var_os("HOME").map(PathBuf::from).unwrap_or_default();
        let folder = home.join("raystep").to_string_lossy().into_owned();
        let which = if state.playback().is_some() { Which::This } else { Which::Beats };
        Form { folder, format: Format::Png, which, theme }
    }

    /// The folder that a dialog has chosen.
    pub(super) fn set_folder(&mut self, folder: &Path) {
        self.folder = folder.to_string_lossy().into_owned();
    }
}

impl App {
    /// Shows the dialog while it is open.
    pub(super) fn export_dialog(&mut self, ui: &Ui) {
        let Some(mut form) = self.export.take() else { return };
        let (mut write, mut close) = (false, false);
        let modal = Modal::new(Id::unique("export")).show(ui.ctx(), |ui| {
            ui.set_width(440.0);
            ui.label(RichText::new("Export").font(font(Face::Bold, 20.0)));
            let steps = self.state.playback().map_or(0, |playback| playback.steps().last());
            let names = [
                (Which::This, format!("this step ({})", self.state.view.step)),
                (Which::Beats, "the steps of the beats".to_owned()),
                (Which::All, format!("all {} steps", steps + 1)),
            ];
            ui.horizontal(|ui| {
                ui.label("Pictures of");
                let shown = names.iter().find(|(which, _)| *which == form.which).map_or("", |(_, name)| name);
                let combo = ComboBox::from_id_salt("which").selected_text(shown).width(200.0).show_ui(ui, |ui| {
                    for (which, name) in &names {
                        ui.selectable_value(&mut form.which, *which, name);
                    }
                });
                controls::name(&combo.response, "Pictures of");
            });
            ui.horizontal(|ui| {
                ui.label("as");
                ui.selectable_value(&mut form.format, Format::Png, "PNG");
                ui.selectable_value(&mut form.format, Format::Svg, "SVG");
                ui.add_space(12.0);
                for theme in Theme::ALL {
                    if ui.selectable_label(form.theme.name == theme.name, theme.name).clicked() {
                        form.theme = theme;
                    }
                }
            });
            ui.horizontal(|ui| {
                let label = ui.label("in the folder");
                let field = TextEdit::singleline(&mut form.folder).desired_width(230.0);
                ui.add(field).labelled_by(label.id);
                if ui.button("Choose").clicked() {
                    self.errands.ask_for_folder();
                }
            });
            ui.label(
                RichText::new("The whole lecture: raystep export --all --beats --out FOLDER")
                    .small()
                    .color(ink(self.theme, Role::Quiet)),
            );
            ui.horizontal(|ui| {
                write = ui.button("Write").clicked();
                close = ui.button("Cancel").clicked();
            });
        });
        close |= modal.should_close();
        if write {
            self.write(&form);
        }
        if !close && !write {
            self.export = Some(form);
        }
    }

    /// Writes the pictures beside the UI thread.
    fn write(&self, form: &Form) {
        let Some(playback) = self.state.playback().cloned() else { return };
        let steps = match form.which {
            Which::This => vec![self.state.view.step],
            Which::Beats => playback.play.beats.iter().flatten().copied().collect(),
            Which::All => (0..=playback.steps().last()).collect(),
        };
        let look = self.state.stage().and_then(|stage| stage.camera);
        let camera = self.state.view.camera;
        let name = self.state.slide().map_or_else(String::new, |slide| slide.name.clone());
        let (folder, format, theme) = (PathBuf::from(&form.folder), form.format, form.theme);
        self.errands.beside(move || {
            let written = steps.iter().try_fold(0, |count, &step| {
                let shown = playback.reel().still(&playback.instant(step)).space();
                let camera =
                    camera.unwrap_or_else(|| eye::home(look.as_ref(), &playback.play.scene, &shown.bounds, SIZE));
                let figure = exported(&shown, &playback, &camera, SIZE, theme);
                let file = folder.join(file_name(&name, step, &playback, format));
                save(&figure, theme, format, &file).map(|()| count + 1)
            });
            Some(News::Written(match written {
                Ok(1) => format!("One picture is in {}.", folder.display()),
                Ok(count) => format!("{count} pictures are in {}.", folder.display()),
                Err(error) => format!("The pictures cannot be written to {}: {error}.", folder.display()),
            }))
        });
    }

    /// Puts the picture of space on the clipboard, as it would be exported.
    pub(super) fn copy(&self, context: &egui::Context) -> Result<(), String> {
        let pictures = self.pictures.as_ref().ok_or("There is no picture yet.")?;
        let look = self.state.stage().and_then(|stage| stage.camera);
        let scene = &pictures.playback.play.scene;
        let home = || eye::home(look.as_ref(), scene, &pictures.space.bounds, SIZE);
        let camera = self.state.view.camera.unwrap_or_else(home);
        let figure = exported(&pictures.space, &pictures.playback, &camera, SIZE, self.theme);
        let bytes =
            raystep_print::png(&raystep_print::svg(&figure, self.theme), 1.0).map_err(|error| error.to_string())?;
        let image = decoded(&bytes).ok_or("The picture cannot be made.")?;
        context.copy_image(image);
        Ok(())
    }
}

/// `slide33-kd-walk-step0017of0143.png`
fn file_name(slide: &str, step: usize, playback: &Playback, format: Format) -> String {
    let last = playback.steps().last();
    let width = last.to_string().len().max(4);
    let ending = if format == Format::Svg { "svg" } else { "png" };
    format!("slide{slide}-space-step{step:0width$}of{last:0width$}.{ending}")
}

fn save(figure: &Figure, theme: &Theme, format: Format, file: &Path) -> Result<(), String> {
    if let Some(folder) = file.parent() {
        std::fs::create_dir_all(folder).map_err(|error| error.to_string())?;
    }
    let svg = raystep_print::svg(figure, theme);
    let bytes = match format {
        Format::Svg => svg.into_bytes(),
        Format::Png => raystep_print::png(&svg, 2.0).map_err(|error| error.to_string())?,
    };
    std::fs::write(file, bytes).map_err(|error| error.to_string())
}
