//! How the window looks: its theme, and whether it fills the screen.

use egui::{Ui, ViewportCommand};
use raystep_accel::Place;
use raystep_figure::Theme;

use super::App;
use crate::window::look::remembered::Remembered;
use crate::window::look::visuals;

impl App {
    /// The theme of the page that is shown.
    pub(super) fn theme(&self) -> &'static Theme {
        self.themes[usize::from(self.state.present)]
    }

    /// Sets the theme of the page that is shown; each has its own.
    pub(super) fn set_theme(&mut self, theme: &'static Theme) {
        self.themes[usize::from(self.state.present)] = theme;
        let Remembered { theme: study, presenting, .. } = &mut self.remembered;
        theme.name.clone_into(if self.state.present { presenting } else { study });
    }

    /// The theme's colours and sizes for egui, when they are not set yet.
    pub(super) fn dress(&mut self, ui: &mut Ui) {
        if self.styled != Some(self.theme().name) {
            self.styled = Some(self.theme().name);
            let style = visuals::style(self.theme());
            for theme in [egui::Theme::Light, egui::Theme::Dark] {
                ui.ctx().set_style_of(theme, style.clone());
            }
            ui.set_style(style);
        }
    }

    /// The presenter's page fills the screen; the study is as large as it was.
    pub(super) fn fill_screen(&mut self, ui: &Ui) {
        match (self.state.present, self.presented) {
            (true, None) => {
                let full = ui.input(|input| input.viewport().fullscreen.unwrap_or(false));
                self.presented = Some(full);
                ui.ctx().send_viewport_cmd(ViewportCommand::Fullscreen(true));
            }
            (false, Some(full)) => {
                self.presented = None;
                ui.ctx().send_viewport_cmd(ViewportCommand::Fullscreen(full));
            }
            _ => {}
        }
    }

    /// What lights up: where the pointer is, else what was picked.
    pub(super) fn lit(&self) -> Option<Place> {
        self.kept.hovered().or(self.state.picked)
    }
}
